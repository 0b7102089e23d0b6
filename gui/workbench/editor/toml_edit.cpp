#include "gui/workbench/editor/toml_edit.h"

#include <toml++/toml.h>

#include <algorithm>
#include <vector>

#include "engine/scenario/parameter_text.h"

namespace netpocket {
namespace {

std::optional<toml::table> parse(std::string_view text) {
  try {
    return toml::parse(text);
  } catch (const toml::parse_error&) {
    return std::nullopt;
  }
}

// Lines without their ends.
std::vector<std::string_view> split_lines(std::string_view text) {
  std::vector<std::string_view> lines;
  while (true) {
    const auto end = text.find('\n');
    lines.push_back(text.substr(0, end));
    if (end == text.npos) return lines;
    text.remove_prefix(end + 1);
  }
}

bool is_continuation(char byte) { return (static_cast<unsigned char>(byte) & 0xc0) == 0x80; }

// Characters of a UTF-8 text.
std::size_t width(std::string_view text) {
  return text.size() - std::count_if(text.begin(), text.end(), is_continuation);
}

// Byte offset of a parser's position, whose columns count characters.
std::size_t offset_of(std::string_view text, const toml::source_position& position) {
  std::size_t offset = 0;
  for (toml::source_index line = 1; line < position.line; ++line) offset = text.find('\n', offset) + 1;
  for (toml::source_index column = 1; column < position.column && offset < text.size(); ++column) {
    do {
      ++offset;
    } while (offset < text.size() && is_continuation(text[offset]));
  }
  return offset;
}

// A comment after the value keeps its column as long as there is room.
std::string replace(std::string_view text, std::size_t begin, std::size_t end, const std::string& value) {
  const auto hash = text.find_first_not_of(" \t", end);
  std::string result(text.substr(0, begin));
  result += value;
  if (hash != text.npos && hash > end && text[hash] == '#') {
    const std::size_t old_width = width(text.substr(begin, hash - begin));
    result += std::string(width(value) < old_width ? old_width - width(value) : 1, ' ');
    return result += text.substr(hash);
  }
  return result += text.substr(end);
}

std::string insert_line(std::string_view text, std::size_t after, const std::string& line) {
  std::string result;
  const auto lines = split_lines(text);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (i == after) result += line + '\n';
    result += lines[i];
    if (i + 1 < lines.size()) result += '\n';
  }
  if (after >= lines.size()) result += '\n' + line + '\n';
  return result;
}

// The line after which a table's next key goes: its last key, or its header.
std::size_t last_line(const toml::table& table) {
  toml::source_index line = table.source().begin.line;
  for (const auto& [key, node] : table) {
    if (!node.is_table() && !node.is_array_of_tables()) line = std::max(line, node.source().end.line);
  }
  return line;
}

// Whether the table has a header of its own. "[[actuators.wheel]]" alone makes a table "actuators" without one.
bool has_header(std::string_view text, const toml::table& table, std::string_view name) {
  const auto lines = split_lines(text);
  const std::size_t line = table.source().begin.line;
  if (line == 0 || line > lines.size()) return false;
  std::string header(lines[line - 1]);
  std::erase_if(header, [](char byte) { return byte == ' ' || byte == '\t'; });
  return header.starts_with("[" + std::string(name) + "]");
}

// Where a parameter stands: its table, and the path of that from the root. For items of lists the table is that of the
// item.
struct TomlPlace {
  toml::node_view<const toml::node> table;
  bool is_item = false;
};

TomlPlace place_of(const toml::table& file, const Parameter& parameter) {
  std::string_view path = parameter.key;
  path = path.substr(0, path.rfind('.'));
  const auto dot = path.rfind('.');
  const std::string index = std::to_string(parameter.item);
  const bool is_item = dot != path.npos && path.substr(dot + 1) == index;
  if (!is_item) return {file.at_path(path)};
  return {file.at_path(std::string(path.substr(0, dot)) + "[" + index + "]"), true};
}

toml::node_view<const toml::node> node_of(const toml::table& file, const Parameter& parameter) {
  const TomlPlace place = place_of(file, parameter);
  return place.is_item ? place.table[parameter.name()] : file.at_path(parameter.key);
}

}  // namespace

bool states(std::string_view text, const Parameter& parameter) {
  const auto file = parse(text);
  return file && node_of(*file, parameter);
}

std::optional<std::string> with_value(std::string_view text, const Parameter& parameter, const ParameterValue& value) {
  const auto file = parse(text);
  if (!file) return std::nullopt;
  const std::string written = toml_text(parameter, value);
  if (const auto node = node_of(*file, parameter)) {
    const toml::source_region& region = node.node()->source();
    return replace(text, offset_of(text, region.begin), offset_of(text, region.end), written);
  }
  const std::string line = std::string(parameter.name()) + " = " + written;
  if (const TomlPlace place = place_of(*file, parameter); place.is_item) {
    const toml::table* item = place.table.as_table();
    if (item == nullptr || item->is_inline()) return std::nullopt;
    return insert_line(text, last_line(*item), line);
  }
  if (parameter.group().empty()) return line + '\n' + std::string(text);
  const toml::table* table = (*file)[parameter.group()].as_table();
  if (table && table->is_inline()) return std::nullopt;
  if (table && has_header(text, *table, parameter.group())) return insert_line(text, last_line(*table), line);
  std::string result(text);
  if (!result.empty() && result.back() != '\n') result += '\n';
  if (!result.empty()) result += '\n';
  return result + "[" + std::string(parameter.group()) + "]\n" + line + '\n';
}

}  // namespace netpocket
