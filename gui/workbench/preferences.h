#pragma once
// What the user has set once and for all; kept in the settings file.

#include <QSettings>
#include <QSize>
#include <QString>

#include "gui/workbench/language.h"
#include "gui/workbench/panels/window_look.h"
#include "gui/workbench/viewport/presenter.h"

namespace netpocket {

// What one sees when the program is started without a file.
enum class Beginning { start_page, last_file, empty };

struct Preferences {
  static constexpr int kSmallestCache = 16, kLargestCache = 1 << 20;  // MiB
  static constexpr double kLeastRate = 0.1, kMostRate = 1000;         // of exported pictures

  int cache_mebibytes = 512;  // of frames in memory; older ones are read from the recording
  int threads = 1;            // of a simulation
  PresenterKind presenter = PresenterKind::automatic;
  bool ask_about_runs = true;          // when unsaved runs would be lost by closing
  QString language = kSystemLanguage;  // a code of languages(); from the next start on

  TypeSize type_size = TypeSize::normal;
  Theme theme = Theme::system;
  Beginning beginning = Beginning::start_page;
  QString folder = {};           // for new files; empty: the user's own
  QSize export_size{1280, 720};  // pixels, of exported pictures
  double export_rate = 25;       // exported pictures per simulated second
  int film_rate = 25;            // pictures a second in videos of the window

  // `folder`, or the user's own where there is none of that name (any more).
  QString folder_for_new_files() const;
  std::size_t cache_bytes() const { return static_cast<std::size_t>(cache_mebibytes) << 20; }
};

// What a settings file says; whatever it does not say, or says wrongly, is as above.
Preferences read_preferences(const QSettings& settings);
void write_preferences(const Preferences& preferences, QSettings& settings);

// As many as the machine has processors.
int most_threads();

}  // namespace netpocket
