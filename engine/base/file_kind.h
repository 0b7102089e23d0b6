#pragma once
// The kinds of files that this program writes, recognised by the ends of their names and the beginnings of their
// contents. Any thread may call these functions.

#include <string>
#include <string_view>

namespace netpocket {

enum class FileKind {
  recording,
  png,
  svg,
  pdf,
  video,
  gltf,
  html,
  csv,
  vtp,
  pvd,
  view,
  markdown,
  json,
  log,
  stl,
  obj,
  scenario,
  findings,
  vtkhdf
};

// With its article, e.g. "a PNG picture".
std::string_view description(FileKind kind);
// With the dot, e.g. ".png".
std::string_view suffix(FileKind kind);

// Number of bytes at the beginning of a file that the functions below need as `content`.
inline constexpr std::size_t kContentBytes = 4096;

// Whether a file that begins with `content` may be replaced by a file of this kind: it is of this kind, empty or blank.
bool may_replace(FileKind kind, std::string_view content);

// Describes a file that begins with `content` as precisely as it can be told, e.g. "an HDF5 file, such as a recording"
// or "a file of another kind".
std::string_view content_description(std::string_view content);

// As content_description(), but empty unless the content has a mark that no scenario or study has.
std::string_view marked_description(std::string_view content);

// Whether the file exists and begins like a recording.
bool is_recording_file(const std::string& path);

// Whether the suffix of the name belongs to another format than this kind. False if the suffix is unknown.
bool names_another_format(FileKind kind, const std::string& path);

}  // namespace netpocket
