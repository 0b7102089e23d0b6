#include "render/output/vtkhdf_series.h"

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>

#include <array>
#include <cstring>
#include <optional>
#include <span>

#include "engine/recording/hdf5_output.h"
#include "render/render_error.h"

namespace netpocket {
namespace {

constexpr std::size_t kStepsPerChunk = 256;
// In the order of the columns of Steps/CellOffsets.
constexpr std::array kTopologies = {"Vertices", "Lines", "Polygons", "Strips"};

// In memory: HDF5 cannot be told of a full disk in the midst of a file, whole_file can. HDF5 tells files in memory
// apart by their names, so each is named after its owner.
Handle create_file(const void* owner) {
  constexpr std::size_t kGrowth = 1 << 24;  // bytes
  const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "describe a file");
  checked(H5Pset_fapl_core(access.get(), kGrowth, 0), "keep a file in memory");
  return Handle(H5Fcreate(fmt::format("vtkhdf {}", owner).c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access.get()), H5Fclose,
                "create a file");
}

Handle attribute_of(hid_t object, const char* name, hid_t type, hid_t space) {
  return Handle(H5Acreate2(object, name, type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose, "create an attribute");
}

// Text of VTK is ASCII of a fixed length.
void write_type(hid_t group, const std::string& text) {
  const Handle type(H5Tcopy(H5T_C_S1), H5Tclose, "describe a text"), space(H5Screate(H5S_SCALAR), H5Sclose, "a scalar");
  checked(H5Tset_size(type.get(), text.size()), "describe a text");
  checked(H5Tset_strpad(type.get(), H5T_STR_NULLPAD), "describe a text");
  const Handle attribute = attribute_of(group, "Type", type.get(), space.get());
  checked(H5Awrite(attribute.get(), type.get(), text.data()), "write an attribute");
}

void write_version(hid_t group) {
  constexpr std::array<std::int64_t, 2> kVersion = {2, 0};
  const hsize_t size = kVersion.size();
  const Handle space(H5Screate_simple(1, &size, nullptr), H5Sclose, "a list");
  const Handle attribute = attribute_of(group, "Version", H5T_NATIVE_INT64, space.get());
  checked(H5Awrite(attribute.get(), H5T_NATIVE_INT64, kVersion.data()), "write an attribute");
}

std::vector<std::int64_t> ids_of(vtkDataArray* array) {
  std::vector<std::int64_t> ids(static_cast<std::size_t>(array->GetNumberOfTuples()));
  for (std::size_t i = 0; i < ids.size(); ++i) {
    ids[i] = static_cast<std::int64_t>(array->GetComponent(static_cast<vtkIdType>(i), 0));
  }
  return ids;
}

}  // namespace

// A table with a block of rows for each step that differs from the one before it.
class VtkHdfArray {
 public:
  VtkHdfArray(hid_t group, const std::string& name, vtkDataArray& first, ChunkCodec& codec)
      : name_(name), components_(static_cast<std::size_t>(first.GetNumberOfComponents())), type_(type_of(first)) {
    std::vector<hsize_t> shape;
    if (components_ > 1) shape = {components_};
    rows_ = first.GetNumberOfTuples();
    table_.emplace(group, type_, TableLayout{name_.c_str(), "", "", shape, std::max<hsize_t>(1, rows())}, codec);
  }

  // The row at which the step begins.
  std::int64_t add(vtkDataArray* array) {
    if (!array || array->GetNumberOfTuples() != rows_ || type_of(*array) != type_) {
      throw RenderError(fmt::format("the meshes of a series differ in \"{}\"", name_));
    }
    const auto* bytes = static_cast<const std::uint8_t*>(array->GetVoidPointer(0));
    const std::span<const std::uint8_t> values(bytes, rows() * components_ * H5Tget_size(type_));
    if (offset_ < 0 || !std::ranges::equal(values, last_)) {
      offset_ = static_cast<std::int64_t>(table_->row_count());
      table_->append(values);
      table_->store();
      last_.assign(values.begin(), values.end());
    }
    return offset_;
  }

  const std::string& name() const { return name_; }

 private:
  static hid_t type_of(vtkDataArray& array) {
    if (array.GetDataType() == VTK_FLOAT) return H5T_NATIVE_FLOAT;
    if (array.GetDataType() == VTK_INT) return H5T_NATIVE_INT32;
    throw RenderError("a series has arrays of float and int only");
  }
  hsize_t rows() const { return static_cast<hsize_t>(rows_); }

  std::string name_;
  std::size_t components_;
  hid_t type_;
  vtkIdType rows_ = 0;
  std::int64_t offset_ = -1;
  std::optional<OutputTable> table_;
  std::vector<std::uint8_t> last_;
};

// An array with the row at which each step begins.
struct SteppedVtkHdfArray {
  VtkHdfArray values;
  OutputTable offsets;

  void add(vtkDataArray* array) {
    const std::int64_t offset = values.add(array);
    offsets.append(std::span<const std::int64_t>(&offset, 1));
  }
};

struct VtkHdfSeries::Impl {
  // Members in the order in which they are made; the file is closed last.
  ChunkCodec codec;
  Handle file = create_file(this);
  Handle root = create_group(file.get(), "VTKHDF"), steps = create_group(root.get(), "Steps");
  std::vector<Handle> groups;
  std::vector<std::unique_ptr<SteppedVtkHdfArray>> point_data, cell_data;
  std::unique_ptr<SteppedVtkHdfArray> points;
  OutputTable values = step_table(H5T_NATIVE_DOUBLE, "Values", {}), parts = step_table("PartOffsets"),
              part_counts = step_table("NumberOfParts"), cells = step_table("CellOffsets", kTopologies.size()),
              connectivity = step_table("ConnectivityIdOffsets", kTopologies.size());
  std::int64_t step_count = 0;

  Impl() {
    write_version(root.get());
    write_type(root.get(), "PolyData");
  }

  OutputTable table_in(hid_t group, hid_t type, const std::string& name, const std::vector<hsize_t>& shape) {
    return {group, type, TableLayout{name.c_str(), "", "", shape, kStepsPerChunk}, codec};
  }
  OutputTable step_table(hid_t type, const char* name, const std::vector<hsize_t>& shape) {
    return table_in(steps.get(), type, name, shape);
  }
  OutputTable step_table(const char* name, std::optional<hsize_t> columns = {}) {
    return step_table(H5T_NATIVE_INT64, name, columns ? std::vector<hsize_t>{*columns} : std::vector<hsize_t>());
  }

  void write_ids(hid_t group, const char* name, const std::vector<std::int64_t>& ids) {
    write_array(group, TableLayout{name, "", "", {}, 1}, ids, codec);
  }

  // One part, whose cells hold for every step: all their offsets are 0.
  void write_cells(const char* name, vtkCellArray* array) {
    const Handle group = create_group(root.get(), name);
    const bool some = array && array->GetNumberOfCells() > 0;
    const auto connected = some ? ids_of(array->GetConnectivityArray()) : std::vector<std::int64_t>();
    write_ids(group.get(), "NumberOfCells", {some ? array->GetNumberOfCells() : 0});
    write_ids(group.get(), "NumberOfConnectivityIds", {static_cast<std::int64_t>(connected.size())});
    write_ids(group.get(), "Connectivity", connected);
    write_ids(group.get(), "Offsets", some ? ids_of(array->GetOffsetsArray()) : std::vector<std::int64_t>{0});
  }

  hid_t keep_group(hid_t parent, const char* name) {
    groups.push_back(create_group(parent, name));
    return groups.back().get();
  }

  void add_arrays(vtkFieldData& data, const char* group_name, const char* offsets_name,
                  std::vector<std::unique_ptr<SteppedVtkHdfArray>>& arrays) {
    const hid_t group = keep_group(root.get(), group_name), offsets = keep_group(steps.get(), offsets_name);
    for (int i = 0; i < data.GetNumberOfArrays(); ++i) {
      auto* array = data.GetArray(i);
      const std::string name = array->GetName();
      arrays.push_back(std::make_unique<SteppedVtkHdfArray>(
          SteppedVtkHdfArray{VtkHdfArray(group, name, *array, codec), table_in(offsets, H5T_NATIVE_INT64, name, {})}));
    }
  }

  void begin(vtkPolyData& mesh) {
    write_ids(root.get(), "NumberOfPoints", {mesh.GetNumberOfPoints()});
    write_cells("Vertices", nullptr);
    write_cells("Lines", mesh.GetLines());
    write_cells("Polygons", mesh.GetPolys());
    write_cells("Strips", nullptr);
    points = std::make_unique<SteppedVtkHdfArray>(SteppedVtkHdfArray{
        VtkHdfArray(root.get(), "Points", *mesh.GetPoints()->GetData(), codec), step_table("PointOffsets")});
    add_arrays(*mesh.GetPointData(), "PointData", "PointDataOffsets", point_data);
    add_arrays(*mesh.GetCellData(), "CellData", "CellDataOffsets", cell_data);
    keep_group(root.get(), "FieldData");
  }

  void add(double time, vtkPolyData& mesh) {
    constexpr std::array<std::int64_t, kTopologies.size()> kStart{};
    constexpr std::int64_t kFirst = 0, kOne = 1;
    if (step_count == 0) begin(mesh);
    points->add(mesh.GetPoints()->GetData());
    for (const auto& array : point_data) array->add(mesh.GetPointData()->GetArray(array->values.name().c_str()));
    for (const auto& array : cell_data) array->add(mesh.GetCellData()->GetArray(array->values.name().c_str()));
    values.append(std::span<const double>(&time, 1));
    parts.append(std::span(&kFirst, 1));
    part_counts.append(std::span(&kOne, 1));
    cells.append(std::span<const std::int64_t>(kStart));
    connectivity.append(std::span<const std::int64_t>(kStart));
    ++step_count;
  }

  void finish() {
    for (OutputTable* table : {&values, &parts, &part_counts, &cells, &connectivity}) table->store();
    if (points) points->offsets.store();
    for (const auto& array : point_data) array->offsets.store();
    for (const auto& array : cell_data) array->offsets.store();
    write_attribute(steps.get(), "NSteps", step_count);
    checked(H5Fflush(file.get(), H5F_SCOPE_LOCAL), "complete the file");
  }
};

namespace {

template <typename Function>
auto as_render_error(const Function& function) {
  try {
    return function();
  } catch (const Hdf5Error& error) {
    throw RenderError(fmt::format("cannot encode VTKHDF: {}", error.what()));
  }
}

}  // namespace

VtkHdfSeries::VtkHdfSeries() : impl_(as_render_error([] { return std::make_unique<Impl>(); })) {}

VtkHdfSeries::~VtkHdfSeries() = default;

void VtkHdfSeries::add(double time, vtkPolyData& mesh) {
  as_render_error([&] { impl_->add(time, mesh); });
}

void VtkHdfSeries::add_texts(const char* name, const char* help, const std::vector<std::string>& texts) {
  as_render_error([&] {
    const bool exists = H5Lexists(impl_->file.get(), "netpocket", H5P_DEFAULT) > 0;
    const Handle group = exists
                             ? Handle(H5Gopen2(impl_->file.get(), "netpocket", H5P_DEFAULT), H5Gclose, "open a group")
                             : create_group(impl_->file.get(), "netpocket");
    write_texts(group.get(), TableLayout{name, "", help, {}, 1}, texts, impl_->codec);
  });
}

std::string VtkHdfSeries::bytes() {
  return as_render_error([&] {
    impl_->finish();
    const ssize_t size = checked(H5Fget_file_image(impl_->file.get(), nullptr, 0), "measure the file");
    std::string image(static_cast<std::size_t>(size), '\0');
    checked(H5Fget_file_image(impl_->file.get(), image.data(), image.size()), "take the file");
    return image;
  });
}

}  // namespace netpocket
