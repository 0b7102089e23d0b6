// The window for those who use keys only, hear instead of seeing, or see little.

#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QListWidget>
#include <QMenu>
#include <QMenuBar>
#include <QStatusBar>

#include "gui/workbench/control/control_panel.h"
#include "gui/workbench/dialogs/about_dialog.h"
#include "gui/workbench/dialogs/differences_dialog.h"
#include "gui/workbench/dialogs/part_dialog.h"
#include "gui/workbench/dialogs/preferences_dialog.h"
#include "gui/workbench/dialogs/shortcut_sheet.h"
#include "gui/workbench/editor/scenario_editor.h"
#include "gui/workbench/editor/text_page.h"
#include "gui/workbench/export/export_dialog.h"
#include "gui/workbench/panels/chart_view.h"
#include "gui/workbench/panels/plots_panel.h"
#include "gui/workbench/panels/tones.h"
#include "gui/workbench/panels/window_look.h"
#include "gui/workbench/presentation/presentation.h"
#include "gui/workbench/start/start_page.h"
#include "gui/workbench/timeline/timeline_bar.h"
#include "gui/workbench/view_actions.h"
#include "gui/workbench/viewport/viewport.h"
#include "tests/gui/plain_desktop.h"
#include "tests/gui/workbench/accessibility_walk.h"
#include "tests/gui/workbench/window_fixture.h"

namespace netpocket {
namespace {

class AccessibilityTest : public WindowTest {
 protected:
  AccessibilityTest() { window_->resize(1400, 900); }
  ~AccessibilityTest() override {
    use_theme(Theme::system);
    use_plain_look();
  }

  static void expect_none(const QStringList& faults, const char* where) {
    EXPECT_TRUE(faults.isEmpty()) << where << ":\n  " << faults.join("\n  ").toStdString();
  }

  void show_dock(const char* name) {
    auto* dock = window_->findChild<QDockWidget*>(name);
    dock->show();
    dock->raise();
  }

  void check(QDialog& dialog, const char* name) {
    dialog.show();
    dialog.activateWindow();
    ASSERT_TRUE(wait_until([&] { return dialog.isActiveWindow(); }, 5));
    expect_none(keyboard_faults(dialog), name);
    expect_none(contrast_faults(dialog), name);
  }

  // Calls `act` with every look that the window can have.
  void in_every_look(const std::function<void(const char*)>& act) {
    act("as the desktop");
    for (const auto& [theme, name] : {std::pair(Theme::light, "light"), std::pair(Theme::dark, "dark")}) {
      use_theme(theme);
      QApplication::processEvents();
      act(name);
    }
  }
};

TEST_F(AccessibilityTest, TheWindowByKeysAndEars) {
  ASSERT_TRUE(run_to(1.0));
  window_->show_notice("A sentence that tells of a problem.");
  show_dock("runs");
  ASSERT_TRUE(wait_for_picture());  // so that nothing but the focus changes the view
  expect_none(keyboard_faults(*window_), "with the runs");
  window_->view_actions().second_view_action()->setChecked(true);
  show_dock("findings");
  show_dock("control");
  ASSERT_TRUE(wait_for_picture());
  expect_none(keyboard_faults(*window_), "with findings, control and a second view");
  show_dock("scenario");
}

TEST_F(AccessibilityTest, TheStartPageByKeysAndEars) {
  write_file("mine.toml", "name = \"mine\"\n");
  window_->open(file("mine.toml"));
  window_->show_start_page();
  // What it covers cannot be operated meanwhile.
  QStringList faults = keyboard_faults(*window_);
  faults.removeIf([](const QString& fault) { return !fault.contains("StartPage"); });
  expect_none(faults, "start page");
}

TEST_F(AccessibilityTest, TheDialogsByKeysEyesAndEars) {
  ASSERT_TRUE(run_to(0.2));
  PreferencesDialog preferences({}, 0, window_.get());
  check(preferences, "preferences");
  ExportDialog pictures(folder_.path(), "run", {window_->viewport().view(), window_->viewport().options(), 0},
                        window_.get());
  for (const ExportKind kind : {ExportKind::video, ExportKind::figures}) {
    pictures.choose(kind);
    check(pictures, "export");
  }
  AboutDialog about("Netpocket", "images", window_.get());
  check(about, "about");
  PartDialog parts(window_->document(), window_.get());
  parts.show_part(ScenarioPart::pocket);
  check(parts, "parts");
  DifferencesDialog differences(window_->document(), window_.get());
  differences.compare_with("case1");
  check(differences, "differences");
  ShortcutSheet keys(*window_->menuBar(), window_.get());
  check(keys, "keys");
}

TEST_F(AccessibilityTest, EveryActionSaysWhatItDoes) {
  for (const auto* menu : window_->menuBar()->findChildren<QMenu*>()) {
    for (const QAction* action : menu->actions()) {
      if (action->isSeparator() || action->menu() != nullptr) continue;
      EXPECT_FALSE(action->text().isEmpty()) << menu->title().toStdString();
      EXPECT_FALSE(action->toolTip().isEmpty()) << action->text().toStdString();
    }
  }
}

TEST_F(AccessibilityTest, TextsStandOutInEveryLook) {
  ASSERT_TRUE(run_to(1.0));
  window_->show_notice("A sentence that tells of a problem.");
  in_every_look([&](const char* look) {
    for (const char* dock : {"runs", "findings", "control", "scenario"}) {
      show_dock(dock);
      expect_none(contrast_faults(*window_), look);
    }
    PreferencesDialog preferences({}, 0, window_.get());
    preferences.show();
    expect_none(contrast_faults(preferences), look);
  });
}

TEST_F(AccessibilityTest, WhatIsPaintedStandsOutInEveryLook) {
  ASSERT_TRUE(run_to(1.0));
  in_every_look([&](const char* look) {
    ASSERT_TRUE(wait_for_picture());
    TimelineStrip& strip = *window_->timeline().strip();
    const int ticks = strip.fontMetrics().height();
    EXPECT_GE(written_contrast(strip, QRect(30, strip.height() - ticks, strip.width() - 60, ticks)), 4.5) << look;
    for (int kind = 0; kind <= static_cast<int>(TimeMark::Kind::own); ++kind) {
      const QColor mark = mark_color(static_cast<TimeMark::Kind>(kind), strip.palette());
      EXPECT_GE(contrast(mark, strip.palette().color(QPalette::Window)), 3) << look << ", mark " << kind;
    }
    ChartView& chart = *window_->plots().chart();
    EXPECT_GE(written_contrast(chart, QRect(chart.width() / 3, chart.height() - 18, chart.width() / 2, 18)), 4.5)
        << look;
    // The time stands at the upper left of the view.
    EXPECT_GE(written_contrast(window_->viewport().picture().copy(0, 0, 180, 40)), 4.5) << look;
    // Of desktops' own colours for what is chosen they are the judges.
    const QPalette colours = window_->palette();
    if (QString(look) != "as the desktop") {
      EXPECT_GE(contrast(colours.color(QPalette::HighlightedText), colours.color(QPalette::Highlight)), 4.5) << look;
    }
    for (const Tone tone : {Tone::good, Tone::bad, Tone::warning, Tone::accent, Tone::muted}) {
      const QPalette palette = window_->palette();
      for (const auto role : {QPalette::Base, QPalette::Window}) {
        EXPECT_GE(contrast(tone_colour(tone, palette), palette.color(role)), 4.5) << look << ", " << int(tone);
      }
      EXPECT_GE(contrast(tone_colour(Tone::muted, palette), ground_colour(tone, palette)), 4.5) << look;
      EXPECT_GE(contrast(palette.color(QPalette::Text), ground_colour(tone, palette)), 4.5) << look;
    }
  });
}

TEST_F(AccessibilityTest, CardsOfTheStartPageStandOutInEveryLook) {
  window_->show_start_page();
  in_every_look([&](const char* look) {
    QListWidget* list = window_->start_page().scenarios();
    const QRect card = list->visualItemRect(list->item(1));
    const int line = list->fontMetrics().height();
    const QRect below(card.left() + 16, card.bottom() - 3 * line - 12, card.width() - 32, line);
    for (int i = 0; i < 2; ++i) {
      EXPECT_GE(written_contrast(*list->viewport(), below.translated(0, i * line)), 4.5) << look << ", line " << i;
    }
  });
}

TEST_F(AccessibilityTest, PresentingToo) {
  ASSERT_TRUE(run_to(1.0));
  window_->presentation().set_on(true);
  in_every_look([&](const char* look) { expect_none(contrast_faults(*window_), look); });
  expect_none(keyboard_faults(*window_), "presenter mode");
}

}  // namespace
}  // namespace netpocket
