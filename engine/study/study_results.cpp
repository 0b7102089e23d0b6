#include "engine/study/study_results.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <limits>
#include <map>

#include "engine/base/file_error.h"

namespace netpocket {
namespace {

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

// Cells of a line of RFC 4180.
std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells(1);
  bool is_quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const bool is_pair = is_quoted && line[i] == '"' && i + 1 < line.size() && line[i + 1] == '"';
    if (is_pair) {
      cells.back() += line[++i];
    } else if (line[i] == '"') {
      is_quoted = !is_quoted;
    } else if (line[i] == ',' && !is_quoted) {
      cells.emplace_back();
    } else {
      cells.back() += line[i];
    }
  }
  return cells;
}

double number_in(const std::string& cell) {
  double value = 0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  return error == std::errc() && end == cell.data() + cell.size() ? value : kNoNumber;
}

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
    const auto cells = cells_of(line);
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
  const std::vector<std::string> header = cells_of(line);
  const std::size_t draw = place_of(header, "draw", path), variant = place_of(header, "variant", path),
                    refused = place_of(header, "refused", path), captured = place_of(header, "captured", path);
  std::vector<ResultColumn> columns;
  for (const std::string& name : header) columns.push_back({name, units[name], {}});
  StudyResults results;
  while (std::getline(file, line)) {
    const std::vector<std::string> cells = cells_of(line);
    if (cells.size() != header.size()) throw FileError(fmt::format("\"{}\" has a damaged row: {}", path, line));
    if (!cells[refused].empty()) continue;
    for (std::size_t i = 0; i < cells.size(); ++i) columns[i].values.push_back(number_in(cells[i]));
    results.points.push_back(number_in(cells[0]));
    results.captured.push_back(verdict_in(cells[captured]));
  }
  for (std::size_t i = draw + 1; i < columns.size(); ++i) {
    if (has_numbers(columns[i])) (i < variant ? results.inputs : results.measures).push_back(std::move(columns[i]));
  }
  return results;
}

}  // namespace netpocket
