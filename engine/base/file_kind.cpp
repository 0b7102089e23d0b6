#include "engine/base/file_kind.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <fstream>

namespace netpocket {
namespace {

using Content = std::string_view;

bool begins(Content content, std::string_view mark) { return content.substr(0, mark.size()) == mark; }

bool contains(Content content, std::string_view mark) { return content.find(mark) != content.npos; }

// The content without leading byte order mark and white space.
Content trimmed(Content content) {
  if (begins(content, "\xEF\xBB\xBF")) content.remove_prefix(3);
  content.remove_prefix(std::min(content.find_first_not_of(" \t\r\n"), content.size()));
  return content;
}

// Text contains no control characters except those that lay it out.
bool is_text(Content content) {
  return std::none_of(content.begin(), content.end(), [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte < 0x20 && std::string_view("\t\n\v\f\r").find(c) == std::string_view::npos;
  });
}

bool is_hdf5(Content content) { return begins(content, "\x89HDF\r\n\x1a\n"); }
// The name of the only group that such a file must have; it is in the file's first links.
bool is_vtkhdf(Content content) { return is_hdf5(content) && contains(content, "VTKHDF"); }
bool is_recording(Content content) { return is_hdf5(content) && !is_vtkhdf(content); }
bool is_png(Content content) { return begins(content, "\x89PNG\r\n\x1a\n"); }
bool is_pdf(Content content) { return begins(content, "%PDF"); }
bool is_video(Content content) { return content.substr(std::min<std::size_t>(4, content.size()), 4) == "ftyp"; }
bool is_gltf(Content content) { return begins(content, "glTF"); }
bool is_xml(Content content) { return begins(trimmed(content), "<?xml"); }
bool is_svg(Content content) {
  return begins(trimmed(content), "<svg") || (is_xml(content) && contains(content, "<svg"));
}
bool is_vtk(Content content) {
  return begins(trimmed(content), "<VTKFile") || (is_xml(content) && contains(content, "<VTKFile"));
}

bool is_html(Content content) {
  std::string start(trimmed(content).substr(0, 9));
  std::transform(start.begin(), start.end(), start.begin(), [](unsigned char c) { return std::tolower(c); });
  return start == "<!doctype" || begins(start, "<html");
}

// Whether there is a line `key = ...`, as in TOML.
bool has_key(Content content, std::string_view key) {
  for (std::size_t at = content.find(key); at != content.npos; at = content.find(key, at + 1)) {
    const bool starts_line = at == 0 || content[at - 1] == '\n';
    const Content rest = content.substr(at + key.size());
    if (starts_line && begins(rest.substr(std::min(rest.find_first_not_of(" \t"), rest.size())), "=")) return true;
  }
  return false;
}

// Whether there is a line `[name]`, as in TOML. A Markdown link has more text after the bracket.
bool has_table(Content content) {
  for (std::size_t at = 0; at != content.npos && at < content.size();) {
    const std::size_t end = std::min(content.find('\n', at), content.size());
    const Content line = content.substr(at, end - at);
    const std::size_t bracket = line.find(']');
    if (begins(line, "[") && bracket != line.npos) {
      const Content rest = trimmed(line.substr(bracket + 1));
      if (rest.empty() || rest.front() == ']' || rest.front() == '#') return true;
    }
    at = end + 1;
  }
  return false;
}
bool is_view(Content content) { return is_text(content) && has_key(content, "focal_point") && !has_table(content); }
bool is_scenario(Content content) { return is_text(content) && has_table(content) && contains(content, "="); }

// Whether the text may be TOML: its first line that is neither blank nor a comment is a table or a key. A scenario need
// not have a table.
bool may_be_toml(Content content) {
  if (!is_text(content)) return false;
  while (begins(trimmed(content), "#")) {
    content = trimmed(content);
    content.remove_prefix(std::min(content.find('\n'), content.size()));
  }
  const Content line = trimmed(content).substr(0, trimmed(content).find('\n'));
  return line.empty() || begins(line, "[") || (contains(line, "=") && !begins(line, "<"));
}
bool is_own_scenario(Content content) { return may_be_toml(content) && !is_view(content); }

bool is_findings(Content content) { return is_text(content) && begins(content, "F1 "); }

// Reports of studies begin with a heading. Scenarios often begin with a comment that looks like one.
bool is_markdown(Content content) { return is_text(content) && begins(trimmed(content), "#") && !is_scenario(content); }

// Any text except files that are certainly something else. Tables have no mark of their own, and records of studies may
// be truncated.
bool is_data(Content content) {
  return is_text(content) && !is_scenario(content) && !is_xml(content) && !is_pdf(content);
}

// The first line of a log is like "2026-01-31 10:11:12 netpocket 0.1.0"; see gui/commands/run_log.
bool is_log(Content content) {
  constexpr std::string_view kPattern = "dddd-dd-dd dd:dd:dd netpocket ";
  if (content.size() < kPattern.size()) return false;
  return std::equal(kPattern.begin(), kPattern.end(), content.begin(), [](char pattern, char c) {
    return pattern == 'd' && std::isdigit(static_cast<unsigned char>(c)) != 0 ? true : pattern == c;
  });
}

// Binary STL has no mark, so only the header that this program writes is recognised (engine/bodies/mesh_output).
bool is_stl(Content content) {
  return begins(content, "netpocket   ") || (begins(trimmed(content), "solid") && contains(content, "facet"));
}

bool is_obj(Content content) {
  return is_text(content) && (begins(content, "v ") || contains(content, "\nv ")) && !is_scenario(content);
}

struct Kind {
  FileKind kind;
  std::string_view description;
  std::string_view suffix;
  bool (*is_it)(Content);
};

constexpr std::array kKinds = {
    Kind{FileKind::recording, "a recording", ".h5", is_recording},
    Kind{FileKind::png, "a PNG picture", ".png", is_png},
    Kind{FileKind::svg, "an SVG picture", ".svg", is_svg},
    Kind{FileKind::pdf, "a PDF document", ".pdf", is_pdf},
    Kind{FileKind::video, "an MP4 video", ".mp4", is_video},
    Kind{FileKind::gltf, "a binary glTF scene", ".glb", is_gltf},
    Kind{FileKind::html, "an HTML page", ".html", is_html},
    Kind{FileKind::csv, "a CSV table", ".csv", is_data},
    Kind{FileKind::vtp, "a VTK mesh", ".vtp", is_vtk},
    Kind{FileKind::pvd, "a ParaView series", ".pvd", is_vtk},
    Kind{FileKind::vtkhdf, "a VTKHDF series", ".vtkhdf", is_vtkhdf},
    Kind{FileKind::view, "a view", ".toml", is_view},
    Kind{FileKind::markdown, "a Markdown report", ".md", is_markdown},
    Kind{FileKind::json, "a JSON file", ".json", is_data},
    Kind{FileKind::log, "a log of netpocket", ".log", is_log},
    Kind{FileKind::stl, "an STL mesh", ".stl", is_stl},
    Kind{FileKind::obj, "an OBJ mesh", ".obj", is_obj},
    Kind{FileKind::scenario, "a scenario", ".toml", is_own_scenario},
    Kind{FileKind::findings, "a list of findings", ".txt", is_findings},
};

const Kind& entry(FileKind kind) {
  return *std::find_if(kKinds.begin(), kKinds.end(), [kind](const Kind& k) { return k.kind == kind; });
}

// Further suffixes of the kinds.
constexpr std::array<std::pair<FileKind, std::string_view>, 6> kOtherSuffixes = {{{FileKind::recording, ".hdf5"},
                                                                                  {FileKind::recording, ".hdf"},
                                                                                  {FileKind::video, ".m4v"},
                                                                                  {FileKind::html, ".htm"},
                                                                                  {FileKind::markdown, ".markdown"},
                                                                                  {FileKind::markdown, ".txt"}}};

// Suffixes of formats that this program does not write.
constexpr std::array<std::string_view, 57> kForeignSuffixes = {
    ".jpg", ".jpeg", ".gif",  ".bmp",  ".tif", ".tiff", ".webp", ".eps",  ".ps",  ".avif", ".exr", ".ppm",
    ".mov", ".avi",  ".mkv",  ".webm", ".mpg", ".ogv",  ".mpeg", ".gltf", ".ply", ".fbx",  ".usd", ".usdz",
    ".dae", ".3mf",  ".step", ".stp",  ".igs", ".tsv",  ".xls",  ".ods",  ".xml", ".yaml", ".yml", ".ini",
    ".rst", ".doc",  ".docx", ".odt",  ".tex", ".nc",   ".mat",  ".npy",  ".npz", ".vtu",  ".vtk", ".py",
    ".sh",  ".xlsx", ".zip",  ".gz",   ".tar", ".7z",   ".xz",   ".bz2",  ".apng"};

std::string suffix_of(const std::string& path) {
  std::string text = std::filesystem::path(path).extension().string();
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

bool has(const auto& values, const auto& value) {
  return std::find(values.begin(), values.end(), value) != values.end();
}

}  // namespace

std::string_view description(FileKind kind) { return entry(kind).description; }

std::string_view suffix(FileKind kind) { return entry(kind).suffix; }

bool may_replace(FileKind kind, std::string_view content) {
  // Zeros are space that was reserved but not written, because a program was killed or the power failed.
  const bool is_blank = std::all_of(content.begin(), content.end(), [](char c) { return c == 0; });
  return is_blank || entry(kind).is_it(content);
}

std::string_view marked_description(std::string_view content) {
  if (is_vtkhdf(content)) return description(FileKind::vtkhdf);
  if (is_hdf5(content)) return "an HDF5 file, such as a recording";
  for (const FileKind kind : {FileKind::png, FileKind::pdf, FileKind::video, FileKind::gltf, FileKind::html,
                              FileKind::svg, FileKind::vtp, FileKind::log, FileKind::stl, FileKind::obj}) {
    if (entry(kind).is_it(content)) return description(kind);
  }
  return {};
}

std::string_view content_description(std::string_view content) {
  if (const std::string_view marked = marked_description(content); !marked.empty()) return marked;
  if (is_view(content)) return description(FileKind::view);
  if (is_scenario(content)) return "a TOML file, such as a scenario";
  return is_text(content) ? "a text file of another kind" : "a file of another kind";
}

bool is_recording_file(const std::string& path) {
  std::string start(8, '\0');
  std::ifstream file(path, std::ios::binary);
  return file.read(start.data(), static_cast<std::streamsize>(start.size())) && is_hdf5(start);
}

bool names_another_format(FileKind kind, const std::string& path) {
  const std::string name = suffix_of(path);
  if (name == suffix(kind) || has(kOtherSuffixes, std::pair(kind, std::string_view(name)))) return false;
  const auto is_its = [&](const auto& other) { return name == other.second; };
  return has(kForeignSuffixes, name) ||
         std::any_of(kKinds.begin(), kKinds.end(), [&](const Kind& k) { return name == k.suffix; }) ||
         std::any_of(kOtherSuffixes.begin(), kOtherSuffixes.end(), is_its);
}

}  // namespace netpocket
