#include "render/output/export_vtkhdf.h"

#include <fmt/format.h>

#include <list>

#include "engine/base/folder.h"
#include "engine/base/whole_file.h"
#include "engine/state/written_time.h"
#include "render/output/run_meshes.h"
#include "render/output/vtkhdf_series.h"
#include "render/render_error.h"

namespace netpocket {
namespace {

struct PartSeries {
  explicit PartSeries(RunPart made_of) : part(made_of) {}

  RunPart part;
  VtkHdfSeries series;
};

template <typename Items>
std::vector<std::string> names_of(const Items& items) {
  std::vector<std::string> names;
  for (const auto& item : items) names.push_back(item.name);
  return names;
}

void add_names(const Structure& structure, PartSeries& made) {
  switch (made.part) {
    case RunPart::lines:
      made.series.add_texts("groups", "by the cell array group", names_of(structure.element_groups));
      made.series.add_texts("threads", "by the cell array thread", structure.threads);
      break;
    case RunPart::bodies:
      made.series.add_texts("bodies", "by the cell array body", names_of(structure.bodies));
      break;
    case RunPart::ropes:
      made.series.add_texts("ropes", "by the cell array rope", names_of(rope_groups(structure)));
      break;
  }
}

std::string file_of(RunPart part, const std::string& folder) {
  return fmt::format("{}/{}.vtkhdf", folder, run_part_name(part));
}

}  // namespace

std::vector<std::string> vtkhdf_files(const Recording& recording, const std::string& folder) {
  std::vector<std::string> files;
  for (const RunPart part : run_parts(recording.structure())) files.push_back(file_of(part, folder));
  return files;
}

RenderOutcome export_vtkhdf(const Recording& recording, const std::string& folder,
                            const RenderProgressCallback& progress, const std::stop_token& stop) {
  if (recording.frame_count() == 0) throw RenderError(fmt::format("{} has no frame to export", recording.path()));
  make_folder(folder);
  const Structure& structure = recording.structure();
  const ElementCurve curve(1);
  const ProgressMeter meter(recording.frame_count(), progress);
  std::list<PartSeries> parts;  // stay where they are
  for (const RunPart part : run_parts(structure)) parts.emplace_back(part);
  for (std::size_t frame = 0; frame < recording.frame_count(); ++frame) {
    if (stop.stop_requested()) return RenderOutcome::cancelled;
    const Snapshot snapshot = recording.frame(frame);
    const double time = written_time(snapshot.time);
    for (auto& [part, series] : parts) series.add(time, *part_mesh(part, structure, snapshot, curve));
    meter.report(frame + 1);
  }
  for (PartSeries& made : parts) {
    add_names(structure, made);
    write_whole_file(file_of(made.part, folder), FileKind::vtkhdf, made.series.bytes());
  }
  return RenderOutcome::finished;
}

}  // namespace netpocket
