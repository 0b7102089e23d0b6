#include "engine/study/live_results.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "engine/analysis/metrics/metrics.h"
#include "engine/scenario/check_scenario.h"
#include "engine/study/study_table.h"
#include "engine/systems/capture_system.h"

namespace netpocket {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

// Numbers of a run's summary that are worth a look, by their names in the table.
constexpr const char* kMeasured[] = {"peak_fx_N",    "peak_fy_N",    "peak_fz_N",   "impulse_x_Ns",
                                     "impulse_y_Ns", "impulse_z_Ns", "energy_error"};

double number_of_text(const std::string& text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size() ? value : kUnknown;
}

std::map<std::string, std::string> units_of(const StudyManifest& manifest) {
  std::map<std::string, std::string> units;
  for (const char* name : kMeasured) {
    const std::string_view text = name;
    units[name] = text.ends_with("_Ns") ? "N s" : text.ends_with("_N") ? "N" : "1";
  }
  if (!manifest.base) return units;
  for (const Parameter* parameter : parameters_of(*manifest.base)) {
    units[std::string(parameter->key)] = std::string(parameter->unit);
  }
  if (!check_scenario(*manifest.base).ok()) return units;
  const Structure structure = build_capture_system(*manifest.base).structure;
  for (const Metric& metric : MetricsCollector(structure, {}).metrics()) units[metric.name] = metric.unit;
  return units;
}

}  // namespace

LiveResults::LiveResults(const StudyManifest& manifest) : units_(units_of(manifest)), uncertain_(manifest.uncertain) {}

void LiveResults::add(const FollowedRecord& followed) {
  const StudyRecord& record = followed.record;
  const std::size_t runs = record["runs"].size();
  const auto [known, is_new] = rows_.try_emplace(followed.place.point, Rows{results_.size(), runs});
  if (is_new) {
    diverged_ += followed.place.outcome == "diverged" ? 1 : 0;
    limited_ += followed.place.outcome == "limited" ? 1 : 0;
    refused_ += followed.place.outcome == "refused" ? 1 : 0;
    if (first_refusal_.empty()) first_refusal_ = record["refused"].get<std::string>();
    append_rows(runs);
  }
  // A point of another scenario than before has other rows; the study's tables will know which are right.
  if (known->second.count != runs) return;
  for (std::size_t run = 0; run < runs; ++run) {
    write_row(known->second.first + run, record["runs"][run], {followed.place, run});
    for (const auto& [key, value] : record["settings"].items()) {
      put_setting(known->second.first + run, key, value.get<std::string>());
    }
  }
}

void LiveResults::append_rows(std::size_t count) {
  const std::size_t size = results_.size() + count;
  results_.points.resize(size, kUnknown);
  results_.captured.resize(size, kUnknown);
  sources_.resize(size);
  is_draft_.resize(size, 0);
  for (auto* columns : {&results_.inputs, &results_.measures}) {
    for (ResultColumn& column : *columns) column.values.resize(size, kUnknown);
  }
}

void LiveResults::write_row(std::size_t row, const StudyRecord& run, const Source& source) {
  const auto count = [this, row](int sign) {
    judged_ += std::isnan(results_.captured[row]) ? 0 : sign;
    captured_ += results_.captured[row] == 1 ? sign : 0;
  };
  count(-1);
  results_.points[row] = static_cast<double>(source.place.point);
  results_.captured[row] = run_number(run, "captured");
  count(1);
  sources_[row] = source;
  drafts_ -= is_draft_[row] != 0 ? 1 : 0;
  is_draft_[row] = run.contains("draft") ? 1 : 0;
  drafts_ += is_draft_[row] != 0 ? 1 : 0;
  if (is_draft_[row] != 0) draft_notice_ = run["draft"].get<std::string>();
  for (const std::string& key : uncertain_) put(results_.inputs, inputs_, row, key, run_number(run, key));
  for (const char* name : kMeasured) put(results_.measures, measures_, row, name, run_number(run, name));
  if (!run.contains("metrics")) return;
  for (const auto& [name, value] : run["metrics"].items()) {
    put(results_.measures, measures_, row, name, value.is_number() ? value.get<double>() : kUnknown);
  }
}

// What the study sets to different numbers, such as an axis, is an input as well.
void LiveResults::put_setting(std::size_t row, const std::string& key, const std::string& value) {
  if (std::ranges::find(uncertain_, key) != uncertain_.end()) return;
  const double number = number_of_text(value);
  const double shared = shared_.emplace(key, number).first->second;
  const bool is_known = inputs_.contains(key);
  if (std::isnan(number) || (!is_known && number == shared)) return;
  put(results_.inputs, inputs_, row, key, number);
  if (is_known) return;
  auto& values = results_.inputs.back().values;
  std::fill(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(row), shared);
}

void LiveResults::put(std::vector<ResultColumn>& columns, Places& places, std::size_t row, const std::string& name,
                      double value) {
  auto place = places.find(name);
  if (place == places.end()) {
    if (std::isnan(value)) return;  // a column begins with its first number
    place = places.emplace(name, columns.size()).first;
    columns.push_back({name, units_[name.substr(0, name.find('['))], std::vector(results_.size(), kUnknown)});
  }
  columns[place->second].values[row] = value;
}

}  // namespace netpocket
