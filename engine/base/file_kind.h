#pragma once
// The kinds of files that this program writes: how their names end and how their content begins.

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
  findings
};

// "a PNG picture".
std::string_view description(FileKind kind);
// ".png"
std::string_view suffix(FileKind kind);

// Bytes at the beginning of a file that are enough for the functions below.
inline constexpr std::size_t kContentBytes = 4096;

// Whether what begins so may be replaced by a file of the kind: it is one, empty or blank.
bool may_replace(FileKind kind, std::string_view content);

// What a file that begins so is, as far as it can be told: "an HDF5 file", "a text file", "another kind of file".
std::string_view content_description(std::string_view content);

// As content_description(), where the content has a mark that no scenario or study has; else empty.
std::string_view marked_description(std::string_view content);

// Whether the file is there and begins like a recording.
bool is_recording_file(const std::string& path);

// Whether the name's suffix is that of a format other than the kind. A suffix that no known format has says nothing.
bool names_another_format(FileKind kind, const std::string& path);

}  // namespace netpocket
