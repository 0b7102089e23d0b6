// Files that are damaged, foreign or in the way, and disks that are full: one sentence in the window, and nothing lost.
#include <sys/resource.h>

#include <QDir>
#include <QFile>
#include <algorithm>
#include <csignal>

#include "engine/recording/recording.h"
#include "gui/workbench/editor/message_bar.h"
#include "gui/workbench/editor/parameter_form.h"
#include "gui/workbench/editor/scenario_editor.h"
#include "gui/workbench/editor/text_page.h"
#include "gui/workbench/editor/toml_edit_view.h"
#include "gui/workbench/file_actions.h"
#include "gui/workbench/panels/findings_panel.h"
#include "gui/workbench/run_file_actions.h"
#include "gui/workbench/viewport/viewport.h"
#include "tests/gui/workbench/window_fixture.h"

namespace netpocket {
namespace {

class WindowFaults : public WindowTest {
 protected:
  // The recording of a short run, which is open afterwards.
  RunId open_recording(const QString& name) {
    EXPECT_TRUE(run_to(0.1));
    auto& runs = window_->session().runs();
    runs.save(window_->session().current()->id, file(name));
    EXPECT_TRUE(wait_until([&] { return runs.unsaved().empty(); }));
    const std::size_t before = runs.ids().size();
    window_->open(file(name));
    EXPECT_TRUE(wait_until([&] { return runs.ids().size() > before; }));
    return runs.ids().back();
  }

  QByteArray content(const QString& name) const {
    QFile in(file(name));
    return in.open(QIODevice::ReadOnly) ? in.readAll() : QByteArray("cannot be read");
  }

  // The notice comes, is one sentence and holds these parts.
  void expect_notice(const QStringList& parts, const QString& picture) {
    const auto is_it = [&] {
      return std::ranges::all_of(parts, [&](const QString& part) { return window_->notice().contains(part); });
    };
    EXPECT_TRUE(wait_until(is_it)) << picture.toStdString() << ": " << window_->notice().toStdString();
    EXPECT_FALSE(window_->notice().contains('\n')) << window_->notice().toStdString();
    screenshot(picture);
  }
};

// Limits the size of files that this program and those that it starts may write: a full disk.
class FullDisk {
 public:
  explicit FullDisk(rlim_t bytes) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit = {bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
    handler_ = std::signal(SIGXFSZ, SIG_IGN);
  }
  ~FullDisk() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;

 private:
  rlimit before_ = {};
  void (*handler_)(int) = SIG_DFL;
};

TEST_F(WindowFaults, OfFilesThatCannotBeOpened) {
  open_recording("whole.h5");
  const QByteArray whole = content("whole.h5");
  write_file("cut.h5", whole.first(whole.size() / 2));
  write_file("text.h5", "my notes\n");
  write_file("whole.dat", whole);
  write_file("picture.png", "\x89PNG\r\n\x1a\n....");
  write_file("cube.obj", "# cube\nv 0 0 0\nv 1 0 0\n");
  write_file("wrong.toml", "[closing]\ndurration = 5\n");
  QDir(folder_.path()).mkdir("folder");
  const std::size_t runs = window_->session().runs().ids().size();
  const std::pair<QString, QString> files[] = {{"cut.h5", "damaged"},
                                               {"text.h5", "not an HDF5 file"},
                                               {"picture.png", "is a PNG picture, not a scenario"},
                                               {"cube.obj", "is an OBJ mesh, not a scenario"},
                                               {"wrong.toml", "did you mean"},
                                               {"missing.toml", "no such file"},
                                               {"missing.h5", "No such file"},
                                               {"folder", "is a folder"}};
  for (const auto& [name, part] : files) {
    window_->open(file(name));
    expect_notice({name, part}, "cannot_open_" + name);
  }
  EXPECT_EQ(window_->session().runs().ids().size(), runs);
  EXPECT_EQ(window_->document().scenario().name, "quick");
  // A recording is known by what it holds.
  window_->open(file("whole.dat"));
  EXPECT_TRUE(wait_until([&] { return window_->session().runs().ids().size() == runs + 1; }));
  EXPECT_EQ(window_->notice(), QString());
}

TEST_F(WindowFaults, OfScenariosThatCannotBeSimulatedAreSaidOnOpening) {
  ASSERT_TRUE(wait_until([&] { return window_->viewport().state().complete(); }));
  write_file("lost_mesh.toml", "[target]\nshape = \"mesh\"\nmesh_file = \"gone.obj\"\n");
  window_->open(file("lost_mesh.toml"));
  EXPECT_EQ(window_->document().scenario().target.mesh_file, "gone.obj");
  expect_notice({file("lost_mesh.toml") + ":3: target.mesh_file: \"gone.obj\" does not exist"}, "lost_mesh");
  EXPECT_FALSE(window_->viewport().state().complete()) << "the picture of another scenario would pass for this one's";
  write_file("gone.obj", "v 0 0 0\nv 2 0 0\nv 0 2 0\nv 0 0 2\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
  window_->open(file("lost_mesh.toml"));
  EXPECT_EQ(window_->notice(), QString());
  EXPECT_TRUE(wait_until([&] { return window_->viewport().state().complete(); }));
}

TEST_F(WindowFaults, OfTextsAreThereToBeMended) {
  ASSERT_TRUE(wait_until([&] { return window_->viewport().state().complete(); }));
  write_file("wrong.toml", "# mine\n[closing]\ndurration = 5\n");
  window_->open(file("wrong.toml"));
  expect_notice({file("wrong.toml") + ":3: closing.durration: is not a parameter; did you mean 'closing.duration'?"},
                "to_be_mended");
  EXPECT_FALSE(window_->viewport().state().complete());
  TextPage* text = window_->editor().text_page();
  EXPECT_EQ(text->view()->toPlainText(), "# mine\n[closing]\ndurration = 5\n");
  EXPECT_TRUE(text->isVisible());
  EXPECT_EQ(text->view()->marked_lines().count(3), 1u);
  EXPECT_FALSE(window_->editor().form()->isEnabled()) << "it shows another scenario";
  EXPECT_TRUE(window_->editor().text_bar()->text().contains("wrong.toml"));
  // Neither a run nor a save takes the scenario before for it.
  EXPECT_EQ(window_->scenario_to_run(), std::nullopt);
  EXPECT_FALSE(window_->file_actions().save());
  EXPECT_EQ(window_->document().scenario().name, "quick");
  text->view()->setPlainText("# mine\n[closing]\nduration = 5\n");
  EXPECT_TRUE(window_->editor().commit());
  EXPECT_EQ(window_->notice(), QString());
  EXPECT_EQ(window_->document().path(), file("wrong.toml"));
  EXPECT_EQ(window_->document().scenario().name, "wrong");
  EXPECT_EQ(window_->document().scenario().closing.duration, 5);
  EXPECT_TRUE(window_->document().is_modified());
  EXPECT_TRUE(window_->file_actions().save());
  EXPECT_EQ(content("wrong.toml"), "# mine\n[closing]\nduration = 5\n");
  EXPECT_TRUE(wait_until([&] { return window_->viewport().state().complete(); }));
}

TEST_F(WindowFaults, OfATextThatIsGivenUpLeaveTheScenarioBefore) {
  const QString before = window_->document().text();
  write_file("wrong.toml", "[closing]\r\nduration = \r\n");
  window_->open(file("wrong.toml"));
  EXPECT_TRUE(window_->notice().contains("wrong.toml:2")) << window_->notice().toStdString();
  window_->editor().text_page()->discard();
  EXPECT_EQ(window_->notice(), QString());
  EXPECT_EQ(window_->editor().text_page()->view()->toPlainText(), before);
  EXPECT_TRUE(window_->editor().form()->isEnabled());
  EXPECT_TRUE(wait_until([&] { return window_->viewport().state().complete(); }));
  // So does another scenario, be it the same as before.
  window_->open(file("wrong.toml"));
  window_->document().start_from(quick_scenario());
  EXPECT_TRUE(window_->editor().text_page()->mended_path().isEmpty());
  EXPECT_TRUE(window_->editor().commit());
  EXPECT_EQ(window_->document().scenario().name, "quick");
}

TEST_F(WindowFaults, OfDroppedFilesAreSaid) {
  write_file("picture.png", "\x89PNG\r\n\x1a\n....");
  write_file("cube.stl", "solid cube\nfacet normal 0 0 1\n");
  for (const auto& [name, part] : {std::pair("picture.png", "is a PNG picture"), {"cube.stl", "is an STL mesh"}}) {
    drop({file(name)});
    expect_notice({name, part}, QString("dropped_") + name);
  }
}

TEST_F(WindowFaults, SavesLeaveFilesOfAnotherKind) {
  const RunId run = open_recording("run.h5");
  const QByteArray recorded = content("run.h5");
  write_file("bare", recorded);
  write_file("mine.toml", "name = \"mine\"\n[net]\ndiameter = 0.004\n");
  const QByteArray scenario = content("mine.toml");
  for (const QString name : {"run.h5", "bare"}) {
    const auto problem = window_->document().save_as(file(name));
    ASSERT_TRUE(problem.has_value()) << name.toStdString();
    EXPECT_TRUE(problem->contains(name)) << problem->toStdString();
  }
  const auto* findings = window_->findChild<FindingsPanel*>();
  for (const QString name : {"run.h5", "bare", "mine.toml"}) {
    EXPECT_TRUE(findings->export_findings(file(name)).has_value()) << name.toStdString();
  }
  window_->session().runs().save(run, file("mine.toml"));
  expect_notice({"mine.toml", "names another format"}, "save_over_scenario");
  EXPECT_EQ(content("run.h5"), recorded);
  EXPECT_EQ(content("bare"), recorded);
  EXPECT_EQ(content("mine.toml"), scenario);
}

TEST_F(WindowFaults, SavesLeaveTheRecordingsOfOtherRuns) {
  open_recording("run.h5");
  const QByteArray recorded = content("run.h5");
  ASSERT_TRUE(run_to(0.1));
  window_->session().runs().save(window_->session().current()->id, file("run.h5"));
  expect_notice({"run.h5", "is the recording of the run \"run\""}, "save_over_recording");
  EXPECT_EQ(content("run.h5"), recorded);
  EXPECT_EQ(window_->session().runs().unsaved().size(), 1u);
}

TEST_F(WindowFaults, SavesFollowLinksAndKeepPermissions) {
  write_file("real.toml", "name = \"old\"\n");
  QFile::link(file("real.toml"), file("link.toml"));
  ASSERT_TRUE(QFile::setPermissions(file("real.toml"), QFile::ReadOwner | QFile::WriteOwner));
  const auto before = QFile::permissions(file("real.toml"));
  EXPECT_EQ(window_->document().save_as(file("link.toml")), std::nullopt);
  EXPECT_TRUE(QFileInfo(file("link.toml")).isSymLink());
  EXPECT_EQ(QFile::permissions(file("real.toml")), before);
  ASSERT_TRUE(QFile::setPermissions(file("real.toml"), QFile::ReadOwner));
  const auto problem = window_->document().save_as(file("real.toml"));
  ASSERT_TRUE(problem.has_value());
  EXPECT_TRUE(problem->contains("read-only")) << problem->toStdString();
}

TEST_F(WindowFaults, OfFoldersThatTakeNothing) {
  const RunId run = open_recording("run.h5");
  for (const QString place : {"/proc/no", "/no/such/folder/no"}) {
    window_->session().runs().save(run, place + ".h5");
    expect_notice({place + ".h5"}, "read_only_folder");
    EXPECT_TRUE(window_->document().save_as(place + ".toml")->contains(place));
  }
}

TEST_F(WindowFaults, OfAFullDisk) {
  const RunId run = open_recording("run.h5");
  ASSERT_EQ(window_->document().save_as(file("mine.toml")), std::nullopt);
  const QByteArray saved = content("mine.toml");
  const QStringList before = QDir(folder_.path()).entryList({"*.toml", "*.h5", "*.csv", "*.part*", ".*"}, QDir::Files);
  {
    const FullDisk full(100);
    window_->session().runs().save(run, file("copy.h5"));
    expect_notice({"copy.h5", "File too large"}, "full_disk_save");
    window_->session().show_run(run);
    const QString target = file("table");
    window_->run_files().export_run(
        [&](const QString& recording) {
          return QStringList{"export", recording, "--csv", target};
        },
        "table", target);
    expect_notice({"channels.csv", "File too large"}, "full_disk_export");
    ASSERT_FALSE(window_->document().set_value(*find_parameter("closing.duration"), 3.0));
    const auto problem = window_->document().save();
    ASSERT_TRUE(problem.has_value());
    EXPECT_TRUE(problem->contains("mine.toml")) << problem->toStdString();
  }
  EXPECT_EQ(content("mine.toml"), saved);
  EXPECT_TRUE(window_->document().is_modified());
  EXPECT_EQ(QDir(folder_.path()).entryList({"*.toml", "*.h5", "*.csv", "*.part*", ".*"}, QDir::Files), before);
}

}  // namespace
}  // namespace netpocket
