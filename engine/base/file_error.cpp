#include "engine/base/file_error.h"

#include <fmt/format.h>

#include <cstring>

namespace netpocket {

FileError write_error(const std::string& name, const std::string& reason) {
  return FileError(fmt::format("cannot write \"{}\": {}", name, reason));
}

FileError write_error(const std::string& name, int error) { return write_error(name, std::strerror(error)); }

}  // namespace netpocket
