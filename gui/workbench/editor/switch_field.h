#pragma once

#include "gui/workbench/editor/parameter_field.h"

class QCheckBox;

namespace netpocket {

// Yes or no.
class SwitchField : public ParameterField {
  Q_OBJECT
 public:
  SwitchField(const Parameter& parameter, QWidget* parent);

  void show_value(const ParameterValue& value) override;
  void set_read_only(bool read_only) override;

 private:
  QCheckBox* box_;
};

}  // namespace netpocket
