#include "gui/workbench/editor/switch_field.h"

#include <QCheckBox>
#include <QHBoxLayout>

#include "gui/workbench/editor/parameter_words.h"

namespace netpocket {

SwitchField::SwitchField(const Parameter& parameter, QWidget* parent)
    : ParameterField(parameter, parent), box_(new QCheckBox(this)) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(box_);
  box_->setAccessibleName(label(parameter));
  connect(box_, &QCheckBox::clicked, this, [this](bool checked) { offer(checked, Step::typed); });
  setFocusProxy(box_);
}

void SwitchField::show_value(const ParameterValue& value) { box_->setChecked(std::get<bool>(value)); }

void SwitchField::set_read_only(bool read_only) { box_->setEnabled(!read_only); }

}  // namespace netpocket
