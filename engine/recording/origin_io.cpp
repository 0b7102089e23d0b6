#include "engine/recording/origin_io.h"

#include <cmath>

namespace netpocket {
namespace {

constexpr char kDraft[] = "draft";  // an attribute of drafts only

std::string read_text(const InputFile& file, const std::string& path) {
  const auto texts = read_texts(file, path);
  if (texts.size() != 1) throw Hdf5Error(path + " has the wrong length");
  return texts[0];
}

void write_phases(hid_t file, const std::vector<Phase>& phases, ChunkCodec& codec) {
  std::vector<std::string> names;
  std::vector<double> times;
  std::vector<std::uint8_t> rests;
  for (const Phase& phase : phases) {
    names.push_back(phase.name);
    times.insert(times.end(), {phase.begin, phase.end});
    rests.push_back(phase.at_rest ? 1 : 0);
  }
  write_texts(file, {"phase_names", "", "phases of the capture"}, names, codec);
  write_array(file, {"phase_times", "s", "begin and end of each phase, infinite: until the end", {2}}, times, codec);
  write_array(file, {"phase_at_rest", "", "1: nothing is done in the phase"}, rests, codec);
}

std::vector<Phase> read_phases(const InputFile& file) {
  if (!file.has("/phase_names")) {
    // Files of version 0.1 hold two times of a pocket.
    return pocket_phases(0, file.read_number_attribute("/", "closing_end"),
                         file.read_number_attribute("/", "towing_start"));
  }
  const auto names = read_texts(file, "/phase_names");
  const auto times = read_array<double>(file, "/phase_times", {2});
  const auto rests = read_array<std::uint8_t>(file, "/phase_at_rest", {});
  if (times.size() != 2 * names.size()) throw Hdf5Error("/phase_times has the wrong length");
  if (rests.size() != names.size()) throw Hdf5Error("/phase_at_rest has the wrong length");
  std::vector<Phase> phases;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (!std::isfinite(times[2 * i]) || std::isnan(times[2 * i + 1])) {
      throw Hdf5Error("/phase_times holds a time that is not a number");
    }
    phases.push_back({names[i], times[2 * i], times[2 * i + 1], rests[i] != 0});
  }
  return phases;
}

}  // namespace

void write_origin(hid_t file, const RunOrigin& origin, ChunkCodec& codec) {
  write_attribute(file, "netpocket_version", origin.netpocket_version);
  write_attribute(file, "commit", origin.commit);
  write_attribute(file, "seed", std::int64_t{origin.seed});
  write_attribute(file, "threads", std::int64_t{origin.threads});
  write_texts(file, {"scenario_name", "", "name of the scenario"}, {origin.scenario_name}, codec);
  write_texts(file, {"scenario", "", "the scenario as run, TOML"}, {origin.scenario_text}, codec);
  write_texts(file, {"command", "", "command line, or workbench"}, {origin.command}, codec);
  write_phases(file, origin.phases, codec);
  if (!origin.draft.empty()) write_attribute(file, kDraft, origin.draft);
}

RunOrigin read_origin(const InputFile& file) {
  RunOrigin origin;
  origin.scenario_name = read_text(file, "/scenario_name");
  origin.scenario_text = read_text(file, "/scenario");
  origin.command = read_text(file, "/command");
  origin.netpocket_version = file.read_text_attribute("/", "netpocket_version");
  origin.commit = file.read_text_attribute("/", "commit");
  origin.seed = file.read_count_attribute("/", "seed");
  origin.threads = file.read_count_attribute("/", "threads");
  origin.phases = read_phases(file);
  if (file.has_attribute("/", kDraft)) origin.draft = file.read_text_attribute("/", kDraft);
  return origin;
}

}  // namespace netpocket
