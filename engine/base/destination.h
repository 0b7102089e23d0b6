#pragma once
// Finds the file to which an output really goes: follows links and checks the file that exists there. Every writer of
// this program calls find_destination before it creates anything. Any thread may call these functions.

#include <sys/stat.h>

#include <optional>
#include <string>

#include "engine/base/file_error.h"
#include "engine/base/file_kind.h"

namespace netpocket {

struct Destination {
  std::string name;                     // as the user wrote it, for messages
  std::string path;                     // of the file itself, with links followed
  std::string folder;                   // that holds the file; never empty
  std::optional<struct stat> existing;  // status of the file that will be replaced, if there is one
};

enum class ReadOnlyFiles { refused, replaced };

// Finds the destination of an output of this kind. Creates nothing.
// Throws FileError if no regular file can be made there: missing folder, no permission, a folder, pipe or device, a
// loop of links, too long a name, a file without permission to write. Throws OutputRefused if a file of another kind
// exists there, which the output would destroy.
Destination find_destination(const std::string& path, FileKind kind, ReadOnlyFiles read_only = ReadOnlyFiles::refused);

// Identity of the file that a path leads to. It is equal for two names of the same file, even if that does not exist
// yet. place_of throws FileError if the folder cannot be examined.
struct Place {
  dev_t device = 0;
  ino_t folder = 0;
  std::string name;
  bool operator==(const Place&) const = default;
};
Place place_of(const Destination& destination);

// Gives a new file the permissions of the file that it will replace and, where the system permits it, its owner.
void keep_permissions(int descriptor, const Destination& destination);

bool is_read_only(const Destination& destination);

// Throws FileError if a file or folder exists but cannot be read, or if the path cannot be followed. A missing file is
// no error here: the function that reads it reports it.
void require_readable(const std::string& path);

bool is_same_file(const struct stat& a, const struct stat& b);

}  // namespace netpocket
