// The campaign dock: a campaign is defined, run in the background, stopped, gone on with, looked at, and a capture of
// it is taken over into the window.

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDir>
#include <QDockWidget>
#include <QElapsedTimer>
#include <QFile>
#include <QPushButton>
#include <QSpinBox>
#include <QTest>
#include <QToolButton>
#include <QUndoStack>
#include <algorithm>
#include <cstdio>
#include <set>

#include "engine/scenario/write_scenario.h"
#include "engine/study/read_study.h"
#include "engine/study/setting.h"
#include "engine/study/study_plan.h"
#include "gui/workbench/campaign/campaign_actions.h"
#include "gui/workbench/campaign/capture_map_view.h"
#include "gui/workbench/campaign/point_words.h"
#include "gui/workbench/campaign/scatter_row.h"
#include "gui/workbench/editor/number_edit.h"
#include "tests/gui/workbench/window_fixture.h"

namespace netpocket {
namespace {

// ---- what the form says becomes a study ----

StudyDraft full_draft() {
  StudyDraft draft;
  draft.base = "quick.toml";
  draft.inputs = {{"target.mass", Scatter::normal, 20},
                  {"target.position[0]", Scatter::uniform, 0.3},
                  {"target.inertia", Scatter::factor, 0.1},
                  {"target.spin", Scatter::direction, 0.2}};
  draft.samples = 12;
  draft.seed = 5;
  draft.estimate = {"smallest_gap"};
  draft.half_width = 0.05;
  return draft;
}

TEST(StudyDraft, IsReadByTheCommandLineAsItWasMeant) {
  const QTemporaryDir folder;
  const auto write = [&](const QString& name, const std::string& text) {
    QFile file(folder.filePath(name));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(QByteArray::fromStdString(text));
  };
  Scenario scenario = quick_scenario();
  scenario.target.position.x() = 0.1;
  write("quick.toml", write_scenario_text(scenario));
  write("study.toml", study_text(full_draft(), scenario));
  const StudyResult result = read_study_file(folder.filePath("study.toml").toStdString());
  ASSERT_TRUE(result.ok()) << result.diagnostics.text();
  const Study& study = result.study;
  EXPECT_EQ(study.samples, 12);
  EXPECT_EQ(study.seed, 5);
  EXPECT_EQ(study.sampling, Sampling::sobol);
  EXPECT_EQ(study.until.half_width, 0.05);
  EXPECT_EQ(study.estimate.of, std::vector<std::string>{"smallest_gap"});
  ASSERT_EQ(study.uncertain.size(), 4u);
  const auto number = [&](const std::string& key) {
    const auto is_it = [&](const UncertainInput& input) { return keys_of(input).front() == key; };
    return std::get<UncertainNumber>(*std::ranges::find_if(study.uncertain, is_it));
  };
  const auto mass = std::get<Normal>(number("target.mass").distribution);
  EXPECT_EQ(mass.mean, scenario.target.mass);
  EXPECT_EQ(mass.deviation, 20);
  const auto place = std::get<Uniform>(number("target.position[0]").distribution);
  EXPECT_EQ(place.min, -0.2);
  EXPECT_EQ(place.max, 0.4);
  EXPECT_TRUE(number("target.inertia").is_relative);
  const auto is_direction = [](const UncertainInput& input) {
    return std::holds_alternative<UncertainDirection>(input);
  };
  EXPECT_EQ(std::ranges::count_if(study.uncertain, is_direction), 1);
}

TEST(StudyDraft, SaysWhatKeepsItFromBeingAStudy) {
  const Scenario scenario = quick_scenario();
  EXPECT_FALSE(draft_problem(full_draft(), scenario));
  StudyDraft draft = full_draft();
  draft.inputs[0].spread = 0;
  EXPECT_EQ(draft_problem(draft, scenario), "target.mass needs a spread above 0.");
  draft = full_draft();
  draft.inputs.push_back({"target.spin[1]", Scatter::uniform, 0.1});
  EXPECT_EQ(draft_problem(draft, scenario), "target.spin is there twice: remove one.");
  draft = full_draft();
  draft.inputs[1].key = "net.colour";
  EXPECT_EQ(draft_problem(draft, scenario), "net.colour is no parameter of this scenario: remove it.");
  draft.inputs.clear();
  EXPECT_TRUE(draft_problem(draft, scenario));
}

TEST(StudyDraft, OffersWhatEachParameterCanDo) {
  const Scenario scenario = quick_scenario();
  const auto keys = scatter_keys(scenario);
  EXPECT_EQ(std::ranges::count(keys, "target.mass"), 1);
  EXPECT_EQ(std::ranges::count(keys, "target.position[2]"), 1);
  EXPECT_EQ(std::ranges::count(keys, "output.end_time"), 0) << "is nothing physical";
  EXPECT_EQ(possible_scatters(scenario, "target.spin"), (std::vector{Scatter::direction, Scatter::factor}));
  EXPECT_EQ(possible_scatters(scenario, "target.position[0]"), (std::vector{Scatter::uniform, Scatter::normal}))
      << "a factor of 0 does nothing";
  EXPECT_FALSE(draft_problem(usual_draft(scenario), scenario));
}

TEST(CampaignWords, AreThoseOfThePoint) {
  EXPECT_EQ(time_words(40.2), "41 s");
  EXPECT_EQ(time_words(16 * 60), "16 min");
  EXPECT_EQ(time_words(3 * 3600 + 20 * 60), "3 h 20 min");
  EXPECT_TRUE(estimate_words(1090, 2048).contains("<b>0.532</b>, 95 % interval 0.511 to 0.554: 1090 of 2048"));
  EXPECT_FALSE(estimate_words(0, 0).contains("nan"));
  StudyResults results;
  results.inputs = {{"target.mass", "kg", {201.5}}};
  results.measures = {{"escape_depth", "m", {-0.25}}};
  results.points = {17};
  results.captured = {0};
  const QString words = point_words(results, 0);
  for (const char* part : {"Point 17", "missed", "target.mass", "201.5", "kg", "escape_depth"}) {
    EXPECT_TRUE(words.contains(part)) << part;
  }
}

// ---- the window ----

double resident_megabytes() {
  QFile status("/proc/self/status");
  if (!status.open(QIODevice::ReadOnly)) return 0;
  const QByteArray text = status.readAll();
  return text.mid(text.indexOf("VmRSS:") + 6).trimmed().split(' ').front().toDouble() / 1024;
}

class CampaignTest : public WindowTest {
 protected:
  CampaignTest() {
    EXPECT_FALSE(window_->document().save_as(file("quick.toml")));
    StudyDraft draft = usual_draft(window_->document().scenario());
    draft.inputs[0].spread = draft.inputs[1].spread = 0.2;
    draft.samples = 10;
    panel().form()->set_draft(draft);
    panel().form()->set_jobs(1);  // so that it takes a while on any machine
  }

  CampaignPanel& panel() { return window_->campaign(); }
  CampaignView& view() { return *panel().view(); }
  CampaignActions& actions() { return window_->campaign_actions(); }

  // One that will not be done before it is stopped.
  void make_it_long() { panel().form()->samples()->setValue(200); }
  // Defines a campaign as the form has it and runs it.
  bool run_campaign(const QString& name = "campaign") {
    if (!actions().save_study(file(name + ".toml"))) return false;
    actions().run_study(file(name + ".toml"), file(name));
    return actions().campaign() != nullptr;
  }
  std::size_t rows() const {
    const Campaign* campaign = window_->campaign_actions().campaign();
    return campaign != nullptr && campaign->results() != nullptr ? campaign->results()->results().size() : 0;
  }
  bool wait_for_end() {
    return wait_until([&] { return actions().campaign()->is_complete() && rows() == 10; }, 120);
  }
};

TEST_F(CampaignTest, IsDefinedRunAndShown) {
  EXPECT_TRUE(window_->findChild<QDockWidget*>("campaign")->isHidden());
  window_->findChild<QDockWidget*>("campaign")->show();
  window_->findChild<QDockWidget*>("campaign")->raise();
  screenshot("campaign_form");
  EXPECT_FALSE(panel().shows_campaign());
  ASSERT_TRUE(run_campaign()) << panel().problem().toStdString();
  EXPECT_TRUE(panel().shows_campaign());
  EXPECT_TRUE(actions().campaign()->is_running());
  EXPECT_EQ(view().stop_button()->text(), "Stop");
  EXPECT_FALSE(view().leave_button()->isEnabled());
  ASSERT_TRUE(wait_until([&] { return rows() > 0; }, 60));
  EXPECT_TRUE(view().state_text().startsWith("Running: ")) << view().state_text().toStdString();
  ASSERT_TRUE(wait_for_end());
  ASSERT_TRUE(wait_until([&] { return view().state_text().startsWith("Done: 10 of 10 points"); }));
  EXPECT_TRUE(wait_until([&] { return view().estimate_text().contains("of 10 captured"); }))
      << view().estimate_text().toStdString();
  EXPECT_TRUE(QFile::exists(file("campaign/study.csv")));
  EXPECT_TRUE(QFile::exists(file("campaign/study_estimates.csv")));
  EXPECT_FALSE(view().stop_button()->isEnabled());
  EXPECT_EQ(view().x_axis()->count(), 4);
  EXPECT_EQ(view().map()->x()->name, "target.position[0]");
  for (int i = 0; i < view().pictures()->count(); ++i) view().pictures()->setCurrentIndex(i);
  screenshot("campaign_pairs");
  view().pictures()->setCurrentIndex(0);
  screenshot("campaign_done");
}

TEST_F(CampaignTest, StopsAndGoesOn) {
  make_it_long();
  ASSERT_TRUE(run_campaign());
  ASSERT_TRUE(wait_until([&] { return rows() >= 2; }, 60));
  view().stop_button()->click();
  EXPECT_EQ(view().state_text().left(8), "Stopping");
  ASSERT_TRUE(wait_until([&] { return !actions().campaign()->is_running(); }, 60));
  EXPECT_EQ(panel().problem(), "");
  const std::size_t kept = rows();
  ASSERT_LT(kept, 200u) << "the test has come too late";
  EXPECT_GE(kept, 2u);
  EXPECT_TRUE(view().state_text().startsWith("Not complete: ")) << view().state_text().toStdString();
  EXPECT_EQ(view().stop_button()->text(), "Go on");
  EXPECT_TRUE(QFile::exists(file("campaign/study.csv"))) << "what is done is in the tables";
  view().stop_button()->click();
  EXPECT_TRUE(actions().campaign()->is_running());
  ASSERT_TRUE(wait_until([&] { return rows() >= kept + 2; }, 60));
  std::multiset<std::size_t> points;
  RecordFollower records(file("campaign").toStdString());
  for (const FollowedRecord& record : records.read_new()) points.insert(record.place.point);
  EXPECT_EQ(std::set(points.begin(), points.end()).size(), points.size()) << "none was run again";
}

TEST_F(CampaignTest, OpensAFolderThatSomebodyElseMade) {
  ASSERT_TRUE(run_campaign());
  ASSERT_TRUE(wait_for_end());
  view().leave_button()->click();
  EXPECT_FALSE(panel().shows_campaign());
  EXPECT_EQ(actions().campaign(), nullptr);
  window_->open(file("campaign"));  // as from the command line, or dropped
  ASSERT_TRUE(wait_until([&] { return rows() == 10; }));
  ASSERT_TRUE(wait_until([&] { return view().state_text().startsWith("Done: 10 of 10"); }));
  EXPECT_FALSE(view().state_text().contains("minute")) << "nothing was run";
  // Also in a window that begins with it: the panel is in front.
  window_.reset();
  window_ = std::make_unique<MainWindow>(options_);
  window_->open(file("campaign"));
  window_->show();
  ASSERT_TRUE(wait_until([&] { return rows() == 10 && !view().visibleRegion().isEmpty(); }));
  actions().open_folder(folder_.path());
  EXPECT_TRUE(panel().problem().contains("holds no study")) << panel().problem().toStdString();
  EXPECT_NE(actions().campaign(), nullptr) << "what was there stays";
}

// As many points as NETPOCKET_LARGE_CAMPAIGN says, 100000, say: copies of a few records. Prints time and memory.
TEST_F(CampaignTest, OpensALargeFolder) {
  ASSERT_TRUE(run_campaign());
  ASSERT_TRUE(wait_for_end());
  view().leave_button()->click();
  const int points = std::max(5000, qEnvironmentVariableIntValue("NETPOCKET_LARGE_CAMPAIGN"));
  QFile records(file("campaign/records/1_of_1.jsonl"));
  ASSERT_TRUE(records.open(QIODevice::ReadWrite));
  const QByteArrayList lines = records.readAll().trimmed().split('\n');
  for (int point = 11; point <= points; ++point) {
    const QByteArray& line = lines[point % lines.size()];
    records.write("{\"point\":" + QByteArray::number(point) + line.mid(line.indexOf(',')) + "\n");
  }
  records.close();
  QFile manifest(file("campaign/study_manifest.json"));
  ASSERT_TRUE(manifest.open(QIODevice::ReadWrite));
  const QByteArray text =
      manifest.readAll().replace("\"points\": 10,", "\"points\": " + QByteArray::number(points) + ",");
  manifest.resize(0);
  manifest.write(text);
  manifest.close();

  const double before = resident_megabytes();
  QElapsedTimer time;
  time.start();
  window_->open(file("campaign"));
  double most = 0;
  ASSERT_TRUE(wait_until(
      [&] {
        most = std::max(most, resident_megabytes());
        return rows() == static_cast<std::size_t>(points);
      },
      600));
  ASSERT_TRUE(wait_until([&] { return view().state_text().contains(QString("%1 of %1 points").arg(points)); }, 60));
  const double opened = 1e-3 * static_cast<double>(time.restart());
  EXPECT_FALSE(view().map()->grab().isNull());
  std::printf("%d points: opened in %.1f s with %.0f MB more, the map drawn in %.2f s\n", points, opened, most - before,
              1e-3 * static_cast<double>(time.elapsed()));
  // Numbers of the points, and batches of records that are under way.
  EXPECT_LT(most - before, 300 + 3e-3 * points);
  screenshot("campaign_large");
}

TEST_F(CampaignTest, ACaptureIsOpenedAndMadeTheScenario) {
  ASSERT_TRUE(run_campaign());
  ASSERT_TRUE(wait_for_end());
  ASSERT_TRUE(wait_until([&] { return view().x_axis()->count() == 4; }));
  ASSERT_TRUE(wait_until([&] { return !view().grab().isNull() && view().map()->place_of(3).has_value(); }));
  const StudyResults& results = actions().campaign()->results()->results();
  const auto value = [&](const char* key, std::size_t row) { return results.find(key)->values[row]; };
  // A click on a capture's place chooses it and says what it is.
  std::size_t row = 3;
  QTest::mouseClick(view().map(), Qt::LeftButton, {}, view().map()->place_of(row)->toPoint());
  ASSERT_TRUE(view().map()->chosen());
  row = *view().map()->chosen();
  EXPECT_TRUE(view().point_text().contains(QString("Point %1").arg(results.points[row])));
  EXPECT_TRUE(view().open_button()->isVisibleTo(&view()));
  screenshot("campaign_chosen");

  view().open_button()->click();
  const netpocket::Run* run = window_->session().current();
  ASSERT_NE(run, nullptr);
  EXPECT_NEAR(run->scenario.target.mass, value("target.mass", row), 1e-9);
  EXPECT_NEAR(run->scenario.target.position.z(), value("target.position[2]", row), 1e-9);
  EXPECT_TRUE(run->name.contains(QString("point %1").arg(results.points[row]))) << run->name.toStdString();
  ASSERT_TRUE(wait_until([&] { return window_->session().live()->state == RunState::ended; }, 60));

  auto& document = window_->document();
  const Scenario before = document.scenario();
  view().adopt_button()->click();
  EXPECT_NEAR(document.scenario().target.mass, value("target.mass", row), 1e-9);
  EXPECT_NEAR(document.scenario().target.position.x(), value("target.position[0]", row), 1e-9);
  EXPECT_EQ(document.scenario().name, before.name);
  EXPECT_EQ(document.undo_stack()->count(), 1);
  document.undo_stack()->undo();
  EXPECT_EQ(write_scenario_text(document.scenario()), write_scenario_text(before));

  // The keys go from point to point, by number.
  view().map()->choose(std::nullopt);
  QTest::keyClick(view().map(), Qt::Key_Right);
  ASSERT_TRUE(view().map()->chosen());
  EXPECT_EQ(results.points[*view().map()->chosen()], 1);
  QTest::keyClick(view().map(), Qt::Key_Right);
  EXPECT_EQ(results.points[*view().map()->chosen()], 2);
  QTest::keyClick(view().map(), Qt::Key_Escape);
  EXPECT_FALSE(view().map()->chosen());
}

TEST_F(CampaignTest, FollowsADarkDesktop) {
  ASSERT_TRUE(run_campaign());
  ASSERT_TRUE(wait_for_end());
  ASSERT_TRUE(wait_until([&] { return view().map()->x() != nullptr; }));
  const auto corner = [&] { return view().map()->grab().toImage().pixelColor(2, 2).lightness(); };
  EXPECT_GT(corner(), 200);
  const QPalette light = QApplication::palette();
  QPalette dark(QColor(45, 48, 54), QColor(38, 41, 46));
  dark.setColor(QPalette::Base, QColor(30, 32, 36));
  QApplication::setPalette(dark);
  EXPECT_TRUE(wait_until([&] { return corner() < 60; }));
  view().map()->choose(2);
  screenshot("campaign_dark");
  view().leave_button()->click();
  screenshot("campaign_form_dark");
  QApplication::setPalette(light);
}

TEST_F(CampaignTest, TheWindowAsksBeforeItStopsOne) {
  make_it_long();
  ASSERT_TRUE(run_campaign());
  ASSERT_TRUE(wait_until([&] { return rows() >= 1; }, 60));
  answer_question(QMessageBox::Cancel);
  EXPECT_FALSE(actions().may_close());
  EXPECT_TRUE(actions().campaign()->is_running());
  answer_question(QMessageBox::Discard);
  EXPECT_TRUE(actions().may_close());
  window_.reset();  // stops it
  const StudyManifest manifest = read_study_manifest(file("campaign").toStdString());
  RecordFollower records(file("campaign").toStdString());
  EXPECT_GE(records.read_new().size(), 1u);
  EXPECT_EQ(manifest.points, 200u);
}

TEST_F(CampaignTest, SaysWhatIsWrong) {
  StudyForm& form = *panel().form();
  form.set_draft({});
  EXPECT_FALSE(actions().save_study(file("empty.toml")));
  EXPECT_EQ(panel().problem(), "Nothing is uncertain: add an input.");
  EXPECT_FALSE(QFile::exists(file("empty.toml")));
  form.add_input({"target.mass", Scatter::normal, 20});
  EXPECT_FALSE(actions().save_study(file("quick.toml")));
  EXPECT_TRUE(panel().problem().contains("is the scenario itself"));
  EXPECT_FALSE(actions().save_study(file("nowhere/study.toml")));
  EXPECT_TRUE(panel().problem().startsWith("Cannot write")) << panel().problem().toStdString();
  EXPECT_TRUE(actions().save_study(file("good.toml"))) << panel().problem().toStdString();
  EXPECT_EQ(panel().problem(), "");
  // A folder of somebody else is left alone, and the command says so.
  QDir(folder_.path()).mkdir("theirs");
  write_file("theirs/letter.txt", "Dear");
  actions().run_study(file("good.toml"), file("theirs"));
  ASSERT_TRUE(wait_until([&] { return !panel().problem().isEmpty(); }, 30));
  EXPECT_EQ(QDir(file("theirs")).entryList(QDir::Files), QStringList{"letter.txt"});
}

TEST_F(CampaignTest, InputsAreAddedAndRemoved) {
  StudyForm& form = *panel().form();
  ASSERT_EQ(form.rows().size(), 4u);
  form.rows()[0]->remove_button()->click();
  ASSERT_EQ(form.rows().size(), 3u);
  EXPECT_EQ(form.rows()[0]->input().key, "target.position[2]");
  form.rows()[0]->spread()->set_value(0.7);
  EXPECT_EQ(form.draft().inputs[0].spread, 0.7);
  EXPECT_EQ(scatter_label(window_->document().scenario(), "target.position[2]").right(2), " z");
}

TEST(CampaignFolder, IsOneThatIsNotThereYet) {
  const QTemporaryDir folder;
  EXPECT_EQ(unused_results_folder(folder.filePath("a.toml")), folder.filePath("a_results"));
  QDir(folder.path()).mkdir("a_results");
  EXPECT_EQ(unused_results_folder(folder.filePath("a.toml")), folder.filePath("a_results_2"));
}

}  // namespace
}  // namespace netpocket
