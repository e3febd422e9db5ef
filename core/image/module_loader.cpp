// SPDX-License-Identifier: Apache-2.0
#include <mutex>

#include "core/base/module.h"
#include "core/base/temporaries.h"
#include "core/image/image_module.h"
#include "core/image/module_factory.h"

namespace burin::image {

Result<ImageModule*> LoadImageModule() {
  static std::mutex mutex;
  static ImageModule* loaded = nullptr;  // never freed: the shared object stays until the process ends
  const std::lock_guard lock(mutex);
  if (loaded == nullptr) {
    const Result<void*> function = base::LoadModuleFunction("burin_image_module", kImageModuleFactory);
    if (!function) return std::unexpected(function.error());
    loaded = reinterpret_cast<ImageModuleFactory>(*function)(&base::Temporaries());
  }
  return loaded;
}

}  // namespace burin::image
