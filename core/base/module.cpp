// SPDX-License-Identifier: Apache-2.0
#include "core/base/module.h"

#include <dlfcn.h>
#include <fmt/format.h>
#include <unistd.h>

#include <vector>

#include "core/base/program_paths.h"

namespace burin::base {
namespace {

std::string LinkerError() {
  const char* text = dlerror();
  return text != nullptr ? text : "unknown dynamic linker error";
}

}  // namespace

Result<void*> LoadModuleFunction(const std::string& name, const char* factory) {
  std::string tried;
  for (const std::string& folder : ModuleFolders()) {
    const std::string path = fmt::format("{}/{}.so", folder, name);
    if (access(path.c_str(), F_OK) != 0) {
      tried += fmt::format("\n  {}: no such file", path);
      continue;
    }
    // RTLD_LAZY: binding every symbol of the 250 libraries behind a module now would cost some 30 ms more.
    void* module = dlopen(path.c_str(), RTLD_LAZY | RTLD_LOCAL);
    if (module == nullptr) {
      tried += fmt::format("\n  {}", LinkerError());
      continue;
    }
    if (void* function = dlsym(module, factory); function != nullptr) return function;
    tried += fmt::format("\n  {}", LinkerError());
  }
  return Fail(ErrorKind::kFailed,
              fmt::format("cannot load the module '{}' (set BURIN_MODULE_PATH to its folder); tried:{}", name,
                          tried.empty() ? " no folder at all" : tried));
}

}  // namespace burin::base
