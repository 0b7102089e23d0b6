#pragma once
// Errors of files. The message is one sentence that names the file as the user named it.

#include <stdexcept>
#include <string>

namespace netpocket {

// A file or folder that cannot be read or written.
class FileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// An output that would destroy a file which it must not replace: a file of another kind, an input, another output.
class OutputRefused : public FileError {
 public:
  using FileError::FileError;
};

// An error with the message "cannot write "NAME": REASON". The second form takes the reason from `error` (errno).
FileError write_error(const std::string& name, const std::string& reason);
FileError write_error(const std::string& name, int error);

}  // namespace netpocket
