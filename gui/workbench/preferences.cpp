#include "gui/workbench/preferences.h"

#include <QDir>
#include <QFileInfo>
#include <algorithm>
#include <thread>

namespace netpocket {
namespace {

constexpr const char* kCacheKey = "preferences/cache_mebibytes";
constexpr const char* kThreadsKey = "preferences/threads";
constexpr const char* kPresenterKey = "preferences/presenter";
constexpr const char* kAskKey = "preferences/ask_about_runs";
constexpr const char* kLanguageKey = "preferences/language";

constexpr const char* kTypeSizeKey = "preferences/type_size";
constexpr const char* kThemeKey = "preferences/theme";
constexpr const char* kBeginningKey = "preferences/beginning";
constexpr const char* kFolderKey = "preferences/folder";
constexpr const char* kExportSizeKey = "preferences/export_size";
constexpr const char* kExportRateKey = "preferences/export_rate";
constexpr const char* kFilmRateKey = "preferences/film_rate";

int number(const QSettings& settings, const char* key, int otherwise, int lowest, int highest) {
  bool is_number = false;
  const int value = settings.value(key).toInt(&is_number);
  return is_number ? std::clamp(value, lowest, highest) : otherwise;
}

template <typename Choice>
Choice choice(const QSettings& settings, const char* key, Choice last) {
  return static_cast<Choice>(number(settings, key, 0, 0, static_cast<int>(last)));
}

QSize size(const QSettings& settings, const char* key, const QSize& otherwise) {
  const QSize value = settings.value(key).toSize();
  return value.width() >= 16 && value.height() >= 16 && value.width() <= 8192 && value.height() <= 8192 ? value
                                                                                                        : otherwise;
}

double rate(const QSettings& settings, const char* key, double otherwise) {
  bool is_number = false;
  const double value = settings.value(key).toDouble(&is_number);
  return is_number ? std::clamp(value, Preferences::kLeastRate, Preferences::kMostRate) : otherwise;
}

}  // namespace

QString Preferences::folder_for_new_files() const {
  return !folder.isEmpty() && QFileInfo(folder).isDir() ? folder : QDir::homePath();
}

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
  preferences.type_size = choice(settings, kTypeSizeKey, TypeSize::largest);
  preferences.theme = choice(settings, kThemeKey, Theme::dark);
  preferences.beginning = choice(settings, kBeginningKey, Beginning::empty);
  preferences.folder = settings.value(kFolderKey).toString();
  preferences.export_size = size(settings, kExportSizeKey, usual.export_size);
  preferences.export_rate = rate(settings, kExportRateKey, usual.export_rate);
  preferences.film_rate = number(settings, kFilmRateKey, usual.film_rate, 1, 60);
  return preferences;
}

void write_preferences(const Preferences& preferences, QSettings& settings) {
  settings.setValue(kCacheKey, preferences.cache_mebibytes);
  settings.setValue(kThreadsKey, preferences.threads);
  settings.setValue(kPresenterKey, static_cast<int>(preferences.presenter));
  settings.setValue(kAskKey, preferences.ask_about_runs);
  settings.setValue(kLanguageKey, preferences.language);
  settings.setValue(kTypeSizeKey, static_cast<int>(preferences.type_size));
  settings.setValue(kThemeKey, static_cast<int>(preferences.theme));
  settings.setValue(kBeginningKey, static_cast<int>(preferences.beginning));
  settings.setValue(kFolderKey, preferences.folder);
  settings.setValue(kExportSizeKey, preferences.export_size);
  settings.setValue(kExportRateKey, preferences.export_rate);
  settings.setValue(kFilmRateKey, preferences.film_rate);
}

}  // namespace netpocket
