#include "render/output/export_vtp.h"

#include <fmt/format.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataWriter.h>

#include "engine/base/folder.h"
#include "engine/base/whole_file.h"
#include "engine/state/written_time.h"
#include "render/output/run_meshes.h"
#include "render/render_error.h"

namespace netpocket {
namespace {

void write_vtp(vtkPolyData* mesh, const std::string& path) {
  // Into memory: VTK tells of a full disk in words of its own and goes on.
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->WriteToOutputStringOn();
  writer->SetInputData(mesh);
  if (!writer->Write()) throw RenderError(fmt::format("cannot encode \"{}\"", path));
  write_whole_file(path, FileKind::vtp, writer->GetOutputString());
}

}  // namespace

std::string vtp_file_name(const std::string& part, std::size_t frame) {
  return fmt::format("{}_{:04}.vtp", part, frame);
}

RenderOutcome export_vtp(const Recording& recording, const std::string& folder, const VtpOptions& options,
                         const RenderProgressCallback& progress, const std::stop_token& stop) {
  if (options.segments < 1) throw RenderError("an element needs at least one segment");
  make_folder(folder);
  const auto& structure = recording.structure();
  const ElementCurve curve(options.segments);
  const ProgressMeter meter(recording.frame_count(), progress);
  const std::vector<RunPart> parts = run_parts(structure);
  std::string entries;
  std::size_t frame = 0;
  for (; frame < recording.frame_count() && !stop.stop_requested(); ++frame) {
    const auto snapshot = recording.frame(frame);
    const double time = written_time(snapshot.time);
    for (const RunPart part : parts) {
      const std::string file = vtp_file_name(run_part_name(part), frame);
      write_vtp(part_mesh(part, structure, snapshot, curve), folder + "/" + file);
      entries +=
          fmt::format("    <DataSet timestep=\"{}\" part=\"{}\" file=\"{}\"/>\n", time, static_cast<int>(part), file);
    }
    meter.report(frame + 1);
  }
  write_whole_file(folder + "/netpocket.pvd", FileKind::pvd,
                   fmt::format("<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n"
                               "  <Collection>\n{}  </Collection>\n</VTKFile>\n",
                               entries));
  return frame == recording.frame_count() ? RenderOutcome::finished : RenderOutcome::cancelled;
}

}  // namespace netpocket
