#include "gui/workbench/language.h"

#include <QApplication>
#include <QDir>
#include <QFontMetrics>
#include <QLibraryInfo>
#include <QLocale>
#include <QTranslator>
#include <algorithm>
#include <memory>

#include "gui/workbench/preferences.h"

namespace netpocket {
namespace {

constexpr const char* kToldKey = "language/font_missing";  // of which language
//: To be translated by what the language calls itself
constexpr const char* kOwnName = QT_TRANSLATE_NOOP("Language", "English");

struct LanguageWords {
  Q_DECLARE_TR_FUNCTIONS(Language)
};

QString file_of(const QString& code) { return ":/translations/netpocket_" + code + ".qm"; }

QString own_name(const QString& code) {
  QTranslator translator;
  if (!translator.load(file_of(code))) return {};
  return translator.translate("Language", kOwnName);
}

std::vector<Language> read_languages() {
  std::vector<Language> found = {{kEnglish, kOwnName}};
  for (QString file : QDir(":/translations").entryList({"netpocket_*.qm"}, QDir::Files, QDir::Name)) {
    const QString code = file.remove("netpocket_").chopped(3);
    if (const QString name = own_name(code); !name.isEmpty()) found.push_back({code, name});
  }
  return found;
}

// Also letters that another font lends.
bool fonts_have(const QString& text) {
  const QFontMetrics metrics(QApplication::font());
  return std::ranges::all_of(text.toUcs4(), [&](uint letter) { return metrics.inFontUcs4(letter); });
}

// What is spoken now: Qt's own texts, where its translations are installed, and the window's, which come first.
std::vector<std::unique_ptr<QTranslator>>& spoken() {
  static std::vector<std::unique_ptr<QTranslator>> translators;
  return translators;
}

}  // namespace

const std::vector<Language>& languages() {
  static const std::vector<Language> all = read_languages();
  return all;
}

QString language_for(const QStringList& wanted) {
  for (const QString& name : wanted) {
    const QLocale locale(name);
    for (const Language& language : languages()) {
      const QLocale candidate(language.code);
      // Chinese in simplified letters does not serve those who write traditional ones.
      if (candidate.language() == locale.language() && candidate.script() == locale.script()) return language.code;
    }
  }
  return kEnglish;
}

void speak(const QString& code) {
  for (const auto& translator : spoken()) QCoreApplication::removeTranslator(translator.get());
  spoken().clear();
  if (code == kEnglish) return;
  const auto add = [](std::unique_ptr<QTranslator> translator, bool loaded) {
    if (!loaded) return;
    QCoreApplication::installTranslator(translator.get());
    spoken().push_back(std::move(translator));
  };
  auto qt = std::make_unique<QTranslator>(), own = std::make_unique<QTranslator>();
  const bool has_qt = qt->load(QLocale(code), "qtbase", "_", QLibraryInfo::path(QLibraryInfo::TranslationsPath));
  add(std::move(qt), has_qt);
  const bool has_own = own->load(file_of(code));
  add(std::move(own), has_own);
}

QString speak_as_preferred(QSettings& settings) {
  const QString wanted = read_preferences(settings).language;
  const auto known = [&](const Language& language) { return language.code == wanted; };
  const bool chosen = std::ranges::any_of(languages(), known);
  const QString code = chosen ? wanted : language_for(QLocale::system().uiLanguages());
  const QString name = std::ranges::find(languages(), code, &Language::code)->name;
  if (!fonts_have(name)) {
    speak(kEnglish);
    if (settings.value(kToldKey).toString() == code) return {};
    settings.setValue(kToldKey, code);
    return LanguageWords::tr(
               "No installed font has the letters of the language %1, so the window speaks English; on "
               "Debian the packages fonts-wqy-microhei and fonts-noto-cjk have Chinese ones.")
        .arg(code);
  }
  speak(code);
  settings.remove(kToldKey);
  if (chosen || wanted == kSystemLanguage) return {};
  QStringList codes;
  for (const Language& language : languages()) codes << language.code;
  return LanguageWords::tr(
             "The preferences ask for the language “%1”, which this program does not speak, so the "
             "system's is taken; there are: %2.")
      .arg(wanted, codes.join(", "));
}

}  // namespace netpocket
