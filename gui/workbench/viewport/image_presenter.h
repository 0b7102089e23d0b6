#pragma once
// Shows pictures that a DrawingThread draws: works on every Qt platform, over remote desktops and in tests.

#include <memory>

#include "gui/workbench/viewport/drawing_thread.h"
#include "gui/workbench/viewport/presenter.h"

namespace netpocket {

class ImagePresenter final : public QWidget, public Presenter {
 public:
  ImagePresenter();
  ~ImagePresenter() override;

  QWidget& widget() override { return *this; }
  void show(const ViewState& state) override;
  QImage picture() override { return picture_; }
  QString description() const override;

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  void request_picture();
  void take(const DrawnPicture& drawn);

  ViewState state_;
  QImage picture_;
  std::shared_ptr<DrawingThread> thread_;
  int canvas_;
};

}  // namespace netpocket
