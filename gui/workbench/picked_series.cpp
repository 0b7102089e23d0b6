#include "gui/workbench/picked_series.h"

#include <QCoreApplication>
#include <array>
#include <limits>

#include "render/figures/palette.h"

namespace netpocket {
namespace {

struct SeriesWords {
  Q_DECLARE_TR_FUNCTIONS(PickedSeries)
};

void add(std::vector<double>& values, const Eigen::Vector3d& v) { values.insert(values.end(), {v.x(), v.y(), v.z()}); }

std::size_t curve_count(const std::vector<PickedQuantity>& quantities) {
  std::size_t count = 0;
  for (const PickedQuantity& quantity : quantities) count += quantity.names.size();
  return count;
}

}  // namespace

std::vector<PickedQuantity> quantities_of(const Pick& pick) {
  const std::vector<QString> components = {"x", "y", "z"};
  const PickedQuantity position = {SeriesWords::tr("Position"), SeriesWords::tr("Position (m)"), components};
  const PickedQuantity speed = {SeriesWords::tr("Speed"), SeriesWords::tr("Speed (m/s)"), {QString()}};
  if (pick.kind != PickKind::element) return {position, speed};
  return {{SeriesWords::tr("Tension"), SeriesWords::tr("Tension (N)"), {QString()}},
          {SeriesWords::tr("Strain"), SeriesWords::tr("Strain"), {QString()}},
          position};
}

std::vector<double> values_of(const Pick& pick, const Structure& structure, const Snapshot& frame) {
  const auto position = position_of(pick, structure, frame);
  if (!position) {
    return std::vector<double>(curve_count(quantities_of(pick)), std::numeric_limits<double>::quiet_NaN());
  }
  std::vector<double> values;
  if (pick.kind == PickKind::element) {
    values = {frame.tension[pick.index], frame.strain[pick.index]};
    add(values, *position);
    return values;
  }
  add(values, *position);
  const bool is_body = pick.kind == PickKind::body;
  const Eigen::Vector3d velocity = is_body ? frame.bodies[static_cast<std::size_t>(pick.index)].velocity
                                           : Eigen::Vector3d(frame.velocities.col(pick.index));
  values.push_back(velocity.norm());
  return values;
}

std::vector<Panel> picked_panels(const std::vector<PickedQuantity>& quantities, const std::vector<double>& times,
                                 const std::vector<std::vector<double>>& rows) {
  static constexpr std::array kColours = {kBlue, kVermillion, kGreen};
  std::vector<Panel> panels;
  std::size_t column = 0;
  for (const PickedQuantity& quantity : quantities) {
    Panel panel;
    panel.title = quantity.title.toStdString();
    panel.x.title = SeriesWords::tr("Time *t* (s)").toStdString();
    panel.y.title = quantity.axis.toStdString();
    for (std::size_t i = 0; i < quantity.names.size(); ++i, ++column) {
      Curve curve;
      curve.x = times;
      for (const auto& row : rows) curve.y.push_back(row[column]);
      curve.colour = kColours[i % kColours.size()];
      curve.label = quantity.names[i].toStdString();
      panel.curves.push_back(std::move(curve));
    }
    panels.push_back(std::move(panel));
  }
  return panels;
}

}  // namespace netpocket
