#pragma once

#include "gui/workbench/editor/parameter_field.h"

class QTableWidget;
class QToolButton;

namespace netpocket {

// A table of pairs: the profile of a rod (its three points have names) or a closing table (rows come and go).
class PairsField : public ParameterField {
  Q_OBJECT
 public:
  PairsField(const Parameter& parameter, QWidget* parent);

  void show_value(const ParameterValue& value) override;
  void set_read_only(bool read_only) override;

  QTableWidget* table() const { return table_; }

 protected:
  void changeEvent(QEvent* event) override;

 private:
  using Pairs = std::vector<Eigen::Vector2d>;

  void set_icons();
  void fill();
  void fit_height();
  void read_cell(int row, int column);
  void add_row();
  void remove_row();

  Pairs pairs_;
  QTableWidget* table_;
  QToolButton* add_ = nullptr;
  QToolButton* remove_ = nullptr;
  bool filling_ = false;
};

}  // namespace netpocket
