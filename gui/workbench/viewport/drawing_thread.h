#pragma once
// Draws view states without a display on a thread of its own. When states come faster than they can be drawn, those in
// between are skipped.

#include <QImage>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "gui/workbench/viewport/view_state.h"

namespace netpocket {

struct DrawnPicture {
  QImage image;  // null when drawing failed
  ViewState state;
  double seconds = 0;   // that drawing took
  std::string failure;  // one sentence
};

class DrawingThread {
 public:
  // `deliver` is called on the drawing thread.
  explicit DrawingThread(std::function<void(DrawnPicture)> deliver);
  ~DrawingThread();  // waits for the picture being drawn

  // Size in device pixels. Any thread.
  void request(const ViewState& state, int width, int height);

 private:
  struct Request {
    ViewState state;
    int width = 0;
    int height = 0;
  };

  std::optional<Request> wait_for_request(const std::stop_token& stop);
  void run(const std::stop_token& stop);
  void draw_all(const std::stop_token& stop);

  std::function<void(DrawnPicture)> deliver_;
  std::mutex mutex_;
  std::condition_variable_any changed_;
  std::optional<Request> pending_;
  std::jthread thread_;
};

}  // namespace netpocket
