#pragma once
// What the user has set once and for all; kept in the settings file.

#include <QSettings>

#include "gui/workbench/language.h"
#include "gui/workbench/viewport/presenter.h"

namespace netpocket {

struct Preferences {
  static constexpr int kSmallestCache = 16, kLargestCache = 1 << 20;  // MiB

  int cache_mebibytes = 512;  // of frames in memory; older ones are read from the recording
  int threads = 1;            // of a simulation
  PresenterKind presenter = PresenterKind::automatic;
  bool ask_about_runs = true;          // when unsaved runs would be lost by closing
  QString language = kSystemLanguage;  // a code of languages(); from the next start on

  std::size_t cache_bytes() const { return static_cast<std::size_t>(cache_mebibytes) << 20; }
};

// What a settings file says; whatever it does not say, or says wrongly, is as above.
Preferences read_preferences(const QSettings& settings);
void write_preferences(const Preferences& preferences, QSettings& settings);

// As many as the machine has processors.
int most_threads();

}  // namespace netpocket
