#pragma once
// Where an output really goes: links followed, what stands there looked at. Every writer of this program asks here
// before it creates anything. Any thread may call these functions.

#include <sys/stat.h>

#include <optional>
#include <string>

#include "engine/base/file_error.h"
#include "engine/base/file_kind.h"

namespace netpocket {

struct Destination {
  std::string name;                     // as the user wrote it, for messages
  std::string path;                     // of the file itself: no link
  std::string folder;                   // that holds it; never empty
  std::optional<struct stat> existing;  // what will be replaced, if anything
};

enum class ReadOnlyFiles { refused, replaced };

// Throws FileError where no regular file can be made: a missing folder, no permission, a folder, pipe or device, a loop
// of links, too long a name, a file without permission to write. Throws OutputRefused where a file of another kind
// stands, which the output would destroy.
Destination find_destination(const std::string& path, FileKind kind, ReadOnlyFiles read_only = ReadOnlyFiles::refused);

// The file that a path leads to, with its folder's links followed; equal for two names of one place, also where nothing
// stands yet.
struct Place {
  dev_t device = 0;
  ino_t folder = 0;
  std::string name;
  bool operator==(const Place&) const = default;
};
Place place_of(const Destination& destination);

// Gives a new file the permissions, and where it may the owner, of the file that it will replace.
void keep_permissions(int descriptor, const Destination& destination);

bool is_read_only(const Destination& destination);

// Throws FileError when a file or folder is there that cannot be read, or a path that cannot be followed. What is
// missing is no such error: whoever reads it says so.
void require_readable(const std::string& path);

bool is_same_file(const struct stat& a, const struct stat& b);

}  // namespace netpocket
