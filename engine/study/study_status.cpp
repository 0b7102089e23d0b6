#include "engine/study/study_status.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "engine/study/record_files.h"
#include "engine/study/study_manifest.h"

namespace netpocket {
namespace {

using Json = nlohmann::ordered_json;

std::string failure_reason(const StudyRecord& record) {
  const std::string refused = record["refused"].get<std::string>();
  if (!refused.empty()) return refused;
  for (const Json& run : record["runs"]) {
    if (run["reason"] != "finished") return run["message"].get<std::string>();
  }
  return "";
}

std::vector<std::string> files_being_written(const std::string& folder) {
  std::vector<std::string> files;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder + "/records", error)) {
    if (is_being_written(entry.path().string())) files.push_back(entry.path().filename().string());
  }
  std::ranges::sort(files);
  return files;
}

}  // namespace

StudyStatus study_status(const std::string& folder) {
  const StudyManifest manifest = read_study_manifest(folder);
  StudyStatus status;
  status.study = manifest.study;
  status.points = manifest.points;
  std::vector<RecordPlace> failed;
  status.is_finished.resize(status.points);
  scan_records(folder, [&](const RecordPlace& place) {
    if (place.point > status.points || status.is_finished[place.point - 1]) return;
    status.is_finished[place.point - 1] = true;
    ++status.finished;
    status.refused += place.outcome == "refused" ? 1 : 0;
    status.diverged += place.outcome == "diverged" ? 1 : 0;
    status.limited += place.outcome == "limited" ? 1 : 0;
    if (place.outcome != "done" && failed.size() < kMostFailuresListed) failed.push_back(place);
  });
  RecordReader reader;
  for (const RecordPlace& place : failed) {
    status.failures.push_back({place.point, failure_reason(reader.read(place))});
  }
  status.writing = files_being_written(folder);
  return status;
}

std::string status_text(const StudyStatus& status) {
  std::string text = fmt::format("{}: {} of {} points done", status.study, status.finished, status.points);
  if (status.refused > 0) text += fmt::format(", {} of them refused as not valid", status.refused);
  if (status.diverged > 0) text += fmt::format(", {} with a run that diverged", status.diverged);
  if (status.limited > 0) text += fmt::format(", {} with a run that reached its limit of steps", status.limited);
  text += "\n";
  for (const std::string& file : status.writing) text += fmt::format("running: {}\n", file);
  for (const StudyFailure& failure : status.failures)
    text += fmt::format("point {}: {}\n", failure.point, failure.reason);
  const std::size_t failed = status.refused + status.diverged + status.limited;
  if (failed > status.failures.size()) text += fmt::format("and {} more\n", failed - status.failures.size());
  return text;
}

}  // namespace netpocket
