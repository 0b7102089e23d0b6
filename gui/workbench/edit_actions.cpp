#include "gui/workbench/edit_actions.h"

#include <QAction>
#include <QDialog>
#include <QLabel>
#include <QMenu>
#include <QUndoView>
#include <QVBoxLayout>

#include "gui/workbench/dialogs/differences_dialog.h"
#include "gui/workbench/dialogs/part_dialog.h"
#include "gui/workbench/panels/engine_words.h"

namespace netpocket {
namespace {

constexpr const char* kUsualComparison = "case1";

void bring_up(QDialog& dialog) {
  dialog.show();
  dialog.raise();
  dialog.activateWindow();
}

}  // namespace

EditActions::EditActions(ScenarioDocument& document, QWidget* window)
    : QObject(window), document_(document), window_(window) {
  connect(&document_, &ScenarioDocument::modified_changed, this, &EditActions::refresh);
}

QAction* EditActions::add(QMenu& menu, const QString& text, const QKeySequence& key, const QString& help) {
  auto* action = menu.addAction(text);
  action->setShortcut(key);
  action->setToolTip(key.isEmpty() ? help : QString("%1 (%2)").arg(help, key.toString(QKeySequence::NativeText)));
  action->setStatusTip(help);
  return action;
}

void EditActions::fill(QMenu& menu) {
  auto* undo = document_.undo_stack()->createUndoAction(this, tr("Undo"));
  undo->setShortcut(QKeySequence::Undo);
  auto* redo = document_.undo_stack()->createRedoAction(this, tr("Redo"));
  redo->setShortcut(QKeySequence::Redo);
  // What they are called where it does not matter what they would undo.
  undo->setIconText(tr("Undo"));
  redo->setIconText(tr("Redo"));
  menu.addActions({undo, redo});
  connect(add(menu, tr("Undo history…"), Qt::CTRL | Qt::SHIFT | Qt::Key_H, tr("Go to any step of the edits")),
          &QAction::triggered, this, &EditActions::show_history);
  revert_ = add(menu, tr("Revert to the saved version"), {}, tr("Take all unsaved edits back; can be undone"));
  connect(revert_, &QAction::triggered, this, &EditActions::revert);
  menu.addSeparator();
  connect(add(menu, tr("What differs…"), Qt::CTRL | Qt::SHIFT | Qt::Key_D,
              tr("List what differs from case 1, the saved version or any file")),
          &QAction::triggered, this, &EditActions::show_differences);
  connect(add(menu, tr("Pockets, targets, strategies…"), Qt::CTRL | Qt::SHIFT | Qt::Key_P,
              tr("Put a part of a scenario that comes with the program into this one")),
          &QAction::triggered, this, &EditActions::show_parts);
  refresh();
}

void EditActions::refresh() {
  if (revert_ != nullptr) revert_->setEnabled(document_.is_modified());
}

void EditActions::revert() {
  const Diagnostics problems = document_.revert();
  if (!problems.ok()) return emit problem(diagnostics_words(problems));
  emit told(tr("Reverted to the saved version; Undo takes that back."));
}

DifferencesDialog* EditActions::show_differences() {
  if (!differences_) {
    differences_ = new DifferencesDialog(document_, window_);
    differences_->compare_with(kUsualComparison);
    connect(differences_, &DifferencesDialog::key_chosen, this, &EditActions::key_chosen);
  }
  bring_up(*differences_);
  return differences_;
}

PartDialog* EditActions::show_parts() {
  if (!parts_) {
    parts_ = new PartDialog(document_, window_);
    connect(parts_, &PartDialog::key_chosen, this, &EditActions::key_chosen);
  }
  bring_up(*parts_);
  return parts_;
}

QDialog* EditActions::show_history() {
  if (!history_) {
    history_ = new QDialog(window_);
    history_->setWindowTitle(tr("Undo history"));
    auto* view = new QUndoView(document_.undo_stack());
    view->setEmptyLabel(tr("Before the first edit"));
    view->setAccessibleName(tr("Edits"));
    auto* help = new QLabel(tr("Choose a step to go to it; the steps after it stay until the next edit."));
    help->setWordWrap(true);
    auto* layout = new QVBoxLayout(history_);
    layout->addWidget(help);
    layout->addWidget(view, 1);
    history_->resize(380, 420);
  }
  bring_up(*history_);
  return history_;
}

}  // namespace netpocket
