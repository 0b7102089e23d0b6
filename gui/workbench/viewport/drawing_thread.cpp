#include "gui/workbench/viewport/drawing_thread.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>

#include "render/gl/gl_host.h"

namespace netpocket {
namespace {

// Where the engine and the drawing want the same processor, the engine comes first. Threads that a software OpenGL
// starts inherit this. Linux gives each thread a priority of its own.
void give_way_to_the_engine() {
  constexpr int kNice = 10;
  setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), kNice);
}

// The window's picture; OpenGL's rows run from the bottom.
QImage read_image(HostedRenderWindow& window) {
  const int* size = window.GetSize();
  QImage image(size[0], size[1], QImage::Format_RGBX8888);
  window.read_rgba(image.bits());
  image.mirror();
  image.convertTo(QImage::Format_RGB32);
  return image;
}

}  // namespace

std::shared_ptr<DrawingThread> DrawingThread::shared() {
  static std::mutex mutex;
  static std::weak_ptr<DrawingThread> existing;
  const std::lock_guard lock(mutex);
  auto thread = existing.lock();
  if (!thread) existing = thread = std::make_shared<DrawingThread>();
  return thread;
}

DrawingThread::DrawingThread() : thread_([this](const std::stop_token& stop) { run(stop); }) {}

DrawingThread::~DrawingThread() = default;

int DrawingThread::add(Deliver deliver) {
  const std::lock_guard lock(mutex_);
  canvases_[next_].deliver = std::move(deliver);
  return next_++;
}

void DrawingThread::remove(int canvas) {
  std::unique_lock lock(mutex_);
  const auto place = canvases_.find(canvas);
  if (place == canvases_.end()) return;
  place->second.removed = true;
  changed_.notify_one();
  gone_.wait(lock, [&] { return !canvases_.contains(canvas); });
}

void DrawingThread::request(int canvas, const ViewState& state, int width, int height) {
  const std::lock_guard lock(mutex_);
  const auto place = canvases_.find(canvas);
  if (place == canvases_.end()) return;
  place->second.pending = Request{state, width, height};
  changed_.notify_one();
}

bool DrawingThread::has_work() const {
  return std::ranges::any_of(canvases_, [](const auto& c) { return c.second.removed || c.second.pending; });
}

std::map<int, DrawingThread::Canvas>::iterator DrawingThread::next_work() {
  auto place = canvases_.upper_bound(last_);
  for (std::size_t i = 0; i < canvases_.size(); ++i, ++place) {
    if (place == canvases_.end()) place = canvases_.begin();
    if (place->second.removed || place->second.pending) break;
  }
  last_ = place->first;
  return place;
}

void DrawingThread::run(const std::stop_token& stop) {
  give_way_to_the_engine();
  std::unique_lock lock(mutex_);
  while (changed_.wait(lock, stop, [this] { return has_work(); })) {
    // Only this thread takes canvases out, so the place stays good while the lock is not held.
    const auto place = next_work();
    Canvas& canvas = place->second;
    if (canvas.removed) {
      canvas.drawing.reset();
      canvases_.erase(place);
      gone_.notify_all();
      continue;
    }
    const Request request = *std::exchange(canvas.pending, std::nullopt);
    lock.unlock();
    DrawnPicture picture = draw(canvas.drawing, request);
    canvas.deliver(std::move(picture));
    lock.lock();
  }
}

DrawnPicture DrawingThread::draw(std::unique_ptr<SceneDrawing>& drawing, const Request& request) {
  try {
    const auto start = std::chrono::steady_clock::now();
    if (!drawing) {
      drawing = std::make_unique<SceneDrawing>(make_gl_host(GlBackend::automatic));
      drawing->window().keep_where_drawn();
    }
    drawing->draw(request.state, request.width, request.height);
    QImage image = read_image(drawing->window());
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    return {std::move(image), request.state, elapsed.count(), {}};
  } catch (const std::exception& error) {
    return {{}, {}, 0, error.what()};
  }
}

}  // namespace netpocket
