#include "gui/workbench/editor/choice_field.h"

#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>

#include "gui/workbench/editor/parameter_words.h"

namespace netpocket {

ChoiceField::ChoiceField(const Parameter& parameter, QWidget* parent)
    : ParameterField(parameter, parent), box_(new QComboBox(this)) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(box_);
  for (const std::string_view name : parameter.choices) {
    box_->addItem(QString::fromUtf8(name.data(), static_cast<qsizetype>(name.size())).replace('_', ' '));
  }
  box_->setAccessibleName(label(parameter));
  box_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  box_->setMinimumContentsLength(6);
  box_->setFocusPolicy(Qt::StrongFocus);
  box_->installEventFilter(this);
  connect(box_, &QComboBox::activated, this, [this](int index) { offer(Choice{index}, Step::typed); });
  setFocusProxy(box_);
}

void ChoiceField::show_value(const ParameterValue& value) { box_->setCurrentIndex(std::get<Choice>(value).index); }

void ChoiceField::set_read_only(bool read_only) { box_->setEnabled(!read_only); }

// The wheel scrolls the form unless the field has been chosen.
bool ChoiceField::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Wheel && !box_->hasFocus()) {
    event->ignore();
    return true;
  }
  return ParameterField::eventFilter(watched, event);
}

}  // namespace netpocket
