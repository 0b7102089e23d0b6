#include "gui/workbench/editor/number_field.h"

#include <QHBoxLayout>
#include <algorithm>

#include "engine/scenario/parameter_text.h"
#include "gui/workbench/editor/parameter_words.h"

namespace netpocket {

NumberField::NumberField(const Parameter& parameter, QWidget* parent) : ParameterField(parameter, parent) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(4);
  const bool vector = parameter.type == ParameterType::vector;
  for (int i = 0; i < (vector ? 3 : 1); ++i) {
    auto* edit = new NumberEdit(parameter.limits, parameter.type == ParameterType::integer, this);
    edit->setAccessibleName(vector ? label(parameter) + " " + "xyz"[i] : label(parameter));
    if (vector) edit->setButtonSymbols(QAbstractSpinBox::NoButtons);
    connect(edit, &NumberEdit::typed, this, [this] { offer_typed(Step::typing); });
    connect(edit, &NumberEdit::finished, this, [this] { offer_typed(Step::typed); });
    connect(edit, &NumberEdit::stepped, this, [this] { offer_typed(Step::stepped); });
    layout->addWidget(edit, 1);
    edits_.push_back(edit);
  }
  setFocusProxy(edits_.front());
}

void NumberField::show_value(const ParameterValue& value) {
  if (const auto* vector = std::get_if<Eigen::Vector3d>(&value)) {
    for (int i = 0; i < 3; ++i) edits_[i]->set_value((*vector)[i]);
  } else if (const auto* whole = std::get_if<std::int64_t>(&value)) {
    edits_[0]->set_value(static_cast<double>(*whole));
  } else {
    edits_[0]->set_value(std::get<double>(value));
  }
}

void NumberField::set_read_only(bool read_only) {
  for (NumberEdit* edit : edits_) edit->setReadOnly(read_only);
}

bool NumberField::has_pending_text() const {
  return std::any_of(edits_.begin(), edits_.end(), [](const NumberEdit* edit) { return edit->has_pending_text(); });
}

ParameterValue NumberField::value_of(const std::vector<double>& numbers) const {
  if (parameter().type == ParameterType::vector) return Eigen::Vector3d(numbers[0], numbers[1], numbers[2]);
  if (parameter().type == ParameterType::integer && parameter().limits.contain(numbers[0])) {
    return static_cast<std::int64_t>(numbers[0]);
  }
  return numbers[0];
}

void NumberField::offer_typed(Step step) {
  std::vector<double> numbers;
  for (const NumberEdit* edit : edits_) {
    const auto number = edit->typed_value();
    if (!number) {
      emit refused(
          tr("“%1” is not %2.")
              .arg(edit->text(), parameter().type == ParameterType::integer ? tr("a whole number") : tr("a number")));
      return;
    }
    numbers.push_back(*number);
  }
  offer(value_of(numbers), step);
}

}  // namespace netpocket
