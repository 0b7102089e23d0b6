#include "gui/workbench/start/scenario_sketch.h"

#include <vtkCellArray.h>
#include <vtkIdList.h>
#include <vtkPointData.h>
#include <vtkUnsignedCharArray.h>

#include <QPainter>
#include <algorithm>
#include <cmath>
#include <vector>

#include "gui/workbench/viewport/orbit_camera.h"
#include "render/scene/body_mesh.h"
#include "render/scene/element_curve.h"
#include "render/scene/palette.h"
#include "render/scene/visible_points.h"

namespace netpocket {
namespace {

constexpr double kAmbient = 0.62;         // of a face that the light does not reach
constexpr int kCurvePieces = 3;           // of an element's curve
constexpr double kLineScale = 1 / 220.0;  // pixels of width for a pixel of the picture's height

QColor colour_of(const Color& color) {
  return QColor::fromRgbF(static_cast<float>(color[0]), static_cast<float>(color[1]), static_cast<float>(color[2]));
}

// Something flat: a face, or a piece of a cable.
struct Stroke {
  double depth = 0;  // m
  QPolygonF points;
  QColor colour;
  double width = 0;  // pixels; 0: a filled face
};

class Sketch {
 public:
  Sketch(const PocketPreview& pocket, const QSize& pixels, Background background)
      : structure_(*pocket.structure),
        snapshot_(*pocket.snapshot),
        pixels_(pixels),
        palette_(palette(background)),
        camera_(frame_view(CameraPreset::iso, visible_points(structure_, snapshot_),
                           static_cast<double>(pixels.width()) / pixels.height(), {0.94, 0.92})) {}

  QImage draw() {
    for (std::size_t i = 0; i < structure_.bodies.size(); ++i) add_body(i);
    add_cables();
    add_rope_lines();
    // What is far away is drawn first and covered by what is near.
    std::ranges::stable_sort(strokes_, std::ranges::greater(), &Stroke::depth);
    QImage image(pixels_, QImage::Format_RGB32);
    image.fill(colour_of(palette_.background));
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    for (const Stroke& stroke : strokes_) paint(painter, stroke);
    return image;
  }

 private:
  static void paint(QPainter& painter, const Stroke& stroke) {
    if (stroke.width == 0) {
      // Its own colour round it, too: no seam is left between neighbours.
      painter.setPen(QPen(stroke.colour, 1));
      painter.setBrush(stroke.colour);
      painter.drawPolygon(stroke.points);
      return;
    }
    painter.setPen(QPen(stroke.colour, stroke.width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPolyline(stroke.points);
  }

  // False when a point is behind the camera.
  bool project(const std::vector<Eigen::Vector3d>& points, Stroke& stroke) const {
    for (const Eigen::Vector3d& point : points) {
      const auto seen = camera_.project(point, pixels_);
      if (!seen) return false;
      stroke.points << seen->position;
      stroke.depth += seen->depth / static_cast<double>(points.size());
    }
    return true;
  }

  // Bodies but the spacecraft hold no rods; their ring is as wide as the nodes on it lie apart.
  BodyMesh mesh_of(std::size_t index) const {
    const StructureBody& body = structure_.bodies[index];
    if (body.role != BodyRole::spacecraft) return shape_mesh(body.shape, palette_);
    double radius = 0, height = 0;
    const std::vector<std::int32_t> nodes = structure_.nodes(NodeLook::adapter);
    for (const std::int32_t node : nodes) {
      const BodyState& state = snapshot_.bodies[index];
      const Eigen::Vector3d arm = state.attitude.conjugate() * (snapshot_.positions.col(node) - state.position);
      radius += std::hypot(arm.x(), arm.z()) / static_cast<double>(nodes.size());
      height += arm.y() / static_cast<double>(nodes.size());
    }
    return spacecraft_mesh(body.shape, radius, height);
  }

  void add_body(std::size_t index) {
    const vtkSmartPointer<vtkPolyData> surface = mesh_of(index).surface;
    auto* colors = vtkUnsignedCharArray::SafeDownCast(surface->GetPointData()->GetScalars());
    vtkNew<vtkIdList> corners;
    vtkCellArray* faces = surface->GetPolys();
    for (vtkIdType face = 0; face < faces->GetNumberOfCells(); ++face) {
      faces->GetCellAtId(face, corners);
      QColor colour = colour_of(palette_.target);
      if (colors != nullptr) {
        double rgb[4] = {};
        colors->GetTuple(corners->GetId(0), rgb);
        colour = QColor(static_cast<int>(rgb[0]), static_cast<int>(rgb[1]), static_cast<int>(rgb[2]));
      }
      add_face(*surface, *corners, snapshot_.bodies[index], colour);
    }
  }

  void add_face(vtkPolyData& surface, vtkIdList& corners, const BodyState& body, const QColor& colour) {
    std::vector<Eigen::Vector3d> points;
    for (vtkIdType i = 0; i < corners.GetNumberOfIds(); ++i) {
      points.push_back(body.position + body.attitude * Eigen::Vector3d(surface.GetPoint(corners.GetId(i))));
    }
    if (points.size() < 3) return;
    const Eigen::Vector3d area = (points[1] - points[0]).cross(points[2] - points[0]);
    const Eigen::Vector3d towards = camera_.view().position - points[0];
    if (area.norm() == 0 || area.dot(towards) <= 0) return;  // its back
    Stroke stroke;
    if (!project(points, stroke)) return;
    const double light = kAmbient + (1 - kAmbient) * area.normalized().dot(towards.normalized());
    stroke.colour =
        QColor::fromRgbF(static_cast<float>(colour.redF() * light), static_cast<float>(colour.greenF() * light),
                         static_cast<float>(colour.blueF() * light));
    strokes_.push_back(std::move(stroke));
  }

  void add_cables() {
    const ElementCurve curve(kCurvePieces);
    for (const StructureElement& element : structure_.elements) {
      for (int i = 0; i < kCurvePieces; ++i) {
        Stroke stroke;
        const std::vector<Eigen::Vector3d> ends = {curve.position(snapshot_, element, i),
                                                   curve.position(snapshot_, element, i + 1)};
        if (!project(ends, stroke)) continue;
        set_look(structure_.look_of(element), stroke);
        strokes_.push_back(std::move(stroke));
      }
    }
  }

  // Ropes that run straight from node to node.
  void add_rope_lines() {
    for (const NodeGroup& group : structure_.node_groups) {
      if (group.look != NodeLook::rope) continue;
      for (std::size_t i = 0; i + 1 < group.nodes.size(); ++i) {
        Stroke stroke;
        const std::vector<Eigen::Vector3d> ends = {snapshot_.positions.col(group.nodes[i]),
                                                   snapshot_.positions.col(group.nodes[i + 1])};
        if (!project(ends, stroke)) continue;
        set_look(CableLook::rope, stroke);
        strokes_.push_back(std::move(stroke));
      }
    }
  }

  void set_look(CableLook look, Stroke& stroke) const {
    const double unit = kLineScale * pixels_.height();
    switch (look) {
      case CableLook::cord:
        stroke.colour = colour_of(palette_.net);
        stroke.width = 0.8 * unit;
        return;
      case CableLook::tube:
        stroke.colour = colour_of(palette_.rods);
        stroke.width = 2.6 * unit;
        return;
      case CableLook::rope:
        stroke.colour = colour_of(palette_.closing_ropes);
        stroke.width = 2 * unit;
        return;
    }
  }

  const Structure& structure_;
  const Snapshot& snapshot_;
  QSize pixels_;
  const Palette& palette_;
  OrbitCamera camera_;
  std::vector<Stroke> strokes_;
};

}  // namespace

QImage sketch_pocket(const PocketPreview& pocket, const QSize& pixels, Background background) {
  return Sketch(pocket, pixels, background).draw();
}

}  // namespace netpocket
