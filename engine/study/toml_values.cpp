#include "engine/study/toml_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

namespace netpocket {

int line_of(const toml::node& node) { return static_cast<int>(node.source().begin.line); }

std::string value_text(const toml::node& node) {
  if (const auto* number = node.as_floating_point()) return fmt::format("{}", number->get());
  if (const auto* array = node.as_array()) {
    std::string text = "[";
    for (const toml::node& element : *array) text += (text.size() > 1 ? ", " : "") + value_text(element);
    return text + "]";
  }
  std::ostringstream text;
  node.visit([&text](const auto& value) { text << value; });
  return text.str();
}

std::vector<TomlEntry> entries(const toml::table& table) {
  std::vector<TomlEntry> found;
  for (const auto& [key, node] : table) found.push_back({std::string(key.str()), &node});
  const auto place = [](const TomlEntry& e) {
    return std::pair(e.node->source().begin.line, e.node->source().begin.column);
  };
  std::stable_sort(found.begin(), found.end(), [&](const auto& a, const auto& b) { return place(a) < place(b); });
  return found;
}

int whole_number(const toml::table& table, const std::string& key, int lowest, int highest, int otherwise,
                 const ReportProblem& report) {
  const toml::node* node = table.get(key);
  if (!node) return otherwise;
  const auto value = node->value_exact<std::int64_t>();
  if (value && *value >= lowest && *value <= highest) return static_cast<int>(*value);
  report(*node, key, fmt::format("expects a whole number from {} to {}", lowest, highest));
  return otherwise;
}

void check_names(const toml::table& table, const std::vector<std::string>& known, const ReportProblem& report) {
  for (const auto& [name, node] : entries(table)) {
    if (std::ranges::find(known, name) != known.end()) continue;
    report(*node, name, fmt::format("is not a key here; these are: {}", fmt::join(known, ", ")));
  }
}

}  // namespace netpocket
