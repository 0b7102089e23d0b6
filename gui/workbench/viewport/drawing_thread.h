#pragma once
// Draws view states without a display on a thread of its own. All viewports share it, since VTK's fonts may be used by
// one thread only. When states come faster than they can be drawn, those in between are skipped.

#include <QImage>
#include <condition_variable>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "gui/workbench/viewport/scene_drawing.h"
#include "gui/workbench/viewport/view_state.h"

namespace netpocket {

struct DrawnPicture {
  QImage image;  // null when drawing failed
  ViewState state;
  double seconds = 0;   // that drawing took
  std::string failure;  // one sentence
};

// Thread contract: add(), remove() and request() from any thread.
class DrawingThread {
 public:
  using Deliver = std::function<void(DrawnPicture)>;

  // The one of all viewports; ends with the last that holds it.
  static std::shared_ptr<DrawingThread> shared();
  DrawingThread();
  ~DrawingThread();  // waits for the picture being drawn

  // A canvas with an OpenGL context of its own. `deliver` is called on the drawing thread.
  int add(Deliver deliver);
  // Waits for the picture being drawn; nothing is delivered afterwards.
  void remove(int canvas);
  // Size in device pixels.
  void request(int canvas, const ViewState& state, int width, int height);

 private:
  struct Request {
    ViewState state;
    int width = 0;
    int height = 0;
  };
  struct Canvas {
    Deliver deliver;
    std::optional<Request> pending;
    std::unique_ptr<SceneDrawing> drawing;  // made, used and destroyed on the drawing thread
    bool removed = false;
  };

  bool has_work() const;
  // The canvas to see to, fairly in turn.
  std::map<int, Canvas>::iterator next_work();
  void run(const std::stop_token& stop);
  static DrawnPicture draw(std::unique_ptr<SceneDrawing>& drawing, const Request& request);

  std::mutex mutex_;
  std::condition_variable_any changed_;
  std::condition_variable gone_;  // a canvas has been removed
  std::map<int, Canvas> canvases_;
  int next_ = 0;
  int last_ = -1;  // the canvas drawn last
  std::jthread thread_;
};

}  // namespace netpocket
