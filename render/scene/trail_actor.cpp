#include "render/scene/trail_actor.h"

#include <vtkCellArray.h>
#include <vtkPoints.h>
#include <vtkProperty.h>

#include <algorithm>

#include "render/scene/depth_fading.h"
#include "render/scene/palette.h"
#include "render/scene/surface_props.h"

namespace netpocket {
namespace {

constexpr double kWidth = 2.4, kDot = 8;  // pixels of a picture 720 pixels high
constexpr double kInFront = 1;            // of everything: the whole depth

const Color& trail_color(BodyRole role, Background background) {
  const auto& colors = palette(background);
  return role == BodyRole::target ? colors.target_trail : colors.spacecraft_trail;
}

void set_points(vtkPolyData& mesh, const Eigen::Matrix3Xd& positions) {
  vtkNew<vtkFloatArray> array;
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(positions.cols());
  Eigen::Map<Eigen::Matrix3Xf>(array->GetPointer(0), 3, positions.cols()) = positions.cast<float>();
  vtkNew<vtkPoints> points;
  points->SetData(array);
  mesh.SetPoints(points);
}

vtkSmartPointer<vtkCellArray> one_cell(vtkIdType point_count) {
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->InsertNextCell(static_cast<int>(point_count));
  for (vtkIdType i = 0; i < point_count; ++i) cells->InsertCellPoint(i);
  return cells;
}

}  // namespace

TrailActor::TrailActor(const Structure& structure, const SceneOptions& options) : line_scale_(options.line_scale) {
  for (const auto& body : structure.bodies) {
    auto trail = std::make_unique<Trail>();
    const auto& color = trail_color(body.role, options.background);
    set_points(*trail->line, Eigen::Matrix3Xd(3, 0));
    set_points(*trail->dot, Eigen::Matrix3Xd::Zero(3, 1));
    trail->dot->SetVerts(one_cell(1));
    trail->line_actor = make_lines(trail->line, color);
    trail->dot_actor = make_dots(trail->dot, color);
    for (const auto& actor : {trail->line_actor, trail->dot_actor}) {
      add_depth_fading(*actor, color, kInFront);
      props_.emplace_back(actor);
    }
    trails_.push_back(std::move(trail));
  }
}

void TrailActor::set_history(const SceneHistory& history) { paths_ = history.paths; }

void TrailActor::update(const Snapshot& snapshot) {
  for (std::size_t i = 0; i < trails_.size(); ++i) set_points(*trails_[i]->dot, snapshot.bodies[i].position);
  for (const auto& path : paths_) {
    auto& line = *trails_[path.body]->line;
    const auto past = std::ranges::lower_bound(path.times, snapshot.time) - path.times.begin();
    Eigen::Matrix3Xd positions(3, past + 1);
    positions << path.positions.leftCols(past), snapshot.bodies[path.body].position;
    set_points(line, positions);
    line.SetLines(one_cell(positions.cols()));
  }
}

void TrailActor::adapt(const View& view) {
  const double scale = view.scale() * line_scale_;
  for (const auto& trail : trails_) {
    trail->line_actor->GetProperty()->SetLineWidth(static_cast<float>(std::max(kWidth * scale, 1.5)));
    trail->dot_actor->GetProperty()->SetPointSize(static_cast<float>(std::max(kDot * scale, 4.0)));
    for (const auto& actor : {trail->line_actor, trail->dot_actor}) set_depth_fading(*actor, *view.camera, 0);
  }
}

}  // namespace netpocket
