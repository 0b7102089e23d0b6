#include "gui/workbench/viewport/drawing_thread.h"

#include <vtkNew.h>
#include <vtkUnsignedCharArray.h>

#include <chrono>

#include "gui/workbench/viewport/scene_drawing.h"
#include "render/gl/gl_host.h"

namespace netpocket {
namespace {

// The window's picture; VTK's rows run from the bottom.
QImage read_image(HostedRenderWindow& window) {
  const int* size = window.GetSize();
  vtkNew<vtkUnsignedCharArray> pixels;
  window.GetRGBACharPixelData(0, 0, size[0] - 1, size[1] - 1, 0, pixels);
  return QImage(pixels->GetPointer(0), size[0], size[1], QImage::Format_RGBX8888)
      .mirrored()
      .convertToFormat(QImage::Format_RGB32);
}

}  // namespace

DrawingThread::DrawingThread(std::function<void(DrawnPicture)> deliver)
    : deliver_(std::move(deliver)), thread_([this](const std::stop_token& stop) { run(stop); }) {}

DrawingThread::~DrawingThread() = default;

void DrawingThread::request(const ViewState& state, int width, int height) {
  const std::lock_guard lock(mutex_);
  pending_ = Request{state, width, height};
  changed_.notify_one();
}

std::optional<DrawingThread::Request> DrawingThread::wait_for_request(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  if (!changed_.wait(lock, stop, [this] { return pending_.has_value(); })) return std::nullopt;
  return std::exchange(pending_, std::nullopt);
}

void DrawingThread::run(const std::stop_token& stop) {
  try {
    draw_all(stop);
  } catch (const std::exception& error) {
    deliver_({{}, {}, 0, error.what()});
  }
}

void DrawingThread::draw_all(const std::stop_token& stop) {
  SceneDrawing drawing(make_gl_host(GlBackend::automatic));
  while (const auto request = wait_for_request(stop)) {
    const auto start = std::chrono::steady_clock::now();
    drawing.draw(request->state, request->width, request->height);
    QImage image = read_image(drawing.window());
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    deliver_({std::move(image), request->state, elapsed.count(), {}});
  }
}

}  // namespace netpocket
