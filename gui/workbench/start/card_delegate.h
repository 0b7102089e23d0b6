#pragma once
// Draws the items of the start page's lists: a picture with a name and a sentence, or a name with a sentence.

#include <QStyledItemDelegate>

namespace netpocket {

class CardDelegate : public QStyledItemDelegate {
  Q_OBJECT
 public:
  static constexpr int kSentenceRole = Qt::UserRole + 1;  // QString
  static constexpr int kPictureRole = Qt::UserRole + 2;   // QImage

  // Size of the picture, logical pixels; empty: there is none.
  explicit CardDelegate(const QSize& picture, QObject* parent = nullptr);
  void set_picture_size(const QSize& picture) { picture_ = picture; }
  // By how much a card with its margins is wider than its picture, pixels.
  static int extra_width();

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;

 private:
  bool has_picture() const { return !picture_.isEmpty(); }
  void paint_texts(QPainter& painter, const QStyleOptionViewItem& option, const QModelIndex& index,
                   const QRect& space) const;

  QSize picture_;
};

}  // namespace netpocket
