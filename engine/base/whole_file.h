#pragma once
// A file that is written completely or not at all. It is written under a temporary name in the folder of its
// destination and renamed when it is complete. If writing is interrupted or the disk is full, an older file stays
// unchanged and no partial file takes its place. The functions throw FileError and OutputRefused (destination.h).
// Thread contract: one thread at a time per object.

#include <string>
#include <string_view>

#include "engine/base/destination.h"

namespace netpocket {

class WholeFile {
 public:
  // Creates the temporary file with the permissions of the file that it will replace.
  WholeFile(const std::string& path, FileKind kind);
  ~WholeFile();  // removes the temporary file unless committed
  WholeFile(const WholeFile&) = delete;
  WholeFile& operator=(const WholeFile&) = delete;

  const std::string& path() const { return destination_.name; }  // as the user named it
  // For libraries that write the file themselves. The name is short and has no suffix of a format.
  const std::string& temporary_path() const { return temporary_path_; }
  void write(std::string_view bytes);
  // Moves the file to its destination, replacing an older one. The content is first synchronised with the disk, except
  // for kinds that are written in series (PNG pictures, VTK meshes).
  void commit();

 private:
  Destination destination_;
  FileKind kind_;
  std::string temporary_path_;
  int descriptor_ = -1;
  bool committed_ = false;
};

// Writes and commits a whole file at once.
void write_whole_file(const std::string& path, FileKind kind, std::string_view bytes);

}  // namespace netpocket
