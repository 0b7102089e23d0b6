#include "gui/workbench/editor/parameter_field.h"

#include "engine/scenario/parameter_text.h"
#include "gui/workbench/editor/choice_field.h"
#include "gui/workbench/editor/number_field.h"
#include "gui/workbench/editor/pairs_field.h"
#include "gui/workbench/editor/switch_field.h"
#include "gui/workbench/editor/text_field.h"
#include "gui/workbench/panels/engine_words.h"

namespace netpocket {

ParameterField::ParameterField(const Parameter& parameter, QWidget* parent) : QWidget(parent), parameter_(parameter) {}

ParameterField* ParameterField::create(const Parameter& parameter, QWidget* parent) {
  switch (parameter.type) {
    case ParameterType::number:
    case ParameterType::integer:
    case ParameterType::vector:
      return new NumberField(parameter, parent);
    case ParameterType::boolean:
      return new SwitchField(parameter, parent);
    case ParameterType::choice:
      return new ChoiceField(parameter, parent);
    case ParameterType::pairs:
      return new PairsField(parameter, parent);
    case ParameterType::text:
      break;
  }
  return new TextField(parameter, parent);
}

void ParameterField::offer(const ParameterValue& value, Step step) {
  if (const auto problem = limit_problem(parameter_, value)) {
    QString reason = engine_words(*problem);
    reason[0] = reason[0].toUpper();
    emit refused(tr("%1.").arg(reason));
    return;
  }
  emit refused({});
  if (step == Step::typing) {
    emit tried(value);
  } else {
    emit edited(value, step == Step::stepped);
  }
}

}  // namespace netpocket
