// SPDX-License-Identifier: Apache-2.0
#include <mutex>

#include "core/base/module.h"
#include "core/base/temporaries.h"
#include "core/video/module_factory.h"
#include "core/video/video_module.h"

namespace burin::video {

Result<VideoModule*> LoadVideoModule() {
  static std::mutex mutex;
  static VideoModule* loaded = nullptr;  // never freed: the shared object stays until the process ends
  const std::lock_guard lock(mutex);
  if (loaded == nullptr) {
    const Result<void*> function = base::LoadModuleFunction("burin_video_module", kVideoModuleFactory);
    if (!function) return std::unexpected(function.error());
    loaded = reinterpret_cast<VideoModuleFactory>(*function)(&base::Temporaries());
  }
  return loaded;
}

}  // namespace burin::video
