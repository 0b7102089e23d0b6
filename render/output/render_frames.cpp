#include "render/output/render_frames.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <limits>
#include <memory>
#include <optional>
#include <thread>

#include "engine/analysis/run_labels.h"
#include "engine/base/folder.h"
#include "render/output/bounded_queue.h"
#include "render/output/picture_comment.h"
#include "render/output/png_file.h"
#include "render/output/side_by_side.h"
#include "render/output/video_file.h"
#include "render/render_error.h"

namespace netpocket {
namespace {

// A picture under way: drawn, one frame for each run, or a file from before.
struct Picture {
  std::vector<DrawnFrame> frames;
  std::string comment;   // says what the picture shows
  std::string existing;  // path; empty: drawn
};

// A used picture's memory is used again.
Image joined(const std::vector<DrawnFrame>& frames, Image used) {
  if (frames.size() == 1) return smooth_frame(frames.front(), std::move(used));
  std::vector<Image> images;
  images.reserve(frames.size());
  for (const auto& frame : frames) images.push_back(smooth_frame(frame));
  return side_by_side(images);
}

// Smooths, compresses and writes frames in order on a thread of its own, while the caller draws the next ones.
class FrameWriter {
 public:
  FrameWriter(const RenderOptions& options, std::size_t runs, std::size_t total) : options_(options), total_(total) {
    const auto& frame = options.view.frame;
    if (!options.folder.empty()) make_folder(options.folder);
    if (!options.video.empty()) {
      const int width = frame.width * static_cast<int>(runs);
      video_ = options.video_bytes == nullptr
                   ? std::make_unique<VideoFile>(options.video, width, frame.height, options.video_rate)
                   : std::make_unique<VideoFile>(options.video, *options.video_bytes, width, frame.height,
                                                 options.video_rate);
    }
    thread_ = std::jthread([this] { run(); });
  }
  ~FrameWriter() { drawn_.close(); }

  // The file of a picture; empty when there is none.
  std::string path(std::size_t index) const {
    if (options_.folder.empty()) return {};
    return options_.folder + "/" + picture_file_name(index, total_);
  }
  // Frames whose memory can be used again.
  std::vector<DrawnFrame> recycled() { return used_.try_pop().value_or(std::vector<DrawnFrame>{}); }
  // The next picture. False when writing has failed: finish() says why.
  bool write(Picture picture) { return drawn_.push(std::move(picture)); }

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
      for (std::size_t index = 0; auto picture = drawn_.pop(); ++index) {
        write_now(*picture, path(index));
        if (picture->existing.empty()) used_.push(std::move(picture->frames));
      }
    } catch (...) {
      failure_ = std::current_exception();
      drawn_.close();
    }
    used_.close();
  }

  void write_now(const Picture& picture, const std::string& path) {
    if (!picture.existing.empty()) {
      if (video_) video_->write(read_png(picture.existing));
      return;
    }
    image_ = joined(picture.frames, std::move(image_));
    if (!path.empty()) png_.write(image_, path, picture.comment);
    if (video_) video_->write(image_);
  }

  const RenderOptions& options_;
  std::size_t total_;
  std::unique_ptr<VideoFile> video_;
  PngWriter png_;
  Image image_;
  BoundedQueue<Picture> drawn_{kWaitingFrames};
  // Never full: no more frames are under way than wait, are being written and are being drawn.
  BoundedQueue<std::vector<DrawnFrame>> used_{kWaitingFrames + 2};
  std::exception_ptr failure_;
  std::jthread thread_;
};

// Draws the pictures' frames; made when the first one is needed, so that there is nothing to wait for when all exist.
class RunRow {
 public:
  RunRow(const std::vector<const Recording*>& recordings, const RunView& view) {
    const RunView common = common_view(recordings, view);
    const auto labels = run_labels(recordings);
    for (std::size_t i = 0; i < recordings.size(); ++i) {
      RunView own = common;
      if (recordings.size() > 1) own.frame.scene.title = joint_title(view.frame.scene.title, labels[i]);
      renderers_.push_back(std::make_unique<RunRenderer>(*recordings[i], own));
    }
  }

  std::vector<DrawnFrame> draw(double time, std::vector<DrawnFrame> used) {
    used.resize(renderers_.size());
    for (std::size_t i = 0; i < used.size(); ++i) used[i] = renderers_[i]->draw(time, std::move(used[i]));
    return used;
  }

 private:
  static std::string joint_title(const std::string& title, const std::string& name) {
    return title.empty() ? name : fmt::format("{}: {}", title, name);
  }

  std::vector<std::unique_ptr<RunRenderer>> renderers_;
};

}  // namespace

std::string picture_file_name(std::size_t index, std::size_t total) {
  const int digits = std::max(4, static_cast<int>(fmt::formatted_size("{}", total - 1)));
  return fmt::format("{:0{}}.png", index, digits);
}

RenderOutcome render_frames(const Recording& recording, const std::vector<double>& times, const RenderOptions& options,
                            const RenderProgressCallback& progress, const std::stop_token& stop) {
  return render_frames(std::vector{&recording}, times, options, progress, stop);
}

RenderOutcome render_frames(const std::vector<const Recording*>& recordings, const std::vector<double>& times,
                            const RenderOptions& options, const RenderProgressCallback& progress,
                            const std::stop_token& stop) {
  if (recordings.empty() || times.empty()) throw RenderError("there are no times to draw");
  std::optional<RunRow> row;
  FrameWriter writer(options, recordings.size(), times.size());
  const PictureComment comment(recordings, options.view);
  const ProgressMeter meter(times.size(), progress);
  std::size_t done = 0;
  while (done < times.size() && !stop.stop_requested()) {
    Picture picture{{}, comment.at(times[done]), {}};
    if (options.resume && png_comment(writer.path(done)) == picture.comment) picture.existing = writer.path(done);
    if (picture.existing.empty()) {
      if (!row) row.emplace(recordings, options.view);
      picture.frames = row->draw(times[done], writer.recycled());
    }
    if (!writer.write(std::move(picture))) break;
    meter.report(++done);
  }
  const bool complete = done == times.size();
  writer.finish(complete);
  return complete ? RenderOutcome::finished : RenderOutcome::cancelled;
}

std::vector<double> frame_times(const Recording& recording, double rate) {
  return frame_times(std::vector{&recording}, rate);
}

std::vector<double> frame_times(const std::vector<const Recording*>& recordings, double rate) {
  if (!(rate > 0)) throw RenderError(fmt::format("cannot draw {} frames per second", rate));
  std::vector<double> times;
  double start = std::numeric_limits<double>::infinity(), end = -start;
  for (const auto* recording : recordings) {
    if (recording->frame_count() == 0) continue;
    start = std::min(start, recording->times().front());
    end = std::max(end, recording->times().back());
  }
  if (start > end) return times;
  const auto count = static_cast<std::size_t>((end - start) * rate + 1e-6) + 1;
  for (std::size_t i = 0; i < count; ++i) times.push_back(start + static_cast<double>(i) / rate);
  return times;
}

}  // namespace netpocket
