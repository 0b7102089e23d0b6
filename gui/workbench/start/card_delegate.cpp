#include "gui/workbench/start/card_delegate.h"

#include <QImage>
#include <QPainter>
#include <QPainterPath>
#include <QTextLayout>

#include "gui/workbench/panels/tones.h"

namespace netpocket {
namespace {

constexpr int kCardMargin = 6;   // between cards
constexpr int kCardPadding = 8;  // within a card
constexpr int kCardCorner = 6;

// Draws the text in at most `most` lines, of which the last is shortened.
void draw_lines(QPainter& painter, const QRect& space, const QString& text, int most) {
  const QFontMetrics metrics(painter.font());
  QTextLayout layout(text, painter.font());
  layout.beginLayout();
  int y = space.top();
  for (int line_number = 0; line_number < most; ++line_number) {
    QTextLine line = layout.createLine();
    if (!line.isValid()) break;
    line.setLineWidth(space.width());
    const bool last = line_number == most - 1;
    QString words = last ? metrics.elidedText(text.mid(line.textStart()), Qt::ElideRight, space.width())
                         : text.mid(line.textStart(), line.textLength());
    painter.drawText(space.left(), y + metrics.ascent(), words);
    y += metrics.height();
  }
  layout.endLayout();
}

}  // namespace

CardDelegate::CardDelegate(const QSize& picture, QObject* parent) : QStyledItemDelegate(parent), picture_(picture) {}

int CardDelegate::extra_width() { return 2 * kCardMargin; }

QSize CardDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex&) const {
  const int line = option.fontMetrics.height();
  if (!has_picture()) return {0, 2 * line + 2 * kCardPadding};
  return {picture_.width() + 2 * kCardMargin, picture_.height() + 3 * line + 2 * kCardPadding + 2 * kCardMargin};
}

void CardDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const {
  painter->save();
  painter->setRenderHint(QPainter::Antialiasing);
  painter->setRenderHint(QPainter::SmoothPixmapTransform);
  const int margin = has_picture() ? kCardMargin : 1;
  const QRect card = option.rect.adjusted(margin, margin, -margin, -margin);
  const bool focused = (option.state & QStyle::State_HasFocus) != 0;
  const bool marked = focused || (option.state & (QStyle::State_MouseOver | QStyle::State_Selected)) != 0;
  QPainterPath outline;
  outline.addRoundedRect(QRectF(card).adjusted(0.5, 0.5, -0.5, -0.5), kCardCorner, kCardCorner);
  if (has_picture() || marked) {
    painter->fillPath(outline, marked ? ground_colour(Tone::accent, option.palette) : option.palette.base());
  }
  QRect texts = card.adjusted(kCardPadding, kCardPadding, -kCardPadding, -kCardPadding);
  if (has_picture()) {
    const QRect frame(card.topLeft(), picture_);
    painter->save();
    painter->setClipPath(outline);
    const QImage image = index.data(kPictureRole).value<QImage>();
    if (!image.isNull()) painter->drawImage(frame, image);
    painter->restore();
    texts.setTop(frame.bottom() + kCardPadding);
  }
  if (has_picture() || focused) {
    QColor line = marked ? tone_colour(Tone::accent, option.palette) : option.palette.color(QPalette::Mid);
    painter->setPen(QPen(line, focused ? 2 : 1));
    painter->setBrush(Qt::NoBrush);
    painter->drawPath(outline);
  }
  paint_texts(*painter, option, index, texts);
  painter->restore();
}

void CardDelegate::paint_texts(QPainter& painter, const QStyleOptionViewItem& option, const QModelIndex& index,
                               const QRect& space) const {
  QFont font = option.font;
  font.setBold(has_picture());
  painter.setFont(font);
  painter.setPen(option.palette.color(QPalette::Text));
  const int line = QFontMetrics(font).height();
  draw_lines(painter, space, index.data(Qt::DisplayRole).toString(), 1);
  painter.setFont(option.font);
  painter.setPen(tone_colour(Tone::muted, option.palette));
  draw_lines(painter, space.adjusted(0, line, 0, 0), index.data(kSentenceRole).toString(), has_picture() ? 2 : 1);
}

}  // namespace netpocket
