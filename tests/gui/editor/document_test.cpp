#include <gtest/gtest.h>

#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>

#include "engine/scenario/read_scenario.h"
#include "gui/workbench/editor/presets.h"
#include "temporary_document.h"

namespace netpocket {
namespace {

TEST(ScenarioDocument, StartsValidUnmodifiedAndUntitled) {
  TemporaryDocument document;
  EXPECT_FALSE(document->is_modified());
  EXPECT_TRUE(document->path().isEmpty());
  EXPECT_EQ(document->display_name(), "untitled");
  EXPECT_TRUE(document->diagnostics().ok()) << document->diagnostics().text();
  EXPECT_EQ(document->scenario().target.radius, 4.5);
}

TEST(ScenarioDocument, EditUndoRedo) {
  TemporaryDocument document;
  QSignalSpy changed(&*document, &ScenarioDocument::changed);
  QSignalSpy modified(&*document, &ScenarioDocument::modified_changed);
  EXPECT_FALSE(document->set_value(parameter("target.radius"), 4.0));
  EXPECT_EQ(document->scenario().target.radius, 4.0);
  EXPECT_TRUE(document->is_modified());
  ASSERT_EQ(changed.size(), 1);
  EXPECT_EQ(changed[0][0].toStringList(), QStringList{"target.radius"});
  EXPECT_EQ(document->undo_stack()->undoText(), "set Target: radius to 4 m");
  document->undo_stack()->undo();
  EXPECT_EQ(document->scenario().target.radius, 4.5);
  EXPECT_FALSE(document->is_modified());
  document->undo_stack()->redo();
  EXPECT_EQ(document->scenario().target.radius, 4.0);
  EXPECT_EQ(modified.size(), 3);
}

TEST(ScenarioDocument, TextAndValuesAgreeAfterEachEdit) {
  TemporaryDocument document;
  EXPECT_FALSE(document->set_value(parameter("target.shape"), Choice{1}));
  EXPECT_FALSE(document->set_value(parameter("target.position"), Eigen::Vector3d(0.1, 7, -0.2)));
  const ScenarioResult result = read_scenario_text(document->text().toStdString(), "t");
  ASSERT_TRUE(result.ok());
  for (const Parameter& p : parameters()) EXPECT_TRUE(p.get(result.scenario) == p.get(document->scenario())) << p.key;
}

TEST(ScenarioDocument, SettingTheSameValueIsNoEdit) {
  TemporaryDocument document;
  EXPECT_FALSE(document->set_value(parameter("target.radius"), 4.5));
  EXPECT_EQ(document->undo_stack()->count(), 0);
}

TEST(ScenarioDocument, RefusesWhatTheTableForbids) {
  TemporaryDocument document;
  const auto problem = document->set_value(parameter("contact.restitution"), 1.5);
  ASSERT_TRUE(problem);
  EXPECT_TRUE(problem->contains("<= 1")) << problem->toStdString();
  EXPECT_EQ(document->scenario().contact.restitution, 0.5);
  EXPECT_EQ(document->undo_stack()->count(), 0);
}

TEST(ScenarioDocument, EditsOfOneKeyInAnInteractionMerge) {
  TemporaryDocument document;
  document->begin_interaction();
  for (const double radius : {4.4, 4.3, 4.2}) EXPECT_FALSE(document->set_value(parameter("target.radius"), radius));
  document->end_interaction();
  EXPECT_EQ(document->undo_stack()->count(), 1);
  EXPECT_EQ(document->undo_stack()->undoText(), "set Target: radius to 4.2 m");
  document->begin_interaction();
  EXPECT_FALSE(document->set_value(parameter("target.radius"), 4.1));
  document->end_interaction();
  EXPECT_EQ(document->undo_stack()->count(), 2);
  document->undo_stack()->undo();
  EXPECT_EQ(document->scenario().target.radius, 4.2);
  document->undo_stack()->undo();
  EXPECT_EQ(document->scenario().target.radius, 4.5);
}

TEST(ScenarioDocument, OtherKeysAndOtherTimesDoNotMerge) {
  TemporaryDocument document;
  EXPECT_FALSE(document->set_value(parameter("target.radius"), 4.4));
  EXPECT_FALSE(document->set_value(parameter("target.radius"), 4.3));
  EXPECT_EQ(document->undo_stack()->count(), 2);
  document->begin_interaction();
  EXPECT_FALSE(document->set_value(parameter("target.radius"), 4.2));
  EXPECT_FALSE(document->set_value(parameter("target.mass"), 100.0));
  document->end_interaction();
  EXPECT_EQ(document->undo_stack()->count(), 4);
}

TEST(ScenarioDocument, ADragBackToTheStartLeavesNothing) {
  TemporaryDocument document;
  document->begin_interaction();
  EXPECT_FALSE(document->set_value(parameter("target.radius"), 4.4));
  EXPECT_FALSE(document->set_value(parameter("target.radius"), 4.5));
  document->end_interaction();
  EXPECT_EQ(document->scenario().target.radius, 4.5);
  EXPECT_FALSE(document->undo_stack()->canUndo());
  EXPECT_FALSE(document->is_modified());
}

TEST(ScenarioDocument, ChecksTheWholeAfterEachEdit) {
  TemporaryDocument document;
  QSignalSpy checked(&*document, &ScenarioDocument::diagnostics_changed);
  EXPECT_FALSE(document->set_value(parameter("closing.closed_length"), 9.0));
  EXPECT_EQ(checked.size(), 1);
  ASSERT_EQ(document->diagnostics().list().size(), 1u);
  EXPECT_EQ(document->diagnostics().list()[0].key, "closing.closed_length");
  document->undo_stack()->undo();
  EXPECT_TRUE(document->diagnostics().ok());
}

TEST(ScenarioDocument, OpenEditSaveKeepsThePersonsText) {
  TemporaryDocument document;
  const QByteArray text = "# my note\n[target]\nradius = 4.0  # careful!\n";
  const QString path = document.write("mine.toml", text);
  ASSERT_TRUE(document->open(path).ok());
  EXPECT_FALSE(document->is_modified());
  EXPECT_EQ(document->display_name(), "mine.toml");
  EXPECT_EQ(document->scenario().name, "mine");
  EXPECT_FALSE(document->set_value(parameter("target.radius"), 4.25));
  EXPECT_EQ(document->scenario().name, "mine");
  EXPECT_EQ(document->saved_scenario().target.radius, 4.0);
  EXPECT_FALSE(document->save());
  EXPECT_FALSE(document->is_modified());
  EXPECT_EQ(read_file(path), "# my note\n[target]\nradius = 4.25 # careful!\n");
  EXPECT_EQ(document->saved_scenario().target.radius, 4.25);
  document->undo_stack()->undo();
  EXPECT_TRUE(document->is_modified()) << "the file has another value now";
}

TEST(ScenarioDocument, FallsBackToTheFullTextWhereAnEditHasNoPlace) {
  TemporaryDocument document;
  ASSERT_TRUE(document->open(document.write("inline.toml", "target = { radius = 4.0 }\n")).ok());
  EXPECT_FALSE(document->set_value(parameter("target.mass"), 150.0));
  EXPECT_EQ(read_scenario_text(document->text().toStdString(), "t").scenario.target.mass, 150);
  EXPECT_EQ(read_scenario_text(document->text().toStdString(), "t").scenario.target.radius, 4);
}

TEST(ScenarioDocument, ABrokenFileLeavesTheDocumentAlone) {
  TemporaryDocument document;
  EXPECT_FALSE(document->set_value(parameter("target.radius"), 4.0));
  const Diagnostics problems = document->open(document.write("broken.toml", "[target]\nradius = \n"));
  ASSERT_FALSE(problems.ok());
  EXPECT_EQ(problems.list()[0].line, 2);
  EXPECT_FALSE(document->open(document.file("missing.toml")).ok());
  EXPECT_EQ(document->scenario().target.radius, 4.0);
  EXPECT_TRUE(document->is_modified());
}

TEST(ScenarioDocument, SaveAsTakesTheNewPathAndSaysWhyNot) {
  TemporaryDocument document;
  EXPECT_TRUE(document->save()) << "there is no path yet";
  QSignalSpy paths(&*document, &ScenarioDocument::path_changed);
  EXPECT_FALSE(document->save_as(document.file("new.toml")));
  EXPECT_EQ(paths.size(), 1);
  EXPECT_EQ(document->path(), document.file("new.toml"));
  const auto problem = document->save_as(document.file("no/such/folder.toml"));
  ASSERT_TRUE(problem);
  EXPECT_TRUE(problem->contains("folder.toml"));
  EXPECT_EQ(document->path(), document.file("new.toml"));
}

TEST(ScenarioDocument, EveryPresetStartsAValidDocument) {
  TemporaryDocument document;
  for (const Preset& preset : presets()) {
    EXPECT_TRUE(document->start_from(preset.text).ok());
    EXPECT_TRUE(document->diagnostics().ok()) << preset.name.toStdString();
    EXPECT_FALSE(document->is_modified());
    EXPECT_FALSE(preset.description.isEmpty());
  }
}

TEST(ScenarioDocument, TextEditIsACommand) {
  TemporaryDocument document;
  QString text = document->text();
  text.replace("radius = 4.5", "radius = 3.5");
  EXPECT_TRUE(document->set_text(text).ok());
  EXPECT_EQ(document->scenario().target.radius, 3.5);
  EXPECT_EQ(document->undo_stack()->undoText(), "set Target: radius to 3.5 m");
  const Diagnostics problems = document->set_text("[target]\nradius = -1\n");
  ASSERT_FALSE(problems.ok());
  EXPECT_EQ(problems.list()[0].key, "target.radius");
  EXPECT_EQ(document->scenario().target.radius, 3.5);
  document->undo_stack()->undo();
  EXPECT_EQ(document->scenario().target.radius, 4.5);
}

TEST(ScenarioDocument, MeshesAreLookedForBesideTheFile) {
  const QTemporaryDir folder;
  QFile mesh(folder.filePath("corner.obj"));
  ASSERT_TRUE(mesh.open(QIODevice::WriteOnly));
  mesh.write("v 0 0 0\nv 2 0 0\nv 0 2 0\nv 0 0 2\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
  mesh.close();
  TemporaryDocument document;
  EXPECT_FALSE(document->set_value(parameter("target.shape"), Choice{static_cast<int>(TargetShape::mesh)}));
  EXPECT_FALSE(document->set_value(parameter("target.mesh_file"), std::string("corner.obj")));
  EXPECT_NE(document->diagnostics().text().find("has no file yet"), std::string::npos);
  EXPECT_FALSE(document->save_as(folder.filePath("own.toml")));
  EXPECT_TRUE(document->diagnostics().ok()) << document->diagnostics().text();
  // History from before the file had a folder finds it too.
  document->undo_stack()->undo();
  EXPECT_NE(document->diagnostics().text().find("needs a file"), std::string::npos);
  document->undo_stack()->redo();
  EXPECT_TRUE(document->diagnostics().ok()) << document->diagnostics().text();
  EXPECT_TRUE(document->open(folder.filePath("own.toml")).ok());
  EXPECT_TRUE(document->diagnostics().ok()) << document->diagnostics().text();
}

}  // namespace
}  // namespace netpocket
