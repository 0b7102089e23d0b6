#include "render/output/render_frames.h"

#include <fmt/format.h>

#include <exception>
#include <memory>
#include <thread>

#include "render/output/bounded_queue.h"
#include "render/output/png_file.h"
#include "render/output/video_file.h"
#include "render/render_error.h"

namespace netpocket {
namespace {

// Smooths, compresses and writes frames in order on a thread of its own, while the caller draws the next ones.
class FrameWriter {
 public:
  FrameWriter(const RenderOptions& options, std::size_t total) : options_(options), total_(total) {
    const auto& frame = options.view.frame;
    if (!options.folder.empty()) make_folder(options.folder);
    if (!options.video.empty()) {
      video_ = std::make_unique<VideoFile>(options.video, frame.width, frame.height, options.video_rate);
    }
    thread_ = std::jthread([this] { run(); });
  }
  ~FrameWriter() { drawn_.close(); }

  // A frame whose memory can be used again.
  DrawnFrame recycled() { return used_.try_pop().value_or(DrawnFrame{}); }
  // False when writing has failed: finish() says why.
  bool write(DrawnFrame frame) { return drawn_.push(std::move(frame)); }

  // Waits for everything to be written; throws what went wrong.
  void finish(bool keep_video) {
    drawn_.close();
    thread_.join();
    if (failure_) std::rethrow_exception(failure_);
    if (video_ && keep_video) video_->finish();
  }

 private:
  static constexpr std::size_t kWaitingFrames = 2;

  void run() {
    try {
      while (auto frame = drawn_.pop()) {
        write_now(smooth_frame(*frame));
        used_.push(std::move(*frame));
      }
    } catch (...) {
      failure_ = std::current_exception();
      drawn_.close();
    }
    used_.close();
  }

  void write_now(const Image& image) {
    const int digits = std::max(4, static_cast<int>(fmt::formatted_size("{}", total_ - 1)));
    if (!options_.folder.empty()) write_png(image, fmt::format("{}/{:0{}}.png", options_.folder, next_++, digits));
    if (video_) video_->write(image);
  }

  const RenderOptions& options_;
  std::size_t total_;
  std::size_t next_ = 0;
  std::unique_ptr<VideoFile> video_;
  BoundedQueue<DrawnFrame> drawn_{kWaitingFrames};
  // Never full: no more frames are under way than wait, are being written and are being drawn.
  BoundedQueue<DrawnFrame> used_{kWaitingFrames + 2};
  std::exception_ptr failure_;
  std::jthread thread_;
};

}  // namespace

RenderOutcome render_frames(const Recording& recording, const std::vector<double>& times, const RenderOptions& options,
                            const RenderProgressCallback& progress, const std::stop_token& stop) {
  if (times.empty()) throw RenderError("there are no times to draw");
  RunRenderer renderer(recording, options.view);
  FrameWriter writer(options, times.size());
  const ProgressMeter meter(times.size(), progress);
  std::size_t done = 0;
  while (done < times.size() && !stop.stop_requested()) {
    if (!writer.write(renderer.draw(times[done], writer.recycled()))) break;
    meter.report(++done);
  }
  const bool complete = done == times.size();
  writer.finish(complete);
  return complete ? RenderOutcome::finished : RenderOutcome::cancelled;
}

std::vector<double> frame_times(const Recording& recording, double rate) {
  if (!(rate > 0)) throw RenderError(fmt::format("cannot draw {} frames per second", rate));
  std::vector<double> times;
  if (recording.frame_count() == 0) return times;
  const double start = recording.times().front(), end = recording.times().back();
  const auto count = static_cast<std::size_t>((end - start) * rate + 1e-6) + 1;
  for (std::size_t i = 0; i < count; ++i) times.push_back(start + static_cast<double>(i) / rate);
  return times;
}

}  // namespace netpocket
