// SPDX-License-Identifier: Apache-2.0
#pragma once
// Between the program and the image module's shared object only.

#include "core/base/temporaries.h"
#include "core/image/image_module.h"

namespace burin::image {

/// Makes the one ImageModule; the module registers its temporary files in the program's registry.
using ImageModuleFactory = ImageModule* (*)(base::TemporaryRegistry*);
inline constexpr const char* kImageModuleFactory = "BurinImageModule";

}  // namespace burin::image
