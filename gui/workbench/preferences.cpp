#include "gui/workbench/preferences.h"

#include <algorithm>
#include <thread>

namespace netpocket {
namespace {

constexpr const char* kCacheKey = "preferences/cache_mebibytes";
constexpr const char* kThreadsKey = "preferences/threads";
constexpr const char* kPresenterKey = "preferences/presenter";
constexpr const char* kAskKey = "preferences/ask_about_runs";
constexpr const char* kLanguageKey = "preferences/language";

int number(const QSettings& settings, const char* key, int otherwise, int lowest, int highest) {
  bool is_number = false;
  const int value = settings.value(key).toInt(&is_number);
  return is_number ? std::clamp(value, lowest, highest) : otherwise;
}

}  // namespace

int most_threads() { return std::max(1, static_cast<int>(std::thread::hardware_concurrency())); }

Preferences read_preferences(const QSettings& settings) {
  const Preferences usual;
  Preferences preferences;
  preferences.cache_mebibytes =
      number(settings, kCacheKey, usual.cache_mebibytes, Preferences::kSmallestCache, Preferences::kLargestCache);
  preferences.threads = number(settings, kThreadsKey, usual.threads, 1, most_threads());
  preferences.presenter = static_cast<PresenterKind>(number(settings, kPresenterKey, 0, 0, 2));
  preferences.ask_about_runs = settings.value(kAskKey, usual.ask_about_runs).toBool();
  preferences.language = settings.value(kLanguageKey, usual.language).toString();
  return preferences;
}

void write_preferences(const Preferences& preferences, QSettings& settings) {
  settings.setValue(kCacheKey, preferences.cache_mebibytes);
  settings.setValue(kThreadsKey, preferences.threads);
  settings.setValue(kPresenterKey, static_cast<int>(preferences.presenter));
  settings.setValue(kAskKey, preferences.ask_about_runs);
  settings.setValue(kLanguageKey, preferences.language);
}

}  // namespace netpocket
