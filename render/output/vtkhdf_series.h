#pragma once
// A VTK mesh that moves, as a VTKHDF file with time steps. Layout: "VTKHDF File Format", version 2.0, PolyData with the
// group Steps (docs.vtk.org). Read by VTK from 9.3 and ParaView from 5.12 on.
// Thread contract: one thread at a time per object.

#include <vtkPolyData.h>

#include <memory>
#include <string>
#include <vector>

namespace netpocket {

class VtkHdfSeries {
 public:
  VtkHdfSeries();
  ~VtkHdfSeries();
  VtkHdfSeries(const VtkHdfSeries&) = delete;
  VtkHdfSeries& operator=(const VtkHdfSeries&) = delete;

  // Adds a step, in the order of their times (s). The cells (lines and polygons) are those of the first mesh; every
  // mesh must have as many points and the same arrays of points and cells (float or int). Points and arrays that are
  // the same as in the step before take no room. Throws RenderError.
  void add(double time, vtkPolyData& mesh);

  // Texts beside the mesh, which VTK does not read: the table `name` of the group "netpocket", e.g. the names of
  // groups.
  void add_texts(const char* name, const char* help, const std::vector<std::string>& texts);

  // The file, once all steps are added. Throws RenderError.
  std::string bytes();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace netpocket
