#pragma once
// What a step disturbance is: body, force or torque, axis, size and duration. A button asks for it.

#include <QWidget>

#include "engine/scenario/control_parameters.h"

class QComboBox;
class QPushButton;

namespace netpocket {

class NumberEdit;

class DisturbanceForm : public QWidget {
  Q_OBJECT
 public:
  explicit DisturbanceForm(QWidget* parent = nullptr);

  // As chosen; it starts at 0 s.
  DisturbanceParameters disturbance() const;
  void set_disturbance(DisturbedBody body, bool torque, int axis, double size, double duration);
  // Whether a run can be disturbed now, and else why not.
  void set_possible(bool possible, const QString& why_not);
  QPushButton* button() const { return button_; }

 signals:
  void wanted(const netpocket::DisturbanceParameters& disturbance);

 private:
  void show_unit();

  QComboBox *body_, *kind_, *axis_;
  NumberEdit *size_, *duration_;
  QPushButton* button_;
};

}  // namespace netpocket
