#pragma once
// Brings view states onto the screen: with OpenGL in the window itself, or as an image drawn without a display.

#include <QImage>
#include <QString>
#include <QWidget>
#include <functional>
#include <memory>

#include "gui/workbench/viewport/view_state.h"

namespace netpocket {

enum class PresenterKind { automatic, opengl, image };

// Thread contract: the user interface's thread.
class Presenter {
 public:
  virtual ~Presenter() = default;

  virtual QWidget& widget() = 0;
  // Shows the state soon; of several states in a row only the last one must appear.
  virtual void show(const ViewState& state) = 0;
  // What is on the screen now, in device pixels; null before the first picture.
  virtual QImage picture() = 0;
  // The OpenGL in use, for the about box, e.g. "OSMesa (image)".
  virtual QString description() const = 0;

  // Called with each state that has come onto the screen, and how long drawing it took (s).
  std::function<void(const ViewState& state, double seconds)> shown;
  // Called with one sentence when nothing can be drawn.
  std::function<void(const QString& reason)> failed;
};

// Must be called before the QApplication is made: the format of OpenGL windows is fixed then.
void prepare_opengl_format();

// `automatic` takes OpenGL when the platform offers it by a graphics device, else images, which are drawn on a thread
// of their own and never hold up the window.
std::unique_ptr<Presenter> make_presenter(PresenterKind kind);

}  // namespace netpocket
