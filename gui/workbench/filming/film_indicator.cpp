#include "gui/workbench/filming/film_indicator.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QToolButton>

#include "gui/workbench/filming/window_film.h"

namespace netpocket {
namespace {

constexpr int kMargin = 6;  // pixels

}  // namespace

QString length_words(double seconds) {
  const int whole = static_cast<int>(seconds);
  const QString end = QString("%1").arg(whole % 60, 2, 10, QChar('0'));
  if (whole < 3600) return QString("%1:%2").arg(whole / 60).arg(end);
  return QString("%1:%2:%3").arg(whole / 3600).arg(whole / 60 % 60, 2, 10, QChar('0')).arg(end);
}

FilmIndicator::FilmIndicator(WindowFilm& film, QWidget* parent)
    : QWidget(parent), film_(film), label_(new QLabel), stop_(new QToolButton) {
  setAccessibleName(tr("Recording of the window"));
  setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Preferred);
  stop_->setText(tr("Stop"));
  stop_->setToolTip(tr("End the recording of the window and keep the video"));
  stop_->setAccessibleName(tr("Stop recording the window"));
  stop_->setFocusPolicy(Qt::TabFocus);
  connect(stop_, &QToolButton::clicked, &film_, &WindowFilm::stop);
  connect(&film_, &WindowFilm::state_changed, this, &FilmIndicator::refresh);
  connect(&film_, &WindowFilm::second_passed, this, &FilmIndicator::refresh);
  auto* layout = new QHBoxLayout(this);
  layout->addWidget(label_);
  layout->addWidget(stop_);
  make_room();
  refresh();
}

// For the dot.
void FilmIndicator::make_room() { layout()->setContentsMargins(kMargin + fontMetrics().height(), 0, kMargin, 0); }

void FilmIndicator::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::FontChange && layout() != nullptr) make_room();
}

QString FilmIndicator::text() const { return label_->text(); }

void FilmIndicator::refresh() {
  setVisible(film_.is_active());
  stop_->setVisible(film_.is_filming());
  label_->setText(film_.is_filming() ? tr("Recording %1").arg(length_words(film_.seconds()))
                                     : tr("Finishing the video…"));
  update();
}

void FilmIndicator::paintEvent(QPaintEvent*) {
  if (!film_.is_filming()) return;
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(QColor(222, 32, 32));
  const double size = 0.7 * fontMetrics().height();
  painter.drawEllipse(QRectF(kMargin, (height() - size) / 2, size, size));
}

}  // namespace netpocket
