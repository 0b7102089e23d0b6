#include "gui/workbench/editor/edit_command.h"

namespace netpocket {

QStringList differing_keys(const Scenario& a, const Scenario& b) {
  if (a.system != b.system) return {"system"};  // its tables are others, so nothing else can be compared
  QStringList keys;
  const auto add = [&](std::string_view key) {
    keys << QString::fromUtf8(key.data(), static_cast<qsizetype>(key.size()));
  };
  for (const ParameterList& list : parameter_lists(a.system)) {
    if (list.size(a) != list.size(b)) add(list.name);
  }
  for (const Parameter* parameter : parameters_of(a)) {
    if (find_parameter(parameter->key, b) && parameter->get(a) != parameter->get(b)) add(parameter->key);
  }
  return keys;
}

EditCommand::EditCommand(ScenarioDocument& document, StatePointer before, StatePointer after, int interaction,
                         const QString& text)
    : QUndoCommand(text),
      document_(document),
      before_(std::move(before)),
      after_(std::move(after)),
      keys_(differing_keys(before_->scenario, after_->scenario)),
      interaction_(interaction) {}

bool EditCommand::mergeWith(const QUndoCommand* other) {
  const auto& next = static_cast<const EditCommand&>(*other);  // the only kind on the stack
  if (interaction_ == 0 || next.interaction_ != interaction_ || next.keys_ != keys_) return false;
  after_ = next.after_;
  setText(next.text());
  setObsolete(before_->text == after_->text);
  return true;
}

}  // namespace netpocket
