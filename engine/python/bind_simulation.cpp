// Simulations and controllers.

#include <thread>

#include "engine/python/conversions.h"
#include "engine/python/memory_run.h"
#include "engine/python/python_simulation.h"

namespace netpocket::python {
namespace {

void set_force(PythonCommands::Body& body, const Eigen::Vector3d& force, const Eigen::Vector3d& torque,
               const Eigen::Vector3d& point) {
  if (!force.allFinite() || !torque.allFinite() || !point.allFinite()) {
    throw py::value_error("forces, torques and their points must be finite");
  }
  body = {force, torque, point};
}

void set_winding(PythonCommands& commands, std::optional<std::int64_t> rope, double rate, double acceleration) {
  if (!std::isfinite(rate) || !(acceleration > 0)) {
    throw py::value_error("a rope needs a finite rate and a positive acceleration");
  }
  const std::size_t count = commands.ropes.size();
  const std::size_t first = rope ? static_cast<std::size_t>(checked_index(*rope, count, "rope")) : 0;
  const std::size_t last = rope ? first + 1 : count;
  for (std::size_t i = first; i < last; ++i) commands.ropes[i] = {true, rate, acceleration};
}

void bind_control(py::module_& module) {
  py::class_<PythonMeasurements>(module, "Measurements",
                                 "What a controller sees at the beginning of a step. Valid during its call.")
      .def_property_readonly(
          "time", [](const PythonMeasurements& m) { return m.get().time(); }, "s.")
      .def(
          "body", [](const PythonMeasurements& m, std::int32_t body) { return m.get().body(body); }, py::arg("body"),
          "Motion of a body by itself, by its index in Structure.bodies.")
      .def(
          "rope_length", [](const PythonMeasurements& m, std::int32_t rope) { return m.get().rope(rope).length; },
          py::arg("rope"), "m, of a wound rope.")
      .def(
          "rope_rate", [](const PythonMeasurements& m, std::int32_t rope) { return m.get().rope(rope).rate; },
          py::arg("rope"), "m/s, negative while it is wound in.");
  py::class_<PythonCommands>(module, "Commands", "What a controller asks for. Held until it is changed.")
      .def(
          "force",
          [](PythonCommands& c, std::int64_t body, const Eigen::Vector3d& force, const Eigen::Vector3d& torque,
             const Eigen::Vector3d& point) {
            set_force(c.bodies[static_cast<std::size_t>(checked_index(body, c.bodies.size(), "body"))], force, torque,
                      point);
          },
          py::arg("body"), py::arg("force") = kZeroVector, py::arg("torque") = kZeroVector,
          py::arg("point") = kZeroVector,
          "Force (N) and torque (N m) on a body, world axes. The force acts at `point` (m, body axes).")
      .def("wind", &set_winding, py::arg("rope"), py::arg("rate"), py::arg("acceleration") = 1.0,
           "Winds a rope, or all (None), at a rate (m/s, negative winds in) that it reaches with an acceleration "
           "(m/s^2).");
}

py::array_t<double> to_array(const std::vector<double>& numbers) {
  return py::array_t<double>(static_cast<py::ssize_t>(numbers.size()), numbers.data());
}

void bind_runs(py::module_& module) {
  py::class_<PythonSimulation>(module, "Simulation",
                               "Steps a capture. Owns the complete state of the run. One thread at a time.")
      .def(py::init<const Scenario&, int>(), py::arg("scenario"), py::arg("threads") = 1,
           "Raises ScenarioError unless the scenario can be simulated.")
      .def_property_readonly("time", &PythonSimulation::time, "s.")
      .def_property_readonly(
          "scenario", [](const PythonSimulation& s) { return s.scenario(); },
          "A copy of the scenario, with the strategy now in force.")
      .def("advance", &PythonSimulation::advance, py::arg("until"),
           "Steps to a time (s) without the interpreter lock. Raises DivergedError; the state is then the last sound "
           "one. Ctrl-C stops it at a whole step.")
      .def("step", &PythonSimulation::step, py::arg("count") = 1, "Makes a number of steps.")
      .def("snapshot", &PythonSimulation::snapshot,
           "The present state. Channels that are means count from the last call.")
      .def_property_readonly("structure", &PythonSimulation::structure)
      .def_property_readonly("statistics", &PythonSimulation::statistics)
      .def(
          "checkpoint", [](PythonSimulation& s) { return to_array(s.checkpoint()); },
          "The complete state as numbers. A simulation of the same scenario continues from it to the last bit.")
      .def(
          "restore",
          [](PythonSimulation& s, const py::array_t<double, py::array::c_style | py::array::forcecast>& state) {
            s.restore({state.data(), static_cast<std::size_t>(state.size())});
          },
          py::arg("state"), "Sets the state. Raises ValueError if it is that of another scenario.")
      .def("change_strategy", &PythonSimulation::change_strategy, py::arg("scenario"),
           "Adopts the strategy of another scenario without a jump. Returns the keys that need a new simulation.")
      .def(
          "add_controller", &PythonSimulation::add_controller, py::arg("controller"), py::arg("rate") = 100.0,
          "Adds a function of (measurements, interval, commands), or an object with such a method `update`, that is "
          "called `rate` times a simulated second (0: before every step). An array `state` of float64 of the object is "
          "saved and restored with the run.")
      .def(
          "set_force",
          [](PythonSimulation& s, const py::object& body, const Eigen::Vector3d& force, const Eigen::Vector3d& torque,
             const Eigen::Vector3d& point) {
            const auto index = static_cast<std::size_t>(s.body_index(body));
            set_force(s.held().bodies[index], force, torque, point);
          },
          py::arg("body"), py::arg("force") = kZeroVector, py::arg("torque") = kZeroVector,
          py::arg("point") = kZeroVector,
          "Force (N) and torque (N m) on a body (name or index) from now on, world axes.")
      .def(
          "wind",
          [](PythonSimulation& s, std::optional<std::int64_t> rope, double rate, double acceleration) {
            set_winding(s.held(), rope, rate, acceleration);
          },
          py::arg("rope"), py::arg("rate"), py::arg("acceleration") = 1.0,
          "Winds a rope, or all (None), from now on, at a rate (m/s, negative winds in).")
      .def("__repr__", [](PythonSimulation& s) {
        return fmt::format("<Simulation of \"{}\", t = {:.6g} s>", s.scenario().name, s.time());
      });
  module.def("advance_all", &advance_all, py::arg("simulations"), py::arg("until"), py::arg("threads") = 1,
             "Advances many simulations side by side, each to its time (s), without the interpreter lock.");
}

}  // namespace

void bind_simulation(py::module_& module) {
  bind_control(module);
  bind_runs(module);
  py::class_<MemoryRun>(module, "MemoryRun", "A run whose channels were kept in memory.")
      .def_readonly("status", &MemoryRun::status)
      .def_readonly("statistics", &MemoryRun::statistics)
      .def_property_readonly(
          "channels",
          [](const py::object& self) {
            const auto& run = self.cast<const MemoryRun&>();
            py::dict channels;
            for (std::size_t i = 0; i < run.values.size(); ++i) {
              channels[py::str((*run.channels)[i].name)] = view_of(run.values[i], self);
            }
            return channels;
          },
          "Array by frame of each channel, by name.");
  module.def("run_in_memory", &run_in_memory, py::arg("scenarios"), py::arg("jobs"),
             "Runs scenarios side by side to their end times. Ctrl-C stops them.");
}

}  // namespace netpocket::python
