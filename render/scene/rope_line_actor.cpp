#include "render/scene/rope_line_actor.h"

#include <vtkCellArray.h>
#include <vtkPoints.h>
#include <vtkProperty.h>

#include <algorithm>

#include "render/scene/depth_fading.h"
#include "render/scene/surface_props.h"

namespace netpocket {

RopeLineActor::RopeLineActor(const Structure& structure, const CordStyle& style) : style_(style) {
  vtkNew<vtkCellArray> lines;
  for (const NodeGroup& group : structure.node_groups) {
    if (group.look != NodeLook::rope) continue;
    lines->InsertNextCell(static_cast<int>(group.nodes.size()));
    for (const std::int32_t node : group.nodes) {
      lines->InsertCellPoint(static_cast<vtkIdType>(nodes_.size()));
      nodes_.push_back(node);
    }
  }
  positions_->SetNumberOfComponents(3);
  positions_->SetNumberOfTuples(static_cast<vtkIdType>(nodes_.size()));
  positions_->FillValue(0);
  vtkNew<vtkPoints> points;
  points->SetData(positions_);
  mesh_->SetPoints(points);
  mesh_->SetLines(lines);
  actor_ = make_lines(mesh_, style_.color);
  props_ = {actor_};
  if (style_.fading > 0) add_depth_fading(*actor_, style_.distance_color, style_.nearer);
}

void RopeLineActor::update(const Snapshot& snapshot) {
  float* position = positions_->GetPointer(0);
  for (const std::int32_t node : nodes_) {
    Eigen::Map<Eigen::Vector3f>{position} = snapshot.positions.col(node).cast<float>();
    position += 3;
  }
  positions_->Modified();
  mesh_->GetPoints()->Modified();
  mesh_->Modified();
}

void RopeLineActor::adapt(const View& view) {
  actor_->GetProperty()->SetLineWidth(static_cast<float>(std::max(style_.width * view.scale(), style_.smallest_width)));
  if (style_.fading > 0) set_depth_fading(*actor_, *view.camera, style_.fading);
}

}  // namespace netpocket
