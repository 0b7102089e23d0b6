// Linked into the executable (see netpocket_use_rendering), where the dynamic linker looks first: so VTK and GLEW find
// these definitions instead of libGL's, and the library that draws can be chosen at run time. While no host has brought
// a library of its own, everything passes on to the next definition, libGL's.

#include <dlfcn.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "render/gl/gl_functions.h"
#include "render/gl/gl_lookup.h"

namespace {

void* resolve(const char* name) {
  const auto lookup = netpocket::gl_lookup();
  if (!lookup) netpocket::note_system_gl_in_use();
  void* function = lookup ? lookup(name) : dlsym(RTLD_NEXT, name);
  if (!function) {  // libGL is a load-time dependency and hosts are checked when they are chosen
    std::fprintf(stderr, "netpocket: the OpenGL library lacks the function %s\n", name);
    std::abort();
  }
  return function;
}

using Function = void (*)();

Function proc_address(const char* provider, const GLubyte* name) {
  const char* text = reinterpret_cast<const char*>(name);
  if (const auto lookup = netpocket::gl_lookup()) {
    // A host without an X server must not be handed the functions of one.
    if (std::strncmp(text, "glX", 3) == 0) return nullptr;
    return reinterpret_cast<Function>(lookup(text));
  }
  const auto system = reinterpret_cast<Function (*)(const GLubyte*)>(dlsym(RTLD_NEXT, provider));
  return system ? system(name) : nullptr;
}

}  // namespace

#define NETPOCKET_EXPORT extern "C" __attribute__((visibility("default")))

// Marks a program that carries the forwarders.
NETPOCKET_EXPORT void netpocket_gl_forwarders() {}

#define NETPOCKET_GL_FORWARD(result, name, parameters, arguments)                 \
  NETPOCKET_EXPORT result name parameters {                                       \
    static const auto next = reinterpret_cast<decltype(&(name))>(resolve(#name)); \
    return next arguments;                                                        \
  }
NETPOCKET_GL_FUNCTIONS(NETPOCKET_GL_FORWARD)

NETPOCKET_EXPORT Function glXGetProcAddress(const GLubyte* name) { return proc_address("glXGetProcAddress", name); }
NETPOCKET_EXPORT Function glXGetProcAddressARB(const GLubyte* name) {
  return proc_address("glXGetProcAddressARB", name);
}

// GLEW loads every OpenGL function and then reports failure because it finds no X server (3: no GLX, 4: no display).
NETPOCKET_EXPORT GLenum glewInit() {
  constexpr GLenum kNoGlx = 3, kNoGlxDisplay = 4;
  static const auto system = reinterpret_cast<GLenum (*)()>(dlsym(RTLD_NEXT, "glewInit"));
  const GLenum error = system();
  return error == kNoGlx || error == kNoGlxDisplay ? 0 : error;
}
