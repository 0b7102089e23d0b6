#pragma once
// A figure on the screen, in the colours of the palette.

#include <QWidget>

#include "gui/workbench/panels/figure_image.h"

namespace netpocket {

class StillFigure : public QWidget {
  Q_OBJECT
 public:
  explicit StillFigure(QWidget* parent = nullptr);

  // Its title is not drawn. `least`: pixels below which it cannot be read.
  void set_figure(Figure figure, const QSize& least);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  Figure figure_;
};

}  // namespace netpocket
