#pragma once
// What goes wrong with files: one sentence that names the file as the user named it.

#include <stdexcept>
#include <string>

namespace netpocket {

// A file or folder that cannot be read or written.
class FileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// An output that would destroy what it does not replace: another kind of file, an input, another output.
class OutputRefused : public FileError {
 public:
  using FileError::FileError;
};

// "cannot write "NAME": REASON", also with the system's reason (errno).
FileError write_error(const std::string& name, const std::string& reason);
FileError write_error(const std::string& name, int error);

}  // namespace netpocket
