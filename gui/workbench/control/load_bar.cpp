#include "gui/workbench/control/load_bar.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

#include "gui/workbench/panels/tones.h"

namespace netpocket {
namespace {

constexpr double kLimitPlace = 0.85;  // of the bar's length
constexpr int kMargin = 3;            // pixels

}  // namespace

LoadBar::LoadBar(QWidget* parent) : QWidget(parent) { setAttribute(Qt::WA_TransparentForMouseEvents); }

void LoadBar::show_load(std::optional<double> load, bool limited, bool saturated) {
  load_ = load;
  saturated_ = saturated;
  text_ = !limited    ? tr("no limit")
          : !load     ? QString()
          : saturated ? tr("saturated")
                      : tr("%1 %").arg(static_cast<int>(std::floor(100 * *load)));
  setAccessibleName(text_);
  update();
}

QSize LoadBar::sizeHint() const {
  QFont bold = font();
  bold.setBold(true);
  const int widest = QFontMetrics(bold).horizontalAdvance(tr("saturated"));
  return {widest + 6 * kMargin, fontMetrics().height() + 2};
}

void LoadBar::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  const QRectF bar = QRectF(rect()).adjusted(kMargin, 2, -kMargin, -2);
  if (load_) {
    painter.fillRect(bar, ground_colour(Tone::muted, palette()));
    const Tone tone = saturated_ ? Tone::bad : Tone::accent;
    QRectF filled = bar;
    filled.setWidth(bar.width() * std::min(1.0, kLimitPlace * *load_));
    QColor colour = tone_colour(tone, palette());
    colour.setAlphaF(0.35F);
    painter.fillRect(filled, colour);
    painter.setPen(QPen(palette().color(QPalette::Text), 1.2));
    const double limit = bar.left() + kLimitPlace * bar.width();
    painter.drawLine(QPointF(limit, bar.top()), QPointF(limit, bar.bottom()));
  }
  QFont shown = font();
  shown.setBold(saturated_);
  painter.setFont(shown);
  painter.setPen(load_ ? palette().color(QPalette::Text) : tone_colour(Tone::muted, palette()));
  painter.drawText(bar, Qt::AlignCenter, text_);
}

}  // namespace netpocket
