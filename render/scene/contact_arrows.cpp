#include "render/scene/contact_arrows.h"

#include <fmt/format.h>
#include <vtkPolyDataMapper.h>

#include <algorithm>

#include "render/scene/color_scale.h"
#include "render/scene/mesh_builder.h"
#include "render/scene/palette.h"
#include "render/scene/scale_bar.h"
#include "render/scene/surface_props.h"

namespace netpocket {
namespace {

// Of the pocket's largest extent.
constexpr double kLargestLength = 0.16;
// Of the arrow's length.
constexpr double kHeadLength = 0.32, kHeadRadius = 0.10, kShaftRadius = 0.032;
constexpr int kSides = 10;
// Weaker contacts would be specks.
constexpr double kSmallestFraction = 0.02;

vtkSmartPointer<vtkPolyData> unit_arrow(const Color& color) {
  MeshBuilder mesh;
  mesh.set_color(color);
  const Eigen::Vector3d tail(0, 0, -1), neck(0, 0, -kHeadLength), tip(0, 0, 0);
  mesh.add_cylinder(tail, neck, kShaftRadius, kShaftRadius, kSides);
  mesh.add_cylinder(neck, tip, kHeadRadius, 0, kSides);
  return mesh.build();
}

}  // namespace

double high_contact_force(const Snapshot& snapshot) {
  std::vector<double> forces;
  for (const auto& contact : snapshot.contacts) forces.push_back(contact.force.norm());
  if (forces.empty()) return 0;
  const auto place = forces.begin() + static_cast<std::ptrdiff_t>(0.98 * static_cast<double>(forces.size() - 1));
  std::ranges::nth_element(forces, place);
  return *place;
}

ArrowScale::ArrowScale(const DisplayOptions& options)
    : fixed_(options.arrow_force.has_value()), largest_force_(options.arrow_force.value_or(0)) {}

void ArrowScale::update(const Snapshot& snapshot) {
  if (largest_length_ == 0 && snapshot.positions.cols() > 0) {
    const Eigen::Vector3d extent = snapshot.positions.rowwise().maxCoeff() - snapshot.positions.rowwise().minCoeff();
    largest_length_ = kLargestLength * extent.maxCoeff();
  }
  const double high = high_contact_force(snapshot);
  if (!fixed_ && high > largest_force_) largest_force_ = round_up(high);
}

double ArrowScale::length(double force) const {
  return largest_force_ > 0 ? largest_length_ * std::min(force / largest_force_, 1.0) : 0;
}

ContactArrows::ContactArrows(ArrowScale& scale, const SceneOptions& options)
    : scale_(scale), arrow_(unit_arrow(palette(options.background).contact)) {
  vtkNew<vtkPolyData> nothing;
  actor_ = make_surface(nothing, options.background);
  make_room(64);
  props_ = {actor_};
}

void ContactArrows::make_room(std::size_t arrows) {
  if (arrows <= room_) return;
  room_ = std::max(arrows, 2 * room_);
  arrows_ = std::make_unique<RepeatedMesh>(arrow_, room_);
  vtkPolyDataMapper::SafeDownCast(actor_->GetMapper())->SetInputData(arrows_->mesh());
}

void ContactArrows::update(const Snapshot& snapshot) {
  scale_.update(snapshot);
  make_room(snapshot.contacts.size());
  for (std::size_t i = 0; i < room_; ++i) {
    Eigen::Matrix3d axes = Eigen::Matrix3d::Zero();  // what is not used shrinks to a point
    Eigen::Vector3d tip = Eigen::Vector3d::Zero();
    if (i < snapshot.contacts.size()) {
      const auto& contact = snapshot.contacts[i];
      const double force = contact.force.norm(), length = scale_.length(force);
      tip = contact.position;
      if (length > kSmallestFraction * scale_.largest_length()) {
        const Eigen::Vector3d direction = contact.force / force;
        const auto cross = cross_axes(direction);
        // Short arrows keep some of their width.
        const double width = std::sqrt(length * scale_.largest_length()) * 0.7;
        axes << width * cross.first, width * cross.second, length * direction;
      }
    }
    arrows_->place(i, axes, tip);
  }
  arrows_->modified();
}

ArrowLegend::ArrowLegend(const ArrowScale& scale, const SceneOptions& options)
    : scale_(scale), options_(options), label_(palette(options.background).text, Align::right) {
  props_ = {arrow_.prop(), label_.prop()};
}

void ArrowLegend::adapt(const View& view) {
  const double unit = view.scale() * options_.annotation_scale;
  const double length = scale_.largest_length() / pixel_length(view);
  const double head = kHeadLength * length, half_width = 0.7 * kHeadRadius * length;
  const Eigen::Vector2d tip(view.width - 34 * unit, 88 * unit);
  const Eigen::Vector2d along = Eigen::Vector2d::UnitX(), side = Eigen::Vector2d::UnitY() * half_width;
  const auto& color = palette(options_.background).contact;
  arrow_.clear();
  if (scale_.largest_force() == 0) return label_.set_text("");
  arrow_.add_line(tip - length * along, tip - head * along, 1.4 * kShaftRadius * length, color);
  arrow_.add_triangle(tip, tip - head * along + side, tip - head * along - side, color);
  label_.set_text(fmt::format("contact \u2265 {:g} N", scale_.largest_force()));
  label_.place(tip + Eigen::Vector2d(0, half_width + 14 * unit), 16 * unit);
}

}  // namespace netpocket
