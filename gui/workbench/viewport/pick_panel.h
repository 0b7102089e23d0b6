#pragma once
// A small panel in the viewport's corner: what was picked and how it is doing.

#include <QFrame>

#include "gui/workbench/viewport/pick_description.h"

class QFormLayout;
class QLabel;

namespace netpocket {

class PickPanel : public QFrame {
  Q_OBJECT
 public:
  explicit PickPanel(QWidget* parent);

  void set_description(const PickDescription& description);

 signals:
  void closed();
  void plot_requested();

 private:
  QLabel* title_;
  QLabel* detail_;
  QFormLayout* rows_;
};

}  // namespace netpocket
