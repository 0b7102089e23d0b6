#include "gui/workbench/campaign/still_figure.h"

#include <QPainter>

#include "gui/workbench/panels/figure_words.h"

namespace netpocket {

StillFigure::StillFigure(QWidget* parent) : QWidget(parent) {
  setAttribute(Qt::WA_OpaquePaintEvent);
  setAccessibleName(tr("Figure of the campaign"));
}

void StillFigure::set_figure(Figure figure, const QSize& least) {
  figure_ = in_window_language(std::move(figure));
  figure_.title.clear();
  setMinimumSize(least);
  update();
}

void StillFigure::paintEvent(QPaintEvent*) {
  QPainter(this).drawImage(QPoint(0, 0), figure_image(figure_, size(), devicePixelRatioF(), palette()).image);
}

}  // namespace netpocket
