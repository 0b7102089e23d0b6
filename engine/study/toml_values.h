#pragma once
// Values and tables of a study's file. Pure functions: any thread may call them.

#include <toml++/toml.h>

#include <functional>
#include <string>
#include <vector>

namespace netpocket {

int line_of(const toml::node& node);

// A value in the form that apply_setting() takes: numbers with the fewest digits that read back, texts in quotes.
std::string value_text(const toml::node& node);

struct TomlEntry {
  std::string key;
  const toml::node* node;
};

// Entries of a table in the order of the file.
std::vector<TomlEntry> entries(const toml::table& table);

// Takes a problem: where it is, the key, and the rest of the sentence.
using ReportProblem = std::function<void(const toml::node&, const std::string& key, const std::string& message)>;

// The whole number at a key, or `otherwise` where there is none. Anything else is reported.
int whole_number(const toml::table& table, const std::string& key, int lowest, int highest, int otherwise,
                 const ReportProblem& report);

// Reports the keys of a table that are not among the known ones.
void check_names(const toml::table& table, const std::vector<std::string>& known, const ReportProblem& report);

}  // namespace netpocket
