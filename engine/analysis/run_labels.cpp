#include "engine/analysis/run_labels.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <sstream>
#include <string_view>

#include "engine/recording/recording.h"

namespace netpocket {
namespace {

constexpr std::size_t kLongestDifference = 60;  // characters, of a label's list of settings

using Indices = std::vector<std::size_t>;

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r");
  if (first == text.npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

// Line without its comment. A # within quotes does not begin one.
std::string_view without_comment(std::string_view line) {
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (quoted && line[i] == '\\') {
      ++i;
    } else if (line[i] == '"') {
      quoted = !quoted;
    } else if (line[i] == '#' && !quoted) {
      return line.substr(0, i);
    }
  }
  return line;
}

const std::string* value_of(const std::vector<RecordedSetting>& settings, const std::string& key) {
  const auto found = std::ranges::find(settings, key, &RecordedSetting::key);
  return found == settings.end() ? nullptr : &found->value;
}

// Keys whose values differ between runs. "name" and "description" only describe the run.
std::vector<std::string> differing_keys(const std::vector<std::vector<RecordedSetting>>& runs) {
  std::vector<std::string> keys;
  for (const auto& settings : runs) {
    for (const RecordedSetting& setting : settings) {
      if (setting.key == "name" || setting.key == "description") continue;
      const auto differs = [&](const auto& other) {
        const std::string* value = value_of(other, setting.key);
        return value == nullptr || *value != setting.value;
      };
      if (std::ranges::any_of(runs, differs) && std::ranges::find(keys, setting.key) == keys.end()) {
        keys.push_back(setting.key);
      }
    }
  }
  return keys;
}

std::string differences(const std::vector<RecordedSetting>& settings, const std::vector<std::string>& keys) {
  std::string text;
  for (const std::string& key : keys) {
    const std::string* value = value_of(settings, key);
    text += (text.empty() ? "" : ", ") + key + " = " + (value ? *value : "default");
  }
  return text;
}

std::size_t count_different(const std::vector<std::string>& texts) {
  return std::set<std::string>(texts.begin(), texts.end()).size();
}

// Labels that tell runs of the same name apart; empty when there is no difference.
std::vector<std::string> distinctions(const std::vector<const Recording*>& runs) {
  std::vector<std::vector<RecordedSetting>> settings;
  for (const auto* run : runs) settings.push_back(recorded_settings(run->origin().scenario_text));
  const auto keys = differing_keys(settings);
  std::vector<std::string> by_settings, by_name, by_path;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    by_settings.push_back(differences(settings[i], keys));
    by_name.push_back(std::filesystem::path(runs[i]->path()).filename().string());
    by_path.push_back(runs[i]->path());
  }
  const std::size_t runs_in_all = count_different(by_path);
  if (runs_in_all == 1) return std::vector<std::string>(runs.size());
  const auto is_readable = [](const std::string& text) { return text.size() <= kLongestDifference; };
  if (count_different(by_settings) == runs_in_all && std::ranges::all_of(by_settings, is_readable)) return by_settings;
  return count_different(by_name) == runs_in_all ? by_name : by_path;
}

}  // namespace

std::vector<RecordedSetting> recorded_settings(const std::string& scenario_text) {
  std::vector<RecordedSetting> settings;
  std::string group;
  std::istringstream lines(scenario_text);
  for (std::string line; std::getline(lines, line);) {
    const std::string_view text = trimmed(without_comment(line));
    const auto sign = text.find('=');
    if (text.starts_with('[') && text.ends_with(']') && sign == text.npos) {
      group = std::string(text.substr(1, text.size() - 2)) + ".";
    } else if (sign != text.npos) {
      settings.push_back(
          {group + std::string(trimmed(text.substr(0, sign))), std::string(trimmed(text.substr(sign + 1)))});
    }
  }
  return settings;
}

std::vector<std::string> run_labels(const std::vector<const Recording*>& recordings) {
  std::vector<std::string> labels;
  for (const auto* recording : recordings) labels.push_back(recording->origin().scenario_name);
  const std::vector<std::string> names = labels;
  for (const std::string& name : std::set<std::string>(names.begin(), names.end())) {
    Indices indices;
    std::vector<const Recording*> runs;
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (names[i] != name) continue;
      indices.push_back(i);
      runs.push_back(recordings[i]);
    }
    if (runs.size() < 2) continue;
    const auto parts = distinctions(runs);
    for (std::size_t i = 0; i < runs.size(); ++i) {
      labels[indices[i]] += (name.empty() || parts[i].empty() ? "" : ", ") + parts[i];
    }
  }
  return labels;
}

}  // namespace netpocket
