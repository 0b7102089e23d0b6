#include "gui/workbench/viewport/image_presenter.h"

#include <QCoreApplication>
#include <QPainter>
#include <cmath>

namespace netpocket {

ImagePresenter::ImagePresenter() : thread_(DrawingThread::shared()) {
  setAttribute(Qt::WA_OpaquePaintEvent);
  canvas_ = thread_->add([this](DrawnPicture drawn) {
    // Pending deliveries are dropped by Qt when this widget goes.
    QMetaObject::invokeMethod(
        this, [this, drawn = std::move(drawn)] { take(drawn); }, Qt::QueuedConnection);
  });
}

ImagePresenter::~ImagePresenter() { thread_->remove(canvas_); }

QString ImagePresenter::description() const {
  return QCoreApplication::translate("ImagePresenter", "images drawn on a thread of their own");
}

void ImagePresenter::show(const ViewState& state) {
  state_ = state;
  request_picture();
}

void ImagePresenter::resizeEvent(QResizeEvent*) { request_picture(); }

void ImagePresenter::request_picture() {
  const auto pixels = [this](int length) {
    return std::max(1, static_cast<int>(std::lround(length * devicePixelRatioF())));
  };
  if (state_.options && !size().isEmpty()) thread_->request(canvas_, state_, pixels(width()), pixels(height()));
}

void ImagePresenter::take(const DrawnPicture& drawn) {
  if (drawn.image.isNull()) {
    if (failed) failed(QString::fromStdString(drawn.failure));
    return;
  }
  picture_ = drawn.image;
  picture_.setDevicePixelRatio(devicePixelRatioF());
  update();
  if (shown) shown(drawn.state, drawn.seconds);
}

void ImagePresenter::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  if (picture_.isNull()) {
    painter.fillRect(rect(), palette().base());
    return;
  }
  // While the window is being resized the last picture stands in for the next one.
  painter.drawImage(QRectF(rect()), picture_);
}

}  // namespace netpocket
