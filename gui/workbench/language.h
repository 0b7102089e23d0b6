#pragma once
// The languages that the window speaks. Its texts are written in English; translations/ holds the others, as Qt's .ts
// files, which are part of the program. Commands, recordings, scenarios and figures are English in any case.
// Thread contract: the user interface's thread.

#include <QSettings>
#include <QString>
#include <vector>

namespace netpocket {

struct Language {
  QString code;  // "zh_CN"
  QString name;  // what it calls itself: "简体中文"
};

// English first, then every translation in the program.
const std::vector<Language>& languages();

// Of the preferences: whatever the system speaks.
inline constexpr const char* kSystemLanguage = "system";
inline constexpr const char* kEnglish = "en";

// What of `languages()` serves somebody who wants the first of these, or else a later one: "zh-Hans-CN", "en-GB".
// English when there is none of them.
QString language_for(const QStringList& wanted);

// Makes all texts from here on come in a language of languages(), English or not; fonts are not looked at.
void speak(const QString& code);

// Chooses what the preferences say and makes the window speak it, before its parts are made. Returns one sentence to be
// told when that is not possible: such a language is not known (each time), or no font has its letters (once, then
// `settings` know that it was told). Then the window speaks English, or what the system does.
QString speak_as_preferred(QSettings& settings);

}  // namespace netpocket
