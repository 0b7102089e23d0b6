#pragma once
// Draws in the window with the platform's OpenGL.

#include <QOpenGLWidget>
#include <memory>

#include "gui/workbench/viewport/presenter.h"
#include "gui/workbench/viewport/scene_drawing.h"

namespace netpocket {

class OpenGlPresenter final : public QOpenGLWidget, public Presenter {
 public:
  OpenGlPresenter();
  ~OpenGlPresenter() override;

  QWidget& widget() override { return *this; }
  void show(const ViewState& state) override;
  QImage picture() override { return grabFramebuffer(); }
  QString description() const override { return description_; }

 protected:
  void initializeGL() override;
  void paintGL() override;

 private:
  void release();
  void copy_to_widget();

  ViewState state_;
  bool stale_ = true;  // whether the state has not been drawn yet
  QSize drawn_size_;   // device pixels
  std::unique_ptr<SceneDrawing> drawing_;
  QString description_;
};

}  // namespace netpocket
