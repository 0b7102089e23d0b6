#include "gui/workbench/editor/message_bar.h"

#include <QApplication>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>

namespace netpocket {

MessageBar::MessageBar(Tone tone, QWidget* parent)
    : QFrame(parent), tone_(tone), label_(new QLabel(this)), layout_(new QHBoxLayout(this)) {
  label_->setWordWrap(true);
  label_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  layout_->setContentsMargins(10, 5, 6, 5);
  layout_->addWidget(label_, 1);
  setAutoFillBackground(true);
  set_colours();
  hide();
}

QPushButton* MessageBar::add_button(const QString& text) {
  auto* button = new QPushButton(text, this);
  layout_->addWidget(button);
  return button;
}

void MessageBar::add_close_button() {
  auto* button = new QToolButton(this);
  button->setText(QString::fromUtf8("×"));
  button->setAutoRaise(true);
  button->setToolTip(tr("Close this message"));
  button->setAccessibleName(tr("Close this message"));
  connect(button, &QToolButton::clicked, this, [this] { show_text({}); });
  layout_->addWidget(button);
}

void MessageBar::show_text(const QString& text) {
  label_->setText(text);
  setVisible(!text.isEmpty());
}

QString MessageBar::text() const { return label_->text(); }

void MessageBar::set_colours() {
  const QPalette inherited = parentWidget() ? parentWidget()->palette() : QApplication::palette();
  const QColor ground = ground_colour(tone_, inherited);
  if (palette().color(QPalette::Window) == ground) return;
  // Of its own only the ground: everything else follows the window, also when that turns dark.
  QPalette own;
  own.setColor(QPalette::Window, ground);
  setPalette(own);
}

void MessageBar::changeEvent(QEvent* event) {
  if (event->type() == QEvent::ParentChange || event->type() == QEvent::PaletteChange) set_colours();
  QFrame::changeEvent(event);
}

}  // namespace netpocket
