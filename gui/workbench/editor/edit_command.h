#pragma once

#include <QStringList>
#include <QUndoCommand>
#include <memory>

#include "gui/workbench/editor/scenario_document.h"

namespace netpocket {

// One edit of a document, as the states before and after it.
class EditCommand : public QUndoCommand {
 public:
  using StatePointer = std::shared_ptr<const ScenarioDocument::State>;

  // Edits of the same keys merge within an interaction; 0: never.
  EditCommand(ScenarioDocument& document, StatePointer before, StatePointer after, int interaction,
              const QString& text);

  int id() const override { return 1; }
  bool mergeWith(const QUndoCommand* other) override;
  void undo() override { document_.apply(before_); }
  void redo() override { document_.apply(after_); }

 private:
  ScenarioDocument& document_;
  StatePointer before_;
  StatePointer after_;
  QStringList keys_;
  int interaction_;
};

// Keys of the parameters in which two scenarios differ.
QStringList differing_keys(const Scenario& a, const Scenario& b);

}  // namespace netpocket
