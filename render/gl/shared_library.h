#pragma once
// A library loaded at run time, so that the program starts without it and can say that it is missing.

#include <string>

namespace netpocket {

class SharedLibrary {
 public:
  // Loads `file` without making its symbols visible to other libraries, and keeps it loaded for the life of the
  // process: OpenGL drivers do not survive being unloaded. Throws RenderError with the loader's reason.
  explicit SharedLibrary(const std::string& file);

  // Throws RenderError when the library has no such function.
  template <typename Function>
  Function function(const char* name) const {
    return reinterpret_cast<Function>(symbol(name));
  }

 private:
  void* symbol(const char* name) const;

  std::string file_;
  void* handle_;
};

}  // namespace netpocket
