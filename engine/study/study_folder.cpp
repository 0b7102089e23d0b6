#include "engine/study/study_folder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>

#include "engine/recording/recorder.h"

namespace netpocket {
namespace {

namespace fs = std::filesystem;

std::string marker_path(const std::string& folder) { return folder + "/" + kStudyMarker; }

void make_study_folder(const std::string& path) {
  std::error_code error;
  fs::create_directories(path, error);
  if (error) throw RecordingError(fmt::format("cannot make the folder \"{}\": {}", path, error.message()));
}

// Name of any entry of the folder but the marker, which another part may just have made; nothing when there is none.
std::optional<std::string> any_entry(const std::string& folder) {
  std::error_code error;
  fs::directory_iterator entries(folder, error);
  if (error) throw RecordingError(fmt::format("cannot read the folder \"{}\": {}", folder, error.message()));
  for (const auto& entry : entries) {
    if (entry.path().filename() != kStudyMarker) return entry.path().filename().string();
  }
  return std::nullopt;
}

std::string read_all(int file) {
  constexpr std::size_t kLargest = 1 << 16;
  std::string text(kLargest, '\0');
  const ssize_t size = pread(file, text.data(), text.size(), 0);
  text.resize(size > 0 ? static_cast<std::size_t>(size) : 0);
  return text;
}

// Whether the path still leads to the file that was opened.
bool is_still(int file, const std::string& path) {
  struct stat opened {
  }, named{};
  return fstat(file, &opened) == 0 && stat(path.c_str(), &named) == 0 && opened.st_dev == named.st_dev &&
         opened.st_ino == named.st_ino;
}

}  // namespace

bool holds_study(const std::string& folder) {
  std::error_code ignored;
  return fs::exists(marker_path(folder), ignored);
}

OwnedStudyFolder::OwnedStudyFolder(const std::string& folder, const std::string& name, FolderUse use) {
  make_study_folder(folder);
  if (!holds_study(folder)) {
    if (const auto entry = any_entry(folder); entry && !holds_study(folder)) {
      throw RecordingError(
          fmt::format("\"{}\" holds something that is not of a study (\"{}\"): name a new or an empty "
                      "folder",
                      folder, *entry));
    }
  }
  lock(folder, use);
  try {
    check_owner(folder, name);
  } catch (...) {
    close(marker_);
    throw;
  }
}

void OwnedStudyFolder::lock(const std::string& folder, FolderUse use) {
  const std::string path = marker_path(folder);
  marker_ = open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666);
  if (marker_ < 0) throw RecordingError(fmt::format("cannot write \"{}\": {}", path, std::strerror(errno)));
  const bool is_shared = use == FolderUse::shared;
  if (flock(marker_, (is_shared ? LOCK_SH : LOCK_EX) | LOCK_NB) == 0 && is_still(marker_, path)) return;
  const int reason = errno;
  if (is_shared && (reason == ENOLCK || reason == EOPNOTSUPP)) return;
  close(marker_);
  throw RecordingError(reason == EWOULDBLOCK ? fmt::format("another program is running a study in \"{}\"", folder)
                                             : fmt::format("cannot lock \"{}\": {}", path, std::strerror(reason)));
}

void OwnedStudyFolder::check_owner(const std::string& folder, const std::string& name) const {
  using Json = nlohmann::ordered_json;
  const std::string text = read_all(marker_);
  if (text.empty()) {
    const std::string mark = Json{{"made_by", "netpocket study"}, {"study", name}}.dump(1) + "\n";
    if (pwrite(marker_, mark.data(), mark.size(), 0) == static_cast<ssize_t>(mark.size()) && fsync(marker_) == 0)
      return;
    throw RecordingError(fmt::format("cannot write \"{}\": {}", marker_path(folder), std::strerror(errno)));
  }
  const Json mark = Json::parse(text, nullptr, false);
  const auto entry = [&](const char* key) {
    return mark.is_object() && mark.contains(key) && mark[key].is_string() ? mark[key].get<std::string>() : "";
  };
  if (entry("made_by") != "netpocket study") {
    throw RecordingError(
        fmt::format("\"{}\" is not the mark of a study: name a new or an empty folder", marker_path(folder)));
  }
  if (entry("study") != name) {
    throw RecordingError(
        fmt::format("\"{}\" holds the study \"{}\", not \"{}\": name another folder", folder, entry("study"), name));
  }
}

OwnedStudyFolder::~OwnedStudyFolder() { close(marker_); }

}  // namespace netpocket
