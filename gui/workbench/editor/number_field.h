#pragma once

#include <vector>

#include "gui/workbench/editor/number_edit.h"
#include "gui/workbench/editor/parameter_field.h"

namespace netpocket {

// A number, a whole number, or the three numbers of a vector side by side.
class NumberField : public ParameterField {
  Q_OBJECT
 public:
  NumberField(const Parameter& parameter, QWidget* parent);

  void show_value(const ParameterValue& value) override;
  void set_read_only(bool read_only) override;
  bool has_pending_text() const override;

 private:
  void offer_typed(Step step);
  ParameterValue value_of(const std::vector<double>& numbers) const;

  std::vector<NumberEdit*> edits_;
};

}  // namespace netpocket
