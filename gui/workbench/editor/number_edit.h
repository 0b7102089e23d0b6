#pragma once
// A field for one number. Steps fit the magnitude of the value (the second digit), so 0.004 and 1.2e10 are both easy to
// turn. Wheel and arrows step at once; typing counts when finished (Enter, or leaving the field), Escape takes it back.

#include <QAbstractSpinBox>
#include <optional>

#include "engine/scenario/parameters.h"

namespace netpocket {

class NumberEdit : public QAbstractSpinBox {
  Q_OBJECT
 public:
  NumberEdit(const Limits& limits, bool whole, QWidget* parent = nullptr);

  // Shows a value, without signals. Text that is being typed is replaced.
  void set_value(double value);
  double value() const { return value_; }
  // What stands in the field as a number; empty if it is not one.
  std::optional<double> typed_value() const;
  bool has_pending_text() const;

  void stepBy(int steps) override;
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 signals:
  void typed();                // the text changes
  void finished();             // Enter, or focus lost, with a text that is not the value's
  void stepped(double value);  // by wheel, arrow keys or buttons

 protected:
  StepEnabled stepEnabled() const override;
  QValidator::State validate(QString& input, int& position) const override;
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;

 private:
  double step_towards(int direction) const;

  Limits limits_;
  bool whole_;
  double value_ = 0;
};

}  // namespace netpocket
