#include "render/scene/time_label.h"

#include <fmt/format.h>

namespace netpocket {
namespace {

// Frames are a whole number of steps apart: the one "at 10 s" may be a step short of it.
constexpr double kFrameTolerance = 1e-3;  // s

}  // namespace

std::string phase_name(const std::vector<Phase>& phases, double time) {
  return phase_at(phases, time + kFrameTolerance);
}

TimeLabel::TimeLabel(const SceneOptions& options, const Color& color)
    : options_(options), title_(color, Align::left, true), time_(color, Align::left), phase_(color, Align::left) {
  title_.set_text(options.title);
  if (!options.title.empty()) props_.push_back(title_.prop());
  if (options.time_label) props_.push_back(time_.prop());
  if (options.time_label && !options.phases.empty()) props_.push_back(phase_.prop());
}

void TimeLabel::update(const Snapshot& snapshot) {
  if (!options_.time_label) return;
  time_.set_text(fmt::format("t = {:.2f} s", snapshot.time));
  if (!options_.phases.empty()) phase_.set_text(phase_name(options_.phases, snapshot.time));
}

void TimeLabel::adapt(const View& view) {
  const double unit = view.scale() * options_.annotation_scale;
  double y = view.height - 38 * unit;
  const double x = 28 * unit;
  if (!options_.title.empty()) {
    title_.place_within({x, y}, 23 * unit, view.width - 2 * x);
    y -= 32 * unit;
  }
  time_.place({x, y}, 21 * unit);
  phase_.place({x, y - 27 * unit}, 17 * unit);
}

}  // namespace netpocket
