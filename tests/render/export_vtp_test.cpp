// A series for ParaView, read again with VTK's reader.

#include "render/output/export_vtp.h"

#include <gtest/gtest.h>
#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolygon.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkXMLPolyDataReader.h>

#include <Eigen/Geometry>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "engine/recording/recorder.h"
#include "engine/recording/recording.h"
#include "tests/engine/bodies/mesh_samples.h"
#include "tests/render/picture_checks.h"
#include "tests/render/synthetic_pocket.h"

namespace netpocket {
namespace {

class VtpSeries : public testing::Test {
 protected:
  VtpSeries() {
    const std::string test = testing::UnitTest::GetInstance()->current_test_info()->name();
    folder_ = pictures::folder("vtp/" + test);
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }

  // Frames at 0 to 5 s, as a sum of steps gives them; the target has tumbled.
  void record(const Shape& target, const std::vector<NodeGroup>& more = {}) const {
    auto structure = synthetic::make_structure(target);
    structure.node_groups.insert(structure.node_groups.end(), more.begin(), more.end());
    Recorder recorder(file(), {}, structure, true);
    for (int i = 0; i <= 5; ++i) {
      auto frame = synthetic::make_snapshot(structure, i - 1e-13 * i, i / 10.0);
      frame.bodies[1].attitude = Eigen::AngleAxisd(0.5 * i, Eigen::Vector3d(1, -2, 0.5).normalized());
      recorder.write(frame);
    }
    recorder.finish({RunReason::finished, 5, ""}, {});
  }

  static vtkSmartPointer<vtkPolyData> read(const std::string& path) {
    vtkNew<vtkXMLPolyDataReader> reader;
    reader->SetFileName(path.c_str());
    reader->Update();
    return reader->GetOutput();
  }

  std::string file() const { return folder_ + "/run.h5"; }

  std::string folder_;
};

TEST_F(VtpSeries, CanBeReadAgain) {
  record(Sphere{4.5});
  const Recording recording(file());
  const auto folder = folder_ + "/vtp";
  EXPECT_EQ(export_vtp(recording, folder, {3}), RenderOutcome::finished);
  const auto mesh = read(folder + "/lines_0004.vtp");
  const auto& structure = recording.structure();
  const auto elements = static_cast<vtkIdType>(structure.elements.size());
  ASSERT_EQ(mesh->GetNumberOfLines(), elements);
  ASSERT_EQ(mesh->GetNumberOfPoints(), 4 * elements);
  const auto snapshot = recording.frame(4);
  auto* tension = mesh->GetCellData()->GetArray("tension");
  auto* strain = mesh->GetCellData()->GetArray("strain");
  auto* group = mesh->GetCellData()->GetArray("group");
  auto* velocity = mesh->GetPointData()->GetArray("velocity");
  ASSERT_TRUE(tension && strain && group && velocity);
  for (vtkIdType i = 0; i < elements; i += 97) {
    EXPECT_FLOAT_EQ(tension->GetTuple1(i), static_cast<float>(snapshot.tension[i]));
    EXPECT_FLOAT_EQ(strain->GetTuple1(i), static_cast<float>(snapshot.strain[i]));
    EXPECT_EQ(static_cast<int>(group->GetTuple1(i)), structure.elements[i].group);
    const Eigen::Vector3d first = Eigen::Map<const Eigen::Vector3d>(mesh->GetPoint(4 * i));
    const Eigen::Vector3d rate = Eigen::Map<const Eigen::Vector3d>(velocity->GetTuple3(4 * i));
    EXPECT_LT((first - snapshot.positions.col(structure.elements[i].node[0])).norm(), 1e-5);
    EXPECT_LT((rate - snapshot.velocities.col(structure.elements[i].node[0])).norm(), 1e-6);
  }
  auto* names = vtkStringArray::SafeDownCast(mesh->GetFieldData()->GetAbstractArray("groups"));
  ASSERT_TRUE(names);
  ASSERT_EQ(names->GetNumberOfValues(), static_cast<vtkIdType>(structure.element_groups.size()));
  EXPECT_EQ(names->GetValue(2), "closing ropes");
  std::stringstream index;
  index << std::ifstream(folder + "/netpocket.pvd").rdbuf();
  // The frame's time, although the recording holds a sum of steps.
  EXPECT_NE(index.str().find("<DataSet timestep=\"4\" part=\"0\" file=\"lines_0004.vtp\"/>"), std::string::npos)
      << index.str();
}

TEST_F(VtpSeries, RopesRunThroughTheirNodes) {
  const std::vector<NodeGroup> ropes = {{"drawstring 1", NodeLook::rope, {7, 40, 3, 12}},
                                        {"corners", NodeLook::nothing, {1, 2, 3}},
                                        {"wound tether", NodeLook::rope, {5, 60}}};
  record(Sphere{4.5}, ropes);
  const Recording recording(file());
  const auto folder = folder_ + "/vtp";
  EXPECT_EQ(export_vtp(recording, folder), RenderOutcome::finished);
  for (const std::size_t frame : {0, 4, 5}) {
    const Snapshot snapshot = recording.frame(frame);
    const auto mesh = read(folder + "/" + vtp_file_name("ropes", frame));
    ASSERT_EQ(mesh->GetNumberOfLines(), 2);
    auto* velocity = mesh->GetPointData()->GetArray("velocity");
    ASSERT_TRUE(velocity);
    for (const auto& [cell, group] : {std::pair{0, 0}, {1, 2}}) {
      const auto& nodes = ropes[static_cast<std::size_t>(group)].nodes;
      auto* points = mesh->GetCell(cell)->GetPointIds();
      ASSERT_EQ(points->GetNumberOfIds(), static_cast<vtkIdType>(nodes.size()));
      EXPECT_EQ(mesh->GetCellData()->GetArray("rope")->GetTuple1(cell), cell);
      for (vtkIdType i = 0; i < points->GetNumberOfIds(); ++i) {
        const Eigen::Vector3d place = Eigen::Map<const Eigen::Vector3d>(mesh->GetPoint(points->GetId(i)));
        const Eigen::Vector3d rate = Eigen::Map<const Eigen::Vector3d>(velocity->GetTuple3(points->GetId(i)));
        EXPECT_LT((place - snapshot.positions.col(nodes[static_cast<std::size_t>(i)])).norm(), 1e-5);
        EXPECT_LT((rate - snapshot.velocities.col(nodes[static_cast<std::size_t>(i)])).norm(), 1e-6);
      }
    }
    auto* names = vtkStringArray::SafeDownCast(mesh->GetFieldData()->GetAbstractArray("ropes"));
    ASSERT_TRUE(names);
    ASSERT_EQ(names->GetNumberOfValues(), 2);
    EXPECT_EQ(names->GetValue(1), "wound tether");
  }
  std::stringstream index;
  index << std::ifstream(folder + "/netpocket.pvd").rdbuf();
  EXPECT_NE(index.str().find("<DataSet timestep=\"4\" part=\"2\" file=\"ropes_0004.vtp\"/>"), std::string::npos)
      << index.str();
}

TEST_F(VtpSeries, RunsWithoutSuchRopesHaveNoFilesOfThem) {
  record(Sphere{4.5});
  export_vtp(Recording(file()), folder_ + "/vtp");
  EXPECT_TRUE(std::filesystem::exists(folder_ + "/vtp/bodies_0000.vtp"));
  EXPECT_FALSE(std::filesystem::exists(folder_ + "/vtp/ropes_0000.vtp"));
}

Eigen::Vector3d vector_of(const double* values) { return {values[0], values[1], values[2]}; }

// Least cosine between a polygon's own normal and those at its corners.
double least_agreement(vtkPolyData& mesh) {
  auto* normals = mesh.GetPointData()->GetNormals();
  double least = 1;
  for (vtkIdType cell = 0; cell < mesh.GetNumberOfCells(); ++cell) {
    auto* polygon = mesh.GetCell(cell);
    double normal[3] = {};
    vtkPolygon::ComputeNormal(polygon->GetPoints(), normal);
    for (vtkIdType i = 0; i < polygon->GetNumberOfPoints(); ++i) {
      const Eigen::Vector3d at_corner = vector_of(normals->GetTuple3(polygon->GetPointId(i)));
      EXPECT_NEAR(at_corner.norm(), 1, 1e-5);
      least = std::min(least, at_corner.dot(vector_of(normal)));
    }
  }
  return least;
}

TEST_F(VtpSeries, NormalsTurnWithTheBodies) {
  const MeshShape wedge{samples::checked_mesh(samples::wedge())};
  const Satellite satellite({.bus = {2, 2.4, 1.8}, .span = 8.4, .panel_width = 1.7, .dish_diameter = 1.6});
  for (const Shape& shape :
       {Shape(Sphere{4.5}), Shape(Box{{1, 2, 3}}), Shape(Cylinder{1.2, 4}), Shape(satellite), Shape(wedge)}) {
    SCOPED_TRACE(shape.index());
    record(shape);
    const auto folder = folder_ + "/vtp" + std::to_string(shape.index());
    export_vtp(Recording(file()), folder);
    const auto mesh = read(folder + "/bodies_0004.vtp");
    ASSERT_GT(mesh->GetNumberOfPolys(), 0);
    auto* normals = mesh->GetPointData()->GetNormals();
    ASSERT_TRUE(normals);
    EXPECT_STREQ(normals->GetName(), "Normals");
    EXPECT_EQ(mesh->GetPointData()->GetNumberOfArrays(), 1);
    EXPECT_FALSE(mesh->GetPointData()->GetScalars());
    EXPECT_TRUE(mesh->GetCellData()->GetArray("body"));
    EXPECT_GT(least_agreement(*mesh), 0.98);
  }
}

}  // namespace
}  // namespace netpocket
