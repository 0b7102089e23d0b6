#pragma once
// A figure on the screen, in the colours of the palette.

#include <QWidget>

#include "gui/workbench/panels/figure_image.h"

namespace netpocket {

class StillFigure : public QWidget {
  Q_OBJECT
 public:
  explicit StillFigure(QWidget* parent = nullptr);

  // Its title is not drawn.
  void set_figure(Figure figure);

  QSize minimumSizeHint() const override { return {220, 200}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  Figure figure_;
};

}  // namespace netpocket
