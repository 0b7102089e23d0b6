#include "gui/workbench/preferences.h"

#include <QDir>
#include <QFile>
#include <cmath>

#include "gui/workbench/dialogs/preferences_dialog.h"
#include "gui/workbench/panels/tones.h"
#include "gui/workbench/start/start_page.h"
#include "gui/workbench/view_actions.h"
#include "tests/gui/plain_desktop.h"
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

TEST(Preferences, LooksAndPicturesSurvive) {
  QTemporaryDir folder;
  Preferences chosen;
  chosen.type_size = TypeSize::largest;
  chosen.theme = Theme::dark;
  chosen.beginning = Beginning::last_file;
  chosen.folder = folder.path();
  chosen.export_size = {1920, 1080};
  chosen.export_rate = 12.5;
  chosen.film_rate = 30;
  {
    QSettings settings(folder.filePath("s.ini"), QSettings::IniFormat);
    write_preferences(chosen, settings);
  }
  const Preferences read = read_preferences(QSettings(folder.filePath("s.ini"), QSettings::IniFormat));
  EXPECT_EQ(read.type_size, TypeSize::largest);
  EXPECT_EQ(read.theme, Theme::dark);
  EXPECT_EQ(read.beginning, Beginning::last_file);
  EXPECT_EQ(read.folder_for_new_files(), folder.path());
  EXPECT_EQ(read.export_size, QSize(1920, 1080));
  EXPECT_EQ(read.export_rate, 12.5);
  EXPECT_EQ(read.film_rate, 30);
}

TEST(Preferences, AFolderThatIsGoneIsNotProposed) {
  Preferences preferences;
  preferences.folder = "/nowhere/at/all";
  EXPECT_EQ(preferences.folder_for_new_files(), QDir::homePath());
}

TEST(Preferences, NonsenseInTheFileDoesNoHarm) {
  QTemporaryDir folder;
  QSettings settings(folder.filePath("s.ini"), QSettings::IniFormat);
  settings.setValue("preferences/cache_mebibytes", -5);
  settings.setValue("preferences/threads", "many");
  settings.setValue("preferences/presenter", 99);
  settings.setValue("preferences/type_size", -3);
  settings.setValue("preferences/theme", "purple");
  settings.setValue("preferences/beginning", 7);
  settings.setValue("preferences/export_size", "big");
  settings.setValue("preferences/export_rate", -1);
  settings.setValue("preferences/film_rate", 100000);
  const Preferences read = read_preferences(settings);
  EXPECT_EQ(read.cache_mebibytes, Preferences::kSmallestCache);
  EXPECT_EQ(read.threads, 1);
  EXPECT_LE(static_cast<int>(read.presenter), 2);
  EXPECT_EQ(read.type_size, TypeSize::normal);
  EXPECT_EQ(read.theme, Theme::system);
  EXPECT_LE(static_cast<int>(read.beginning), 2);
  EXPECT_EQ(read.export_size, QSize(1280, 720));
  EXPECT_GT(read.export_rate, 0);
  EXPECT_EQ(read.film_rate, 60);
}

TEST_F(WindowTest, PreferencesDialogShowsAndGivesThemBack) {
  const Preferences given{1024, 1, PresenterKind::opengl, false};
  PreferencesDialog dialog(given, 3 << 20, window_.get());
  EXPECT_EQ(dialog.preferences().cache_mebibytes, 1024);
  EXPECT_EQ(dialog.preferences().presenter, PresenterKind::opengl);
  EXPECT_FALSE(dialog.preferences().ask_about_runs);
}

TEST_F(WindowTest, PreferencesDialogGivesBackLooksAndPictures) {
  Preferences given;
  given.type_size = TypeSize::larger;
  given.theme = Theme::light;
  given.beginning = Beginning::empty;
  given.folder = folder_.path();
  given.export_size = {640, 360};  // not among those that are offered
  given.export_rate = 50;
  given.film_rate = 30;
  PreferencesDialog dialog(given, 0, window_.get());
  const Preferences chosen = dialog.preferences();
  EXPECT_EQ(chosen.type_size, TypeSize::larger);
  EXPECT_EQ(chosen.theme, Theme::light);
  EXPECT_EQ(chosen.beginning, Beginning::empty);
  EXPECT_EQ(chosen.folder, folder_.path());
  EXPECT_EQ(chosen.export_size, QSize(640, 360));
  EXPECT_EQ(chosen.export_rate, 50);
  EXPECT_EQ(chosen.film_rate, 30);
}

TEST_F(WindowTest, TypeSizeAndColoursActAtOnceAndAfterARestart) {
  const double usual = window_->font().pointSizeF(), view_scale = window_->view_actions().options().annotation_scale;
  const auto looks = [&](double scale, bool dark) {
    return std::abs(window_->font().pointSizeF() - scale * usual) < 1e-6 && is_dark(window_->palette()) == dark;
  };
  window_->apply_preferences({.ask_about_runs = false, .type_size = TypeSize::largest, .theme = Theme::dark});
  EXPECT_TRUE(wait_until([&] { return looks(1.5, true); }, 5));
  // So do letters that are not the window system's: those of the view and the plots.
  EXPECT_NEAR(window_->view_actions().options().annotation_scale, 1.5 * view_scale, 1e-9);
  reopen();
  EXPECT_TRUE(looks(1.5, true));
  screenshot("dark_and_large");
  window_->apply_preferences({.ask_about_runs = false, .theme = Theme::light});
  EXPECT_TRUE(wait_until([&] { return looks(1, false); }, 5));
  window_->apply_preferences({.ask_about_runs = false});
  use_plain_look();
}

TEST_F(WindowTest, BeginsAsThePreferencesSay) {
  write_file("mine.toml", "name = \"mine\"\n");
  window_->begin();
  EXPECT_TRUE(window_->start_page().isVisible());
  window_->open(file("mine.toml"));
  window_->apply_preferences({.ask_about_runs = false, .beginning = Beginning::last_file});
  reopen();
  window_->begin();
  EXPECT_FALSE(window_->start_page().isVisible());
  EXPECT_EQ(window_->document().path(), file("mine.toml"));
  window_->apply_preferences({.ask_about_runs = false, .beginning = Beginning::empty});
  reopen();
  window_->begin();
  EXPECT_FALSE(window_->start_page().isVisible());
  EXPECT_TRUE(window_->document().path().isEmpty());
  // A file that is gone is no reason for an error.
  QFile::remove(file("mine.toml"));
  window_->apply_preferences({.ask_about_runs = false, .beginning = Beginning::last_file});
  window_->begin();
  EXPECT_TRUE(window_->start_page().isVisible());
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
