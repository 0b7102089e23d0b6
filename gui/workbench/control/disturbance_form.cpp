#include "gui/workbench/control/disturbance_form.h"

#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>

#include "gui/workbench/editor/number_edit.h"

namespace netpocket {
namespace {

constexpr Limits kSizes = {-1e7, 1e7};
constexpr Limits kDurations = {0, 1e5, true};

QComboBox* choice(const QString& name, const QString& help, const QStringList& items, QWidget* parent) {
  auto* box = new QComboBox(parent);
  box->addItems(items);
  box->setAccessibleName(name);
  box->setToolTip(help);
  return box;
}

NumberEdit* number(const QString& name, const QString& help, const Limits& limits, double value, QWidget* parent) {
  auto* edit = new NumberEdit(limits, false, parent);
  edit->set_value(value);
  edit->setAccessibleName(name);
  edit->setToolTip(help);
  // What is typed counts; a text that is no number goes back.
  QObject::connect(edit, &NumberEdit::finished, edit, [edit, limits] {
    const auto typed = edit->typed_value();
    edit->set_value(typed && limits.contain(*typed) ? *typed : edit->value());
  });
  QObject::connect(edit, &NumberEdit::stepped, edit, &NumberEdit::set_value);
  return edit;
}

}  // namespace

DisturbanceForm::DisturbanceForm(QWidget* parent)
    : QWidget(parent),
      body_(choice(tr("Disturbed body"), tr("Body on which the disturbance acts"), {tr("Spacecraft"), tr("Target")},
                   this)),
      kind_(choice(tr("Kind of disturbance"), tr("A force through the body's centre of mass, or a torque"),
                   {tr("Torque, N m"), tr("Force, N")}, this)),
      axis_(choice(tr("Axis of the disturbance"), tr("Axis of the body, which turns with it"), {"x", "y", "z"}, this)),
      size_(number(tr("Size of the disturbance"), tr("Newtons or newton metres; negative: the other way"), kSizes, 20,
                   this)),
      duration_(number(tr("Duration of the disturbance"), tr("Seconds for which it acts"), kDurations, 1, this)),
      button_(new QPushButton(tr("Disturb"), this)) {
  auto* layout = new QGridLayout(this);
  layout->setContentsMargins(12, 2, 6, 4);
  layout->setHorizontalSpacing(5);
  layout->setVerticalSpacing(3);
  layout->addWidget(body_, 0, 0, 1, 2);
  layout->addWidget(kind_, 0, 2, 1, 2);
  layout->addWidget(axis_, 0, 4);
  layout->addWidget(size_, 1, 0);
  auto* for_ = new QLabel(tr("for"), this);
  layout->addWidget(for_, 1, 1);
  layout->addWidget(duration_, 1, 2);
  layout->addWidget(new QLabel(tr("s"), this), 1, 3);
  layout->addWidget(button_, 1, 4);
  layout->setColumnStretch(0, 1);
  layout->setColumnStretch(2, 1);
  connect(button_, &QPushButton::clicked, this, [this] { emit wanted(disturbance()); });
}

DisturbanceParameters DisturbanceForm::disturbance() const {
  DisturbanceParameters chosen;
  chosen.body = static_cast<DisturbedBody>(body_->currentIndex());
  const bool torque = kind_->currentIndex() == 0;
  const auto typed = [](const NumberEdit& edit, const Limits& limits) {
    const auto number = edit.typed_value();
    return number && limits.contain(*number) ? *number : edit.value();
  };
  (torque ? chosen.torque : chosen.force)[axis_->currentIndex()] = typed(*size_, kSizes);
  chosen.duration = typed(*duration_, kDurations);
  return chosen;
}

void DisturbanceForm::set_disturbance(DisturbedBody body, bool torque, int axis, double size, double duration) {
  body_->setCurrentIndex(static_cast<int>(body));
  kind_->setCurrentIndex(torque ? 0 : 1);
  axis_->setCurrentIndex(axis);
  size_->set_value(size);
  duration_->set_value(duration);
}

void DisturbanceForm::set_possible(bool possible, const QString& why_not) {
  button_->setEnabled(possible);
  button_->setToolTip(possible ? tr("Disturb the running simulation from its present time on (Ctrl+D)") : why_not);
}

}  // namespace netpocket
