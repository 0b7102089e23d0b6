// What differs, reverting, the list of edits, and parts of other scenarios.

#include "gui/workbench/edit_actions.h"

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QFile>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QTest>
#include <QUndoStack>
#include <QUndoView>

#include "engine/scenario/read_scenario.h"
#include "gui/workbench/dialogs/differences_dialog.h"
#include "gui/workbench/dialogs/part_dialog.h"
#include "gui/workbench/editor/difference_table.h"
#include "gui/workbench/editor/edit_command.h"
#include "gui/workbench/editor/parameter_field.h"
#include "gui/workbench/editor/parameter_form.h"
#include "gui/workbench/editor/parameter_row.h"
#include "gui/workbench/editor/scenario_editor.h"
#include "gui/workbench/file_actions.h"
#include "tests/gui/workbench/window_fixture.h"

namespace netpocket {
namespace {

const Parameter& duration() { return *find_parameter("closing.duration"); }

class EditTest : public WindowTest {
 protected:
  ScenarioDocument& document() const { return window_->document(); }
  EditActions& actions() const { return window_->edit_actions(); }

  void picture_of(QDialog& dialog, const QString& name) const {
    const QString folder = qEnvironmentVariable("NETPOCKET_SCREENSHOTS");
    QTest::qWait(100);
    if (!folder.isEmpty()) dialog.grab().save(QString("%1/%2.png").arg(folder, name));
  }
};

TEST_F(EditTest, ListsWhatDiffersFromCaseOne) {
  window_->file_actions().open_preset("case2");
  DifferencesDialog* dialog = actions().show_differences();
  // The paper's cases 1 and 2 close in 10 s and 7.5 s.
  QStringList keys;
  for (const ScenarioDifference& row : dialog->table()->rows()) {
    keys << row.key;
    if (row.key != "closing.duration") continue;
    EXPECT_EQ(row.name, "Closing: Duration");
    EXPECT_EQ(row.here, "7.5");
    EXPECT_EQ(row.there, "10");
    EXPECT_EQ(row.unit, "s");
  }
  EXPECT_TRUE(keys.contains("closing.duration"));
  EXPECT_FALSE(keys.contains("net.diameter"));
  picture_of(*dialog, "differences");

  // It follows the edits.
  ASSERT_FALSE(document().set_value(duration(), 10.0));
  for (const ScenarioDifference& row : dialog->table()->rows()) EXPECT_NE(row.key, "closing.duration");
}

TEST_F(EditTest, AClickGoesToTheParameter) {
  window_->file_actions().open_preset("case2");
  DifferencesDialog* dialog = actions().show_differences();
  auto* item = dialog->table()->findItems("closing.duration", Qt::MatchExactly, 4).value(0);
  ASSERT_NE(item, nullptr);
  QTest::mouseClick(dialog->table()->viewport(), Qt::LeftButton, {}, dialog->table()->visualItemRect(item).center());
  EXPECT_NE(window_->editor().focusWidget(), nullptr);
  EXPECT_TRUE(window_->editor().search()->text().isEmpty());
}

TEST_F(EditTest, SelectedValuesAreTakenOverAsOneStep) {
  window_->file_actions().open_preset("case3");
  DifferencesDialog* dialog = actions().show_differences();
  const Scenario before = document().scenario();
  dialog->table()->selectAll();
  dialog->take_selected();
  EXPECT_TRUE(dialog->table()->rows().empty()) << dialog->table()->rows().front().key.toStdString();
  EXPECT_EQ(document().undo_stack()->count(), 1);
  document().undo_stack()->undo();
  EXPECT_TRUE(differing_keys(before, document().scenario()).isEmpty());
}

TEST_F(EditTest, ComparesWithFilesAndSaysWhatIsWrongWithThem) {
  write_file("other.toml", "name = \"quick\"\n[closing]\nduration = 3\n");
  write_file("bad.toml", "[closing]\ndurration = 3\n");
  DifferencesDialog* dialog = actions().show_differences();
  dialog->compare_with_file(file("other.toml"));
  EXPECT_TRUE(dialog->summary().contains("other.toml"));
  EXPECT_FALSE(dialog->table()->findItems("closing.duration", Qt::MatchExactly, 4).isEmpty());
  dialog->compare_with_file(file("bad.toml"));
  EXPECT_TRUE(dialog->summary().contains("durration")) << dialog->summary().toStdString();
  dialog->compare_with_saved();
  EXPECT_TRUE(dialog->table()->rows().empty());
}

TEST_F(EditTest, AnotherSystemIsOneDifference) {
  window_->file_actions().open_preset("thrown_net");
  const auto rows = actions().show_differences()->table()->rows();
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows.front().there, "pocket");
}

TEST_F(EditTest, RevertsToTheFileAndBack) {
  ASSERT_FALSE(document().save_as(file("mine.toml")));
  EXPECT_FALSE(actions().revert_action()->isEnabled());
  ASSERT_FALSE(document().set_value(duration(), 0.5));
  ASSERT_TRUE(actions().revert_action()->isEnabled());
  actions().revert_action()->trigger();
  EXPECT_EQ(document().scenario().closing.duration, 0.8);
  EXPECT_FALSE(document().is_modified());
  EXPECT_FALSE(window_->isWindowModified());
  // Nothing is lost.
  document().undo_stack()->undo();
  EXPECT_EQ(document().scenario().closing.duration, 0.5);
  EXPECT_TRUE(document().is_modified());
}

// What somebody else has written into the file meanwhile is what is saved.
TEST_F(EditTest, RevertReadsTheFileAsItIsNow) {
  ASSERT_FALSE(document().save_as(file("mine.toml")));
  ASSERT_FALSE(document().set_value(duration(), 0.5));
  write_file("mine.toml", "name = \"quick\"\n[closing]\nduration = 4\n");
  actions().revert_action()->trigger();
  EXPECT_EQ(document().scenario().closing.duration, 4);
  EXPECT_EQ(document().saved_scenario().closing.duration, 4);
  ASSERT_FALSE(document().set_value(duration(), 0.5));
  QFile::remove(file("mine.toml"));
  actions().revert_action()->trigger();
  EXPECT_EQ(document().scenario().closing.duration, 0.5);
  EXPECT_FALSE(window_->notice().isEmpty());
}

TEST_F(EditTest, TheHistoryGoesToAnyStep) {
  for (const double value : {0.7, 0.6, 0.5}) ASSERT_FALSE(document().set_value(duration(), value));
  QDialog* dialog = actions().show_history();
  auto* view = dialog->findChild<QUndoView*>();
  ASSERT_EQ(view->model()->rowCount(), 4);
  picture_of(*dialog, "history");
  view->setCurrentIndex(view->model()->index(1, 0));
  EXPECT_EQ(document().scenario().closing.duration, 0.7);
  view->setCurrentIndex(view->model()->index(0, 0));
  EXPECT_EQ(document().scenario().closing.duration, 0.8);
  view->setCurrentIndex(view->model()->index(3, 0));
  EXPECT_EQ(document().scenario().closing.duration, 0.5);
}

TEST_F(EditTest, PartsAreThoseOfTheShippedScenariosEachOnce) {
  for (const ScenarioPart part : {ScenarioPart::pocket, ScenarioPart::target, ScenarioPart::strategy}) {
    const auto& found = part_presets(part);
    ASSERT_GT(found.size(), 2u);
    for (std::size_t i = 0; i < found.size(); ++i) {
      EXPECT_FALSE(summary_of(part, found[i]).contains("%")) << summary_of(part, found[i]).toStdString();
      for (std::size_t j = 0; j < i; ++j) EXPECT_NE(found[i].settings, found[j].settings);
    }
  }
  // The paper's three cases have one pocket and three strategies.
  const auto has = [](ScenarioPart part, const QString& first, const QString& second) {
    for (const PartPreset& preset : part_presets(part)) {
      if (preset.scenarios.contains(first) && preset.scenarios.contains(second)) return true;
    }
    return false;
  };
  EXPECT_TRUE(has(ScenarioPart::pocket, "case1", "case2"));
  EXPECT_FALSE(has(ScenarioPart::strategy, "case1", "case2"));
  EXPECT_FALSE(has(ScenarioPart::strategy, "case2", "case3"));
}

TEST_F(EditTest, APartIsPutInAsOneStepAfterAPreview) {
  window_->file_actions().open_preset("case1");
  const Scenario before = document().scenario();
  PartDialog* dialog = actions().show_parts();
  dialog->show_part(ScenarioPart::target);
  // The scenario has this target.
  dialog->list()->setCurrentItem(dialog->list()->findItems("case1", Qt::MatchExactly).value(0));
  EXPECT_FALSE(dialog->apply_button()->isEnabled());
  dialog->list()->setCurrentItem(dialog->list()->findItems("tumbling_box", Qt::MatchExactly).value(0));
  ASSERT_TRUE(dialog->apply_button()->isEnabled());
  picture_of(*dialog, "parts");
  const auto announced = dialog->table()->rows().size();
  QTest::mouseClick(dialog->apply_button(), Qt::LeftButton);
  EXPECT_EQ(document().scenario().target.shape, TargetShape::box);
  EXPECT_EQ(static_cast<std::size_t>(differing_keys(before, document().scenario()).size()), announced);
  EXPECT_EQ(document().undo_stack()->count(), 1);
  // The pocket stays what it was.
  EXPECT_EQ(document().scenario().rods.profile, before.rods.profile);
  document().undo_stack()->undo();
  EXPECT_TRUE(differing_keys(before, document().scenario()).isEmpty());
}

// The form has the tables of the system, and gives way to rows of the drum, the drawstring and the orbit where they
// act.
TEST_F(EditTest, FormShowsWhatAThrownNetUses) {
  window_->file_actions().open_preset("thrown_net_winch");
  const auto row = [&](const char* key) { return window_->editor().form()->row(key); };
  const auto can_be_edited = [&](const char* key) { return row(key) != nullptr && row(key)->field()->isEnabled(); };
  EXPECT_EQ(row("rods.density"), nullptr) << "of a pocket";
  EXPECT_TRUE(can_be_edited("tether.slip_tension"));
  EXPECT_TRUE(can_be_edited("tether.tension"));
  EXPECT_FALSE(can_be_edited("tether.elements")) << "a wound tether has none";
  EXPECT_TRUE(can_be_edited("drawstring.delay"));
  EXPECT_FALSE(can_be_edited("drawstring.ring_friction"));
  EXPECT_FALSE(can_be_edited("orbit.altitude"));
  ASSERT_FALSE(document().set_value(*find_parameter("tether.winch", document().scenario()), false));
  EXPECT_FALSE(can_be_edited("tether.slip_tension"));
  EXPECT_TRUE(can_be_edited("tether.elements"));
  const Parameter& passage = *find_parameter("drawstring.passage", document().scenario());
  ASSERT_FALSE(document().set_value(passage, Choice{1}));
  EXPECT_TRUE(can_be_edited("drawstring.ring_friction"));
  document().undo_stack()->undo();
  EXPECT_FALSE(can_be_edited("drawstring.ring_friction"));
}

TEST_F(EditTest, PartsDoNotFitAnotherSystem) {
  window_->file_actions().open_preset("thrown_net");
  EXPECT_FALSE(actions().show_parts()->apply_button()->isEnabled());
}

}  // namespace
}  // namespace netpocket
