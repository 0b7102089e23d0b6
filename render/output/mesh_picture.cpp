#include "render/output/mesh_picture.h"

#include <vtkCellArray.h>
#include <vtkFeatureEdges.h>
#include <vtkMapper.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyDataNormals.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <memory>

#include "render/gl/hosted_render_window.h"
#include "render/output/frame_renderer.h"
#include "render/scene/axes_triad.h"
#include "render/scene/camera.h"
#include "render/scene/palette.h"
#include "render/scene/scale_bar.h"
#include "render/scene/surface_props.h"

namespace netpocket {
namespace {

constexpr Background kGround = Background::white;
constexpr Color kBack = {0.90, 0.62, 0.00};  // of sides that face away
constexpr Color kFault = {0.80, 0.05, 0.20};
constexpr int kSmoothing = 2;
constexpr double kFeatureAngle = 30;  // degrees

vtkSmartPointer<vtkPolyData> poly_data(const MeshData& mesh, bool turned) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Eigen::Vector3d& vertex : mesh.vertices) points->InsertNextPoint(vertex.data());
  vtkNew<vtkCellArray> polygons;
  for (const auto& [a, b, c] : mesh.triangles)
    polygons->InsertNextCell(turned ? std::initializer_list<vtkIdType>{a, c, b}
                                    : std::initializer_list<vtkIdType>{a, b, c});
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->SetPoints(points);
  surface->SetPolys(polygons);
  return surface;
}

vtkSmartPointer<vtkActor> surface_actor(const MeshData& mesh, bool turned, const Color& color) {
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(poly_data(mesh, turned));
  normals->SetFeatureAngle(kFeatureAngle);
  normals->ConsistencyOff();
  normals->AutoOrientNormalsOff();
  normals->Update();
  return make_surface(normals->GetOutput(), kGround, color);
}

vtkSmartPointer<vtkActor> sharp_edges(const MeshData& mesh, double width) {
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputData(poly_data(mesh, false));
  edges->SetFeatureAngle(kFeatureAngle);
  edges->NonManifoldEdgesOff();
  edges->ColoringOff();
  edges->Update();
  auto lines = make_lines(edges->GetOutput(), palette(kGround).net);
  lines->GetProperty()->SetLineWidth(static_cast<float>(width));
  // A line between two faces lies in both: it is drawn as if a little nearer.
  lines->GetMapper()->SetResolveCoincidentTopologyToPolygonOffset();
  lines->GetMapper()->SetRelativeCoincidentTopologyLineOffsetParameters(0, -4);
  return lines;
}

vtkSmartPointer<vtkActor> open_edges(const MeshPicture& picture, double width) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  for (const auto& [from, to] : picture.open_edges) {
    const vtkIdType first = points->InsertNextPoint(from.data());
    points->InsertNextPoint(to.data());
    lines->InsertNextCell({first, first + 1});
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetLines(lines);
  auto actor = make_lines(data, kFault);
  actor->GetProperty()->SetLineWidth(static_cast<float>(width));
  return actor;
}

vtkSmartPointer<vtkActor> fault_dots(const MeshPicture& picture, double size) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> dots;
  for (const Eigen::Vector3d& place : picture.faults) dots->InsertNextCell({points->InsertNextPoint(place.data())});
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetVerts(dots);
  auto actor = make_dots(data, kFault);
  actor->GetProperty()->SetPointSize(static_cast<float>(size));
  return actor;
}

// Corners of the box round the mesh.
Eigen::Matrix3Xd framed_points(const MeshData& mesh) {
  Eigen::Matrix3Xd points(3, static_cast<Eigen::Index>(mesh.vertices.size()));
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) points.col(static_cast<Eigen::Index>(i)) = mesh.vertices[i];
  return points;
}

class MeshScene {
 public:
  explicit MeshScene(const MeshPicture& picture) : bar_({}, palette(kGround).text), axes_({}, palette(kGround).text) {
    const Palette& colors = palette(kGround);
    const double unit = kSmoothing * picture.height / 720.0;
    body_->SetBackground(colors.background.data());
    body_->AddViewProp(surface_actor(picture.mesh, false, colors.target));
    body_->AddViewProp(surface_actor(picture.mesh, true, kBack));
    body_->AddViewProp(sharp_edges(picture.mesh, 1.2 * unit));
    // Faults and labels lie over the body: in a layer of their own.
    over_->SetLayer(1);
    over_->SetActiveCamera(body_->GetActiveCamera());
    if (!picture.open_edges.empty()) over_->AddViewProp(open_edges(picture, 3 * unit));
    if (!picture.faults.empty()) over_->AddViewProp(fault_dots(picture, 9 * unit));
    for (const SceneActor* actor : {static_cast<SceneActor*>(&bar_), static_cast<SceneActor*>(&axes_)}) {
      for (const auto& prop : actor->props()) over_->AddViewProp(prop);
    }
    for (std::size_t i = 0; i < picture.lines.size(); ++i) {
      auto& text = *texts_.emplace_back(std::make_unique<OverlayText>(colors.text, Align::left, i == 0));
      text.set_text(picture.lines[i]);
      text.place({28 * unit, kSmoothing * picture.height - (38 + 28 * static_cast<double>(i)) * unit},
                 (i == 0 ? 21 : 16) * unit);
      over_->AddViewProp(text.prop());
    }
    const FramingShare share{0.80, 0.70};
    apply_view(frame_view(CameraPreset::iso, framed_points(picture.mesh),
                          static_cast<double>(picture.width) / picture.height, share),
               *body_->GetActiveCamera());
    const View view{kSmoothing * picture.width, kSmoothing * picture.height, body_->GetActiveCamera()};
    bar_.adapt(view);
    axes_.adapt(view);
  }

  void draw(HostedRenderWindow& window) {
    window.SetNumberOfLayers(2);
    window.AddRenderer(body_);
    window.AddRenderer(over_);
    body_->ResetCameraClippingRange();
    window.Render();
  }

 private:
  vtkNew<vtkRenderer> body_, over_;
  ScaleBar bar_;
  AxesTriad axes_;
  std::vector<std::unique_ptr<OverlayText>> texts_;
};

}  // namespace

Image draw_mesh(std::shared_ptr<GlHost> host, const MeshPicture& picture) {
  const auto window =
      HostedRenderWindow::make(std::move(host), kSmoothing * picture.width, kSmoothing * picture.height);
  window->keep_where_drawn();
  MeshScene scene(picture);
  scene.draw(*window);
  DrawnFrame frame{picture.width, picture.height, kSmoothing};
  frame.rgba.resize(4 * static_cast<std::size_t>(picture.width) * picture.height * kSmoothing * kSmoothing);
  window->read_rgba(frame.rgba.data());
  return smooth_frame(frame);
}

}  // namespace netpocket
