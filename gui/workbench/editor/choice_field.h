#pragma once

#include "gui/workbench/editor/parameter_field.h"

class QComboBox;

namespace netpocket {

// One of a few named choices.
class ChoiceField : public ParameterField {
  Q_OBJECT
 public:
  ChoiceField(const Parameter& parameter, QWidget* parent);

  void show_value(const ParameterValue& value) override;
  void set_read_only(bool read_only) override;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QComboBox* box_;
};

}  // namespace netpocket
