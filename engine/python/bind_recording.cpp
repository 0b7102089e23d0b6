// Recordings, read frame by frame.

#include <memory>

#include "engine/capture/run.h"
#include "engine/python/conversions.h"
#include "engine/recording/recording.h"
#include "engine/scenario/check_scenario.h"
#include "engine/scenario/read_scenario.h"

namespace netpocket::python {
namespace {

const std::vector<double>& channel_of(const Recording& recording, const std::string& name) {
  const auto index = recording.channels()->find(name);
  if (!index) throw py::key_error(fmt::format("{} has no channel \"{}\"", recording.path(), name));
  return recording.channel(*index);
}

std::shared_ptr<Snapshot> frame_of(const Recording& recording, std::int64_t index) {
  const auto count = static_cast<std::int64_t>(recording.frame_count());
  const std::int64_t frame = index < 0 ? index + count : index;
  if (frame < 0 || frame >= count) {
    throw py::index_error(fmt::format("there is no frame {}; {} has {}", index, recording.path(), count));
  }
  return std::make_shared<Snapshot>(recording.frame(static_cast<std::size_t>(frame)));
}

// Records a run to its end time, looking at signals after each frame.
RunStatus record(const Scenario& scenario, const std::string& path, bool overwrite, int threads) {
  const Diagnostics problems = check_scenario(scenario);
  if (!problems.ok()) throw ScenarioFault{problems};
  std::stop_source stop;
  bool interrupted = false;
  RunResult result;
  {
    const py::gil_scoped_release unlocked;
    result = run_to_recording(
        scenario, path, {.threads = threads, .overwrite = overwrite, .command = "python"},
        [&](const RunProgress&) {
          const py::gil_scoped_acquire lock;
          if (!interrupted && PyErr_CheckSignals() != 0) interrupted = stop.request_stop();
        },
        stop.get_token());
  }
  if (interrupted) throw py::error_already_set();
  return result.status;
}

}  // namespace

void bind_recording(py::module_& module) {
  py::class_<Recording, std::shared_ptr<Recording>>(
      module, "Recording", "A recorded run. Channels are in memory; frames are read when they are asked for.")
      .def(py::init<const std::string&>(), py::arg("path"))
      .def_property_readonly("path", &Recording::path)
      .def_property_readonly(
          "times", [](const py::object& self) { return view_of(self.cast<const Recording&>().times(), self); },
          "(frames,), s.")
      .def_property_readonly(
          "channels",
          [](const Recording& r) { return std::vector<ChannelInfo>(r.channels()->begin(), r.channels()->end()); },
          "The channels of the file, in its order.")
      .def(
          "__getitem__",
          [](const py::object& self, const std::string& name) {
            return view_of(channel_of(self.cast<const Recording&>(), name), self);
          },
          py::arg("channel"), "(frames,), a channel by its name.")
      .def("__contains__",
           [](const Recording& r, const std::string& name) { return r.channels()->find(name).has_value(); })
      .def("__len__", &Recording::frame_count)
      .def("frame", &frame_of, py::arg("index"), "The state at a frame; negative indices count from the end.")
      .def(
          "frame_at", [](const Recording& r, double time) { return r.frame_at(time); }, py::arg("time"),
          "Index of the frame nearest to a time (s).")
      .def_property_readonly("structure", [](const Recording& r) { return std::make_shared<Structure>(r.structure()); })
      .def_property_readonly("status", [](const Recording& r) { return r.status(); })
      .def_property_readonly("statistics", [](const Recording& r) { return r.statistics(); })
      .def_property_readonly(
          "scenario",
          [](const Recording& r) {
            ScenarioResult result = read_scenario_text(r.origin().scenario_text, r.path());
            if (!result.ok()) throw ScenarioFault{result.diagnostics};
            return std::move(result.scenario);
          },
          "The scenario as it was run.")
      .def("__repr__",
           [](const Recording& r) { return fmt::format("<Recording \"{}\", {} frames>", r.path(), r.frame_count()); });
  module.def("record", &record, py::arg("scenario"), py::arg("path"), py::arg("overwrite") = false,
             py::arg("threads") = 1, "Runs a scenario to its end time into a recording.");
}

}  // namespace netpocket::python
