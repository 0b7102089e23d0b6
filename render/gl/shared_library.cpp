#include "render/gl/shared_library.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include "render/render_error.h"

namespace netpocket {

SharedLibrary::SharedLibrary(const std::string& file)
    : file_(file), handle_(dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE)) {
  if (!handle_) throw RenderError(fmt::format("cannot load the OpenGL library: {}", dlerror()));
}

void* SharedLibrary::symbol(const char* name) const {
  void* address = dlsym(handle_, name);
  if (!address) throw RenderError(fmt::format("{} lacks the function {}", file_, name));
  return address;
}

}  // namespace netpocket
