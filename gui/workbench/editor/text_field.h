#pragma once

#include "gui/workbench/editor/parameter_field.h"

class QLineEdit;

namespace netpocket {

// A line of text.
class TextField : public ParameterField {
  Q_OBJECT
 public:
  TextField(const Parameter& parameter, QWidget* parent);
  ~TextField() override;

  void show_value(const ParameterValue& value) override;
  void set_read_only(bool read_only) override;
  bool has_pending_text() const override;

 private:
  QLineEdit* edit_;
  QString value_;
};

}  // namespace netpocket
