#include "render/output/picture_comment.h"

#include <fmt/format.h>

#include <filesystem>

namespace netpocket {
namespace {

// FNV-1a (Fowler, Noll, Vo), 64 bits.
std::uint64_t fingerprint(const std::string& text) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  return hash;
}

std::string numbers(const Eigen::Vector3d& v) { return fmt::format("{},{},{} ", v.x(), v.y(), v.z()); }

std::string content(const Recording& recording) {
  const auto& origin = recording.origin();
  return fmt::format("{}|{}|{}|{}|{}|", origin.scenario_text, origin.commit, origin.command, recording.frame_count(),
                     recording.frame_count() ? recording.times().back() : 0);
}

std::string content(const RunView& view) {
  const auto& frame = view.frame;
  const auto& scene = frame.scene;
  const auto range = scene.color_range.value_or(ValueRange{0, 0});
  std::string text = fmt::format("{}x{} {} ", frame.width, frame.height, frame.supersampling);
  text +=
      fmt::format("{} {} {} {} {} {} ", static_cast<int>(scene.background), static_cast<int>(scene.color_by), range.low,
                  range.high, scene.color_map ? static_cast<int>(*scene.color_map) : -1, scene.target_opacity);
  for (const bool shown : {scene.contact_arrows, scene.trails, scene.ghost, scene.legend, scene.time_label,
                           scene.scale_bar, scene.axes, scene.fast_smoothing, scene.transparent_background}) {
    text += shown ? '1' : '0';
  }
  text += fmt::format(" {} '{}' {} {} ", scene.arrow_force.value_or(0), scene.title, scene.line_scale,
                      scene.annotation_scale);
  for (const Phase& phase : scene.phases) text += fmt::format("{} {} {} ", phase.name, phase.begin, phase.end);
  text += fmt::format("{} {} {} ", static_cast<int>(view.camera), view.share.width, view.share.height);
  if (!view.view) return text;
  const auto& camera = *view.view;
  return text + numbers(camera.position) + numbers(camera.focal_point) + numbers(camera.view_up) +
         fmt::format("{} {}", camera.view_angle, camera.half_height);
}

}  // namespace

PictureComment::PictureComment(const std::vector<const Recording*>& recordings, const RunView& view) {
  std::string all = content(view);
  for (const auto* recording : recordings) {
    if (!names_.empty()) names_ += ", ";
    names_ += std::filesystem::path(recording->path()).filename().string();
    all += content(*recording);
  }
  fingerprint_ = fmt::format("{:016x}", fingerprint(all));
}

std::string PictureComment::at(double time) const {
  return fmt::format("{}, t = {:.6f} s, view {}", names_, time, fingerprint_);
}

}  // namespace netpocket
