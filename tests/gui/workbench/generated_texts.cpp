#include "tests/gui/workbench/generated_texts.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/analysis/summary.h"
#include "engine/scenario/parameters.h"
#include "gui/workbench/editor/parameter_words.h"
#include "gui/workbench/editor/presets.h"

namespace netpocket {
namespace {

class TextList {
 public:
  // Each text once.
  void add(const char* context, std::string_view text, std::string_view table = {}) {
    const Entry entry = {context, std::string(text), std::string(table)};
    if (!text.empty() && std::ranges::find(entries_, entry) == entries_.end()) entries_.push_back(entry);
  }

  std::string texts() const {
    constexpr std::size_t kWidth = 120;  // several short texts stand on a line
    std::string list, line = "   ";
    for (const Entry& entry : entries_) {
      if (!entry.table.empty()) continue;
      const std::string text = fmt::format(" QT_TRANSLATE_NOOP(\"{}\", \"{}\"),", entry.context, escaped(entry.text));
      if (line != "   " && line.size() + text.size() > kWidth) list += std::exchange(line, "   ") + '\n';
      line += text;
    }
    list += line + '\n';
    return header("Texts of parameters, findings and scenarios", "kGeneratedTexts[]", list);
  }

  std::string names_of_tables() const {
    std::string list;
    for (const Entry& entry : entries_) {
      if (entry.table.empty()) continue;
      list += fmt::format("    QT_TRANSLATE_NOOP3(\"{}\", \"{}\", \"{}\"),\n", entry.context, escaped(entry.text),
                          entry.table);
    }
    return header("Names of parameters that mean something else in each table", "kNamesOfTables[][2]", list);
  }

 private:
  struct Entry {
    std::string context;
    std::string text;
    std::string table;  // that the text is a name in, where names of other tables mean something else
    bool operator==(const Entry&) const = default;
  };

  static std::string header(const char* what, const char* name, const std::string& list) {
    return fmt::format(
        "#pragma once\n"
        "// clang-format off\n"
        "// {}, for lupdate; nothing includes this. Made from their\n"
        "// tables: NETPOCKET_RENEW=1 build/tests/test_workbench --gtest_filter='Translations.*' writes it anew.\n\n"
        "#include <QCoreApplication>\n\n"
        "namespace netpocket {{\n\n"
        "inline constexpr const char* {} = {{\n{}}};\n\n}}  // namespace netpocket\n",
        what, name, list);
  }

  static std::string escaped(const std::string& text) {
    std::string result;
    for (const char c : text) {
      if (c == '"' || c == '\\') result += '\\';
      result += c;
    }
    return result;
  }

  std::vector<Entry> entries_;
};

// Every parameter of every system, also of items.
std::vector<const Parameter*> all_parameters() {
  std::vector<const Parameter*> all;
  for (const char* system : {"pocket", "thrown_net"}) {
    for (const Parameter& parameter : parameters(system)) all.push_back(&parameter);
    for (const ParameterList& list : parameter_lists(system)) {
      for (const Parameter& parameter : list.rows) all.push_back(&parameter);
    }
  }
  return all;
}

// Names that mean several things, by what is said about them.
void add_names_of_tables(TextList& texts) {
  const auto all = all_parameters();
  for (const Parameter* parameter : all) {
    const bool several = std::ranges::any_of(all, [&](const Parameter* other) {
      return other->name() == parameter->name() && other->group() != parameter->group() &&
             other->help != parameter->help;
    });
    if (several) texts.add("parameters", label(*parameter).toStdString(), parameter->group());
  }
}

void add_parameters(std::span<const Parameter> parameters, TextList& texts) {
  for (const Parameter& parameter : parameters) {
    texts.add("parameters", label(parameter).toStdString());
    texts.add("parameters", parameter.help);
    texts.add("parameters", parameter.source);
  }
}

void add_system(std::string_view system, TextList& texts) {
  for (const ParameterGroup& group : parameter_groups(system)) {
    texts.add("parameters", group.title);
    texts.add("parameters", group.help);
    add_parameters(parameters_of(group, system), texts);
  }
  for (const ParameterList& list : parameter_lists(system)) {
    texts.add("parameters", list.title);
    texts.add("parameters", list.help);
    add_parameters(list.rows, texts);
  }
}

}  // namespace

std::vector<GeneratedFile> generated_texts() {
  TextList texts;
  for (const char* system : {"pocket", "thrown_net"}) add_system(system, texts);
  add_names_of_tables(texts);
  for (const Finding& finding : evaluate_findings({})) {
    texts.add("engine", finding.text);
    texts.add("engine", finding.rule);
  }
  for (const Preset& preset : presets()) texts.add("scenarios", preset.description.toStdString());
  return {{"generated_texts.h", texts.texts()}, {"names_of_tables.h", texts.names_of_tables()}};
}

}  // namespace netpocket
