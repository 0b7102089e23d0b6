#include "gui/workbench/preferences.h"

#include "gui/workbench/dialogs/preferences_dialog.h"
#include "tests/gui/workbench/window_fixture.h"

namespace netpocket {
namespace {

TEST(Preferences, SurviveInTheSettingsFile) {
  QTemporaryDir folder;
  {
    QSettings settings(folder.filePath("s.ini"), QSettings::IniFormat);
    write_preferences({2048, 1, PresenterKind::image, false}, settings);
  }
  const QSettings settings(folder.filePath("s.ini"), QSettings::IniFormat);
  const Preferences read = read_preferences(settings);
  EXPECT_EQ(read.cache_mebibytes, 2048);
  EXPECT_EQ(read.presenter, PresenterKind::image);
  EXPECT_FALSE(read.ask_about_runs);
}

TEST(Preferences, NonsenseInTheFileDoesNoHarm) {
  QTemporaryDir folder;
  QSettings settings(folder.filePath("s.ini"), QSettings::IniFormat);
  settings.setValue("preferences/cache_mebibytes", -5);
  settings.setValue("preferences/threads", "many");
  settings.setValue("preferences/presenter", 99);
  const Preferences read = read_preferences(settings);
  EXPECT_EQ(read.cache_mebibytes, Preferences::kSmallestCache);
  EXPECT_EQ(read.threads, 1);
  EXPECT_LE(static_cast<int>(read.presenter), 2);
}

TEST_F(WindowTest, PreferencesDialogShowsAndGivesThemBack) {
  const Preferences given{1024, 1, PresenterKind::opengl, false};
  PreferencesDialog dialog(given, 3 << 20, window_.get());
  EXPECT_EQ(dialog.preferences().cache_mebibytes, 1024);
  EXPECT_EQ(dialog.preferences().presenter, PresenterKind::opengl);
  EXPECT_FALSE(dialog.preferences().ask_about_runs);
}

TEST_F(WindowTest, SmallerHistoryActsAtOnce) {
  ASSERT_TRUE(run_to(1.0));
  auto& runs = window_->session().runs();
  const std::size_t before = runs.cache_bytes();
  window_->apply_preferences({.cache_mebibytes = Preferences::kSmallestCache, .ask_about_runs = false});
  EXPECT_LE(runs.cache_bytes(), std::size_t{Preferences::kSmallestCache} << 20);
  EXPECT_LE(runs.cache_bytes(), before);
  // It is also what the next session starts with.
  reopen();
  EXPECT_EQ(read_preferences(window_->settings()).cache_mebibytes, Preferences::kSmallestCache);
}

}  // namespace
}  // namespace netpocket
