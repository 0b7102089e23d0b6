#include "gui/commands/notes.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>

#include "render/fonts/drawable_text.h"

namespace netpocket {
namespace {

bool is_numbered(const std::string& name, const std::string& prefix, const std::string& suffix) {
  if (name.size() <= prefix.size() + suffix.size()) return false;
  const auto digits = name.substr(prefix.size(), name.size() - prefix.size() - suffix.size());
  return name.starts_with(prefix) && name.ends_with(suffix) && digits.size() >= 4 &&
         digits.find_first_not_of("0123456789") == digits.npos;
}

}  // namespace

void note_older_files(const std::string& folder, const std::string& prefix, const std::string& suffix,
                      const std::set<std::string>& new_files) {
  std::vector<std::string> older;
  std::error_code error;
  for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    if (is_numbered(name, prefix, suffix) && !new_files.contains(name)) older.push_back(name);
  }
  if (older.empty()) return;
  const auto [first, last] = std::ranges::minmax(older);
  fmt::print(stderr, "netpocket: \"{}\" also holds {} older file{}, {}: not of this run of the program\n", folder,
             older.size(), older.size() == 1 ? "" : "s", older.size() == 1 ? first : first + " to " + last);
}

void note_missing_letters(std::vector<std::string> texts, const std::string& title) {
  texts.push_back(title);
  std::set<std::string> letters;
  for (const std::string& text : texts) {
    for (const bool bold : {false, true}) letters.merge(missing_letters(text, {.bold = bold}));
  }
  if (letters.empty()) return;
  fmt::print(stderr,
             "netpocket: no installed font has all letters of the titles; \"\uFFFD\" stands for {} (Debian: "
             "fonts-noto-cjk, fonts-symbola)\n",
             fmt::join(letters, " "));
}

}  // namespace netpocket
