#include "engine/study/study_results.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <map>

#include "engine/base/file_error.h"
#include "engine/study/csv_cells.h"
#include "engine/study/study_manifest.h"

namespace netpocket {
namespace {

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

double verdict_in(const std::string& cell) { return cell == "yes" ? 1 : cell == "no" ? 0 : kNoNumber; }

std::ifstream open_table(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw FileError(fmt::format("there is no table \"{}\": the study is not finished", path));
  return file;
}

std::map<std::string, std::string> units_of(const std::string& folder) {
  std::ifstream file = open_table(folder + "/study_columns.csv");
  std::map<std::string, std::string> units;
  for (std::string line; std::getline(file, line);) {
    const auto cells = csv_cells(line);
    if (cells.size() == 3) units[cells[0]] = cells[1];
  }
  return units;
}

std::size_t place_of(const std::vector<std::string>& header, const std::string& name, const std::string& path) {
  const auto found = std::ranges::find(header, name);
  if (found == header.end()) throw FileError(fmt::format("\"{}\" has no column {}", path, name));
  return static_cast<std::size_t>(found - header.begin());
}

bool has_numbers(const ResultColumn& column) {
  return std::ranges::any_of(column.values, [](double value) { return std::isfinite(value); });
}

// All columns of a table; none when there is no such file.
std::vector<ResultColumn> read_columns(const std::string& path, std::map<std::string, std::string>& units) {
  std::vector<ResultColumn> columns;
  std::ifstream file(path);
  std::string line;
  if (!std::getline(file, line)) return columns;
  for (const std::string& name : csv_cells(line)) columns.push_back({name, units[name], {}});
  while (std::getline(file, line)) {
    const std::vector<std::string> cells = csv_cells(line);
    if (cells.size() != columns.size()) throw FileError(fmt::format("\"{}\" has a damaged row: {}", path, line));
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const double verdict = verdict_in(cells[i]);
      columns[i].values.push_back(std::isnan(verdict) ? csv_number(cells[i]) : verdict);
    }
  }
  return columns;
}

// Rows of the first group and variant only.
void read_sensitivity(const std::string& folder, StudyResults& results) {
  const std::string path = folder + "/study_sensitivity.csv";
  std::ifstream file(path);
  std::string line;
  if (!std::getline(file, line)) return;
  const std::vector<std::string> header = csv_cells(line);
  const std::size_t of = place_of(header, "of", path), input = place_of(header, "input", path);
  for (const std::string& name : header) results.sensitivity.push_back({name, "1", {}});
  std::string group;
  while (std::getline(file, line)) {
    const std::vector<std::string> cells = csv_cells(line);
    if (cells.size() != header.size()) throw FileError(fmt::format("\"{}\" has a damaged row: {}", path, line));
    const std::string its_group = cells[0] + "\n" + cells[1];
    if (group.empty()) group = its_group;
    if (its_group != group) break;
    results.sensitivity_inputs.push_back(cells[input]);
    results.sensitivity_of = cells[of];
    for (std::size_t i = 0; i < cells.size(); ++i) results.sensitivity[i].values.push_back(csv_number(cells[i]));
  }
}

void read_search_results(const std::string& folder, std::map<std::string, std::string>& units, StudyResults& results) {
  results.optimisation = read_columns(folder + "/study_optimisation.csv", units);
  results.rare = read_columns(folder + "/study_rare.csv", units);
  if (results.optimisation.empty() && results.rare.empty()) return;
  const StudyManifest manifest = read_study_manifest(folder);
  results.objective = manifest.objective;
  results.failure = manifest.failure;
}

}  // namespace

const ResultColumn* StudyResults::find(const std::string& name) const {
  for (const auto* columns : {&inputs, &measures}) {
    for (const ResultColumn& column : *columns) {
      if (column.name == name) return &column;
    }
  }
  return nullptr;
}

StudyResults read_study_results(const std::string& folder) {
  const std::string path = folder + "/study.csv";
  std::ifstream file = open_table(path);
  auto units = units_of(folder);
  std::string line;
  std::getline(file, line);
  const std::vector<std::string> header = csv_cells(line);
  const std::size_t draw = place_of(header, "draw", path), variant = place_of(header, "variant", path),
                    refused = place_of(header, "refused", path), captured = place_of(header, "captured", path);
  std::vector<ResultColumn> columns;
  for (const std::string& name : header) columns.push_back({name, units[name], {}});
  StudyResults results;
  while (std::getline(file, line)) {
    const std::vector<std::string> cells = csv_cells(line);
    if (cells.size() != header.size()) throw FileError(fmt::format("\"{}\" has a damaged row: {}", path, line));
    if (!cells[refused].empty()) continue;
    for (std::size_t i = 0; i < cells.size(); ++i) columns[i].values.push_back(csv_number(cells[i]));
    results.points.push_back(csv_number(cells[0]));
    results.captured.push_back(verdict_in(cells[captured]));
  }
  for (std::size_t i = draw + 1; i < columns.size(); ++i) {
    if (has_numbers(columns[i])) (i < variant ? results.inputs : results.measures).push_back(std::move(columns[i]));
  }
  read_sensitivity(folder, results);
  read_search_results(folder, units, results);
  return results;
}

}  // namespace netpocket
