#include "tests/gui/workbench/generated_texts.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
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
  void add(const char* context, std::string_view text) {
    const Entry entry = {context, std::string(text)};
    if (!text.empty() && std::ranges::find(entries_, entry) == entries_.end()) entries_.push_back(entry);
  }

  std::string header() const {
    std::string text =
        "#pragma once\n"
        "// Texts of parameters, findings and scenarios, for lupdate; nothing includes this. Made from their tables:\n"
        "// NETPOCKET_RENEW=1 build/tests/test_workbench --gtest_filter='Translations.*' writes it anew.\n"
        "// clang-format off\n\n"
        "#include <QCoreApplication>\n\n"
        "namespace netpocket {\n\n"
        "inline constexpr const char* kGeneratedTexts[] = {\n";
    for (const Entry& entry : entries_) {
      text += fmt::format("    QT_TRANSLATE_NOOP(\"{}\", \"{}\"),\n", entry.context, escaped(entry.text));
    }
    return text + "};\n\n}  // namespace netpocket\n";
  }

 private:
  struct Entry {
    std::string context;
    std::string text;
    bool operator==(const Entry&) const = default;
  };

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

std::string generated_texts() {
  TextList texts;
  for (const char* system : {"pocket", "thrown_net"}) add_system(system, texts);
  for (const Finding& finding : evaluate_findings({})) {
    texts.add("engine", finding.text);
    texts.add("engine", finding.rule);
  }
  for (const Preset& preset : presets()) texts.add("scenarios", preset.description.toStdString());
  return texts.header();
}

}  // namespace netpocket
