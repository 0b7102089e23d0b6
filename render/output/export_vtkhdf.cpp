#include "render/output/export_vtkhdf.h"

#include <fmt/format.h>

#include "engine/base/folder.h"
#include "engine/base/whole_file.h"
#include "engine/state/written_time.h"
#include "render/output/run_meshes.h"
#include "render/output/vtkhdf_series.h"
#include "render/render_error.h"

namespace netpocket {
namespace {

void name_parts(const Structure& structure, VtkHdfSeries& lines, VtkHdfSeries& bodies) {
  std::vector<std::string> groups, names;
  for (const ElementGroup& group : structure.element_groups) groups.push_back(group.name);
  for (const StructureBody& body : structure.bodies) names.push_back(body.name);
  lines.add_texts("groups", "by the cell array group", groups);
  lines.add_texts("threads", "by the cell array thread", structure.threads);
  bodies.add_texts("bodies", "by the cell array body", names);
}

}  // namespace

std::vector<std::string> vtkhdf_files(const Recording& recording, const std::string& folder) {
  std::vector<std::string> files = {folder + "/lines.vtkhdf"};
  if (!recording.structure().bodies.empty()) files.push_back(folder + "/bodies.vtkhdf");
  return files;
}

RenderOutcome export_vtkhdf(const Recording& recording, const std::string& folder,
                            const RenderProgressCallback& progress, const std::stop_token& stop) {
  if (recording.frame_count() == 0) throw RenderError(fmt::format("{} has no frame to export", recording.path()));
  make_folder(folder);
  const Structure& structure = recording.structure();
  const ElementCurve curve(1);
  const ProgressMeter meter(recording.frame_count(), progress);
  VtkHdfSeries lines, bodies;
  for (std::size_t frame = 0; frame < recording.frame_count(); ++frame) {
    if (stop.stop_requested()) return RenderOutcome::cancelled;
    const Snapshot snapshot = recording.frame(frame);
    const double time = written_time(snapshot.time);
    lines.add(time, *line_mesh(structure, snapshot, curve));
    if (!structure.bodies.empty()) bodies.add(time, *body_meshes(structure, snapshot));
    meter.report(frame + 1);
  }
  name_parts(structure, lines, bodies);
  const auto files = vtkhdf_files(recording, folder);
  write_whole_file(files.front(), FileKind::vtkhdf, lines.bytes());
  if (files.size() > 1) write_whole_file(files.back(), FileKind::vtkhdf, bodies.bytes());
  return RenderOutcome::finished;
}

}  // namespace netpocket
