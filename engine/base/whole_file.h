#pragma once
// A file that is written under a temporary name beside its place and gets its own when it is whole: what is interrupted
// or does not fit leaves an older file as it was, and nothing half. Errors: FileError and OutputRefused, see
// destination.h. Thread contract: one thread at a time per object.

#include <string>
#include <string_view>

#include "engine/base/destination.h"

namespace netpocket {

class WholeFile {
 public:
  // Creates the temporary file, with the permissions of the file that it will replace.
  WholeFile(const std::string& path, FileKind kind);
  ~WholeFile();  // removes the temporary file unless committed
  WholeFile(const WholeFile&) = delete;
  WholeFile& operator=(const WholeFile&) = delete;

  const std::string& path() const { return destination_.name; }  // as it was named
  // For programs that write it themselves; its name is short and has no suffix.
  const std::string& temporary_path() const { return temporary_path_; }
  void write(std::string_view bytes);
  // Puts the file in its place, replacing an older one. What matters (all but the many files of a series) is on the
  // disk before.
  void commit();

 private:
  Destination destination_;
  FileKind kind_;
  std::string temporary_path_;
  int descriptor_ = -1;
  bool committed_ = false;
};

// All of it at once.
void write_whole_file(const std::string& path, FileKind kind, std::string_view bytes);

}  // namespace netpocket
