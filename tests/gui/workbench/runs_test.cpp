#include <QFile>

#include "engine/scenario/parameters.h"
#include "engine/scenario/write_scenario.h"
#include "gui/workbench/editor/scenario_editor.h"
#include "gui/workbench/run_actions.h"
#include "gui/workbench/session/frame_cache.h"
#include "gui/workbench/session/run_library.h"
#include "gui/workbench/viewport/viewport.h"
#include "tests/gui/workbench/window_fixture.h"

namespace netpocket {
namespace {

std::shared_ptr<const Snapshot> frame_of(double time) {
  auto frame = std::make_shared<Snapshot>();
  frame->time = time;
  frame->positions.setZero(3, 100);
  return frame;
}

TEST(FrameCache, KeepsWhatWasUsedLastWithinItsBytes) {
  const std::size_t size = frame_bytes(*frame_of(0));
  FrameCache cache(3 * size);
  for (std::size_t i = 0; i < 3; ++i) cache.add(0, i, frame_of(0));
  EXPECT_TRUE(cache.find(0, 0));
  cache.add(0, 3, frame_of(0));
  EXPECT_TRUE(cache.find(0, 0));
  EXPECT_FALSE(cache.find(0, 1));
  EXPECT_LE(cache.bytes(), 3 * size);
  cache.forget(0);
  EXPECT_EQ(cache.bytes(), 0u);
}

// Frames that no longer fit in memory come from the recording.
TEST_F(WindowTest, FramesBeyondTheCacheComeFromTheFile) {
  ASSERT_TRUE(run_to(0.6));
  auto& session = window_->session();
  auto& runs = session.runs();
  const RunId id = session.current()->id;
  const Eigen::Matrix3Xd positions = runs.frame(id, 5)->positions;
  runs.frame(id, 6);  // the frame used last stays in any case
  runs.set_cache_bytes(1);
  ASSERT_FALSE(runs.frame(id, 5));
  std::shared_ptr<const Snapshot> frame;
  ASSERT_TRUE(wait_until([&] { return (frame = runs.frame(id, 5)) != nullptr; }));
  // Recordings hold positions in single precision (engine/recording/FORMAT.md): 6e-8 of at most 20 m.
  EXPECT_LT((frame->positions - positions).cwiseAbs().maxCoeff(), 2e-6);
}

// The picture of an edited scenario that was asked for before the run, and comes when it has ended.
TEST_F(WindowTest, LatePreviewDoesNotHideTheRun) {
  ASSERT_TRUE(run_to(0.3));
  auto* editor = window_->findChild<ScenarioEditor*>();
  ASSERT_NE(editor, nullptr);
  const auto shows_the_run = [&] {
    return window_->viewport().state().structure == window_->session().current()->structure;
  };
  ASSERT_TRUE(wait_until(shows_the_run));
  const auto preview_passes = [&] {
    emit editor->preview(window_->document().scenario());
    return !wait_until([&] { return !shows_the_run(); }, 0.5);
  };
  EXPECT_TRUE(preview_passes());
  ASSERT_FALSE(window_->document().set_value(*find_parameter("net.diameter"), 0.005));
  EXPECT_TRUE(wait_until([&] { return !shows_the_run(); })) << "an edited scenario is shown";
}

TEST_F(WindowTest, RunSavedAsARecordingOpensAgain) {
  ASSERT_TRUE(run_to(0.3));
  auto& session = window_->session();
  const auto times = session.current()->series.times();
  session.runs().save(session.current()->id, file("saved.h5"));
  ASSERT_TRUE(wait_until([&] { return QFile::exists(file("saved.h5")); }));
  session.runs().finish_writing();
  window_->open(file("saved.h5"));
  ASSERT_TRUE(wait_until([&] { return session.current() && !session.current()->simulated_here; }));
  EXPECT_EQ(session.current()->series.times().size(), times.size());
  EXPECT_EQ(session.current()->scenario.name, "quick");
  window_->open(file("saved.h5"));
  ASSERT_TRUE(wait_until([&] { return session.runs().ids().size() == 3; }));
  EXPECT_EQ(session.current()->name, "saved (2)") << "names tell runs apart";
}

// Its start is read from the file first; what is asked for in the meantime is not for the run before.
TEST_F(WindowTest, BranchOfARecordingGoesOnAtOnce) {
  ASSERT_TRUE(run_to(0.3));
  auto& session = window_->session();
  const RunId before = session.current()->id;
  session.runs().save(before, file("saved.h5"));
  ASSERT_TRUE(wait_until([&] { return session.runs().unsaved().empty(); }));
  window_->open(file("saved.h5"));
  ASSERT_TRUE(wait_until([&] { return !session.current()->simulated_here; }));
  session.show_time(0.2);
  ASSERT_TRUE(session.branch(window_->document().scenario()));
  session.resume({.until = 0.4});
  ASSERT_TRUE(wait_until([&] { return session.live()->end_time() >= 0.4 - 1e-6; }));
  EXPECT_EQ(session.live(), session.current());
  EXPECT_NEAR(session.runs().find(before)->end_time(), 0.3, 1e-6);
  EXPECT_EQ(session.runs().find(before)->state, RunState::recorded);
}

// The recording holds the mesh: its file may be gone.
TEST_F(WindowTest, BranchOfARecordingWithAMesh) {
  Scenario scenario = quick_scenario();
  scenario.target.shape = TargetShape::mesh;
  scenario.target.mesh_file = "body.obj";
  const auto write = [](const QString& path, const std::string& text) {
    QFile out(path);
    return out.open(QIODevice::WriteOnly) && out.write(text.data(), static_cast<qint64>(text.size())) > 0;
  };
  ASSERT_TRUE(write(file("body.obj"), "v 0 0 0\nv 3 0 0\nv 0 3 0\nv 0 0 3\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n"));
  ASSERT_TRUE(write(file("mine.toml"), write_scenario_text(scenario)));
  window_->open(file("mine.toml"));
  ASSERT_TRUE(run_to(0.3));
  auto& session = window_->session();
  // A branch of the run that goes on, and one of its recording.
  ASSERT_TRUE(QFile::remove(file("body.obj")));
  session.runs().save(session.current()->id, file("saved.h5"));
  ASSERT_TRUE(wait_until([&] { return session.runs().unsaved().empty(); }));
  Scenario faster = window_->document().scenario();
  faster.closing.duration = 0.6;
  session.show_time(0.2);
  for (int branches = 0; branches < 2; ++branches) {
    ASSERT_TRUE(session.branch(faster));
    session.resume({.until = 0.4});
    ASSERT_TRUE(wait_until([&] { return session.live() && session.live()->end_time() >= 0.4 - 1e-6; }));
  }
  window_->open(file("saved.h5"));
  ASSERT_TRUE(wait_until([&] { return session.current() && !session.current()->simulated_here; }));
  EXPECT_TRUE(window_->scenario_to_run()) << "the recorded scenario can be simulated";
  session.show_time(0.2);
  ASSERT_TRUE(session.branch(window_->document().scenario()));
  session.resume({.until = 0.4});
  ASSERT_TRUE(wait_until([&] { return session.live() && session.live()->end_time() >= 0.4 - 1e-6; }));
}

// Every frame that is listed of a run that was left in full speed is in its recording.
TEST_F(WindowTest, RunThatIsLeftKeepsItsLastFrames) {
  window_->run_actions().restart();
  auto& session = window_->session();
  ASSERT_TRUE(wait_until([&] { return session.live()->frame_count() > 10; }));
  const RunId left = session.live()->id;
  window_->run_actions().restart();
  ASSERT_TRUE(wait_until([&] { return session.runs().find(left)->state == RunState::recorded; }));
  const auto& run = *session.runs().find(left);
  session.runs().finish_writing();
  EXPECT_EQ(Recording(run.file->path()).frame_count(), run.frame_count());
}

}  // namespace
}  // namespace netpocket
