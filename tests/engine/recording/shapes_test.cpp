// Satellites and meshes in recordings: all that drawing needs, each mesh once, nothing believed unchecked.
#include <gtest/gtest.h>
#include <hdf5.h>

#include <functional>

#include "engine/recording/recording.h"
#include "tests/engine/bodies/mesh_samples.h"
#include "tests/engine/recording/synthetic_run.h"

namespace netpocket {
namespace {

const Satellite::Dimensions kDimensions = {.bus = {2, 2.4, 1.8}, .span = 8.4, .panel_width = 1.7, .dish_diameter = 1.6};

Structure structure_with_shapes() {
  Structure structure = synthetic_structure(20);
  const MeshShape torus{samples::checked_mesh(samples::torus(3, 1, 12, 8))};
  const MeshShape wedge{samples::checked_mesh(samples::wedge())};
  structure.bodies = {{"spacecraft", BodyRole::spacecraft, Box{{1.6, 2.0, 1.6}}, 1210},
                      {"target", BodyRole::target, Satellite(kDimensions), 200},
                      {"ring", BodyRole::other, torus, 3},
                      {"shard", BodyRole::other, wedge, 1},
                      {"second ring", BodyRole::other, torus, 3}};
  return structure;
}

void record(const std::string& path, const Structure& structure) {
  Recorder recorder(path, synthetic_origin(), structure, true);
  recorder.write(synthetic_frame(structure, 0));
  recorder.finish({RunReason::finished, 0, ""}, {});
}

const TriangleMesh& mesh_of(const StructureBody& body) { return *std::get<MeshShape>(body.shape).mesh; }

TEST(RecordedShapes, ComeBackWhole) {
  const TemporaryFolder folder;
  const Structure expected = structure_with_shapes();
  record(folder.file("run.h5"), expected);
  const Recording recording(folder.file("run.h5"));
  const auto& bodies = recording.structure().bodies;
  ASSERT_EQ(bodies.size(), expected.bodies.size());
  EXPECT_EQ(std::get<Satellite>(bodies[1].shape).dimensions(), kDimensions);
  for (const std::size_t i : {2, 3, 4}) {
    const TriangleMesh &found = mesh_of(bodies[i]), &written = mesh_of(expected.bodies[i]);
    EXPECT_EQ(found.triangles(), written.triangles());
    ASSERT_EQ(found.vertices().size(), written.vertices().size());
    EXPECT_EQ(found.vertices(), written.vertices());
    EXPECT_EQ(found.volume(), written.volume());
    EXPECT_EQ(found.unit_inertia(), written.unit_inertia());
    EXPECT_EQ(found.bounding_radius(), written.bounding_radius());
  }
  // Bodies that shared a mesh share it again.
  EXPECT_EQ(&mesh_of(bodies[2]), &mesh_of(bodies[4]));
  EXPECT_NE(&mesh_of(bodies[2]), &mesh_of(bodies[3]));
}

hsize_t rows(hid_t file, const char* path) {
  const hid_t dataset = H5Dopen2(file, path, H5P_DEFAULT), space = H5Dget_space(dataset);
  hsize_t size[2] = {};
  H5Sget_simple_extent_dims(space, size, nullptr);
  H5Sclose(space);
  H5Dclose(dataset);
  return size[0];
}

TEST(RecordedShapes, EachMeshIsStoredOnce) {
  const TemporaryFolder folder;
  record(folder.file("run.h5"), structure_with_shapes());
  const hid_t file = H5Fopen(folder.file("run.h5").c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  EXPECT_EQ(rows(file, "/structure/mesh_size"), 2u);
  EXPECT_EQ(rows(file, "/structure/mesh_triangles"), 2u * 12 * 8 + 4);
  EXPECT_EQ(rows(file, "/structure/mesh_vertices"), 12u * 8 + 4);
  H5Fclose(file);
}

// A file from before these shapes.
TEST(RecordedShapes, OlderFilesAreRead) {
  const TemporaryFolder folder;
  const std::string path = folder.file("run.h5");
  write_synthetic_run(path, 2);
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  H5Ldelete(file, "/structure/body_detail", H5P_DEFAULT);
  H5Ldelete(file, "/structure/body_mesh", H5P_DEFAULT);
  H5Fclose(file);
  EXPECT_EQ(std::get<Sphere>(Recording(path).structure().bodies[1].shape).radius, 4.5);
}

template <typename T>
void set_number(hid_t file, const char* path, hid_t type, std::size_t index, T value) {
  const hid_t dataset = H5Dopen2(file, path, H5P_DEFAULT), space = H5Dget_space(dataset);
  std::vector<T> values(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
  H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
  values[index] = value;
  H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
  H5Sclose(space);
  H5Dclose(dataset);
}

std::string refusal(const std::function<void(hid_t)>& change) {
  const TemporaryFolder folder;
  const std::string path = folder.file("run.h5");
  record(path, structure_with_shapes());
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  change(file);
  H5Fclose(file);
  try {
    const Recording recording(path);
  } catch (const RecordingError& error) {
    return std::string(error.what()).substr(("Cannot read \"" + path + "\": ").size());
  }
  return "";
}

TEST(RecordedShapes, TamperedOnesAreRefused) {
  const auto integer = [](const char* path, std::size_t index, std::int32_t value) {
    return refusal([=](hid_t file) { set_number(file, path, H5T_NATIVE_INT32, index, value); });
  };
  const auto number = [](const char* path, std::size_t index, double value) {
    return refusal([=](hid_t file) { set_number(file, path, H5T_NATIVE_DOUBLE, index, value); });
  };
  EXPECT_EQ(integer("/structure/body_mesh", 2, 2), "a body names a mesh that does not exist");
  EXPECT_EQ(integer("/structure/body_mesh", 2, -1), "a body names a mesh that does not exist");
  EXPECT_EQ(integer("/structure/mesh_size", 0, 2147483647), "a mesh is larger than what is stored of it");
  EXPECT_EQ(integer("/structure/mesh_size", 3, -1), "a mesh is larger than what is stored of it");
  EXPECT_EQ(integer("/structure/mesh_triangles", 0, 100000), "a mesh has a triangle with a corner that does not exist");
  EXPECT_TRUE(integer("/structure/mesh_triangles", 0, 50).starts_with("a mesh is not watertight"));
  EXPECT_EQ(number("/structure/mesh_vertices", 4, NAN), "a mesh has a corner whose coordinates are not finite numbers");
  EXPECT_EQ(number("/structure/body_detail", 3, 1.9), "a body has an impossible size or mass");  // span below the bus
  EXPECT_EQ(number("/structure/body_detail", 4, NAN), "a body has an impossible size or mass");
}

}  // namespace
}  // namespace netpocket
