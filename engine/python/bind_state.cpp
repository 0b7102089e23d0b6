// What a run shows of itself: structure, snapshots, channels, how it ended.

#include <memory>

#include "engine/python/conversions.h"
#include "engine/state/snapshot.h"
#include "engine/state/structure.h"

namespace netpocket::python {
namespace {

py::array_t<double> columns(const py::object& owner, const Eigen::Matrix3Xd& matrix) {
  return view_of_rows(matrix.data(), matrix.cols(), 3, owner);
}

py::dict channels_of(const Snapshot& snapshot) {
  py::dict values;
  for (std::size_t i = 0; i < snapshot.channels.size(); ++i) {
    values[py::str((*snapshot.channel_list)[i].name)] = snapshot.channels[i];
  }
  return values;
}

double channel_value(const Snapshot& snapshot, const std::string& name) {
  const auto index = snapshot.channel_list->find(name);
  if (!index) throw py::key_error(fmt::format("this run has no channel \"{}\"", name));
  return snapshot.channels[*index];
}

// One integer of each element, copied: elements are records.
template <typename Member>
py::array_t<std::int32_t> of_elements(const Structure& structure, const Member& member) {
  py::array_t<std::int32_t> values(static_cast<py::ssize_t>(structure.elements.size()));
  std::int32_t* value = values.mutable_data();
  for (const StructureElement& element : structure.elements) *value++ = member(element);
  return values;
}

py::array_t<std::int32_t> element_nodes(const Structure& structure) {
  py::array_t<std::int32_t> nodes({static_cast<py::ssize_t>(structure.elements.size()), py::ssize_t{2}});
  std::int32_t* node = nodes.mutable_data();
  for (const StructureElement& element : structure.elements) {
    *node++ = element.node[0];
    *node++ = element.node[1];
  }
  return nodes;
}

void bind_body(py::module_& module) {
  py::class_<BodyState>(module, "BodyState", "Motion of a rigid body, world frame.")
      .def_readonly("position", &BodyState::position, "Centre of mass, m.")
      .def_property_readonly(
          "attitude",
          [](const BodyState& b) {
            return Eigen::Vector4d(b.attitude.w(), b.attitude.x(), b.attitude.y(), b.attitude.z());
          },
          "Unit quaternion (w, x, y, z), body axes to world axes.")
      .def_readonly("velocity", &BodyState::velocity, "m/s.")
      .def_readonly("angular_velocity", &BodyState::angular_velocity, "rad/s.");
  py::class_<ContactPoint>(module, "ContactPoint", "A place where a cord or a body touches a body.")
      .def_readonly("position", &ContactPoint::position, "m.")
      .def_readonly("force", &ContactPoint::force, "N, on the body.")
      .def_readonly("element", &ContactPoint::element, "Touching element; -1: another body touches.")
      .def_readonly("body", &ContactPoint::body, "Index of the body.");
}

void bind_snapshot(py::module_& module) {
  // The views' owner is the Python object of the snapshot.
  const auto view = [](auto member) {
    return [member](const py::object& self) { return columns(self, self.cast<const Snapshot&>().*member); };
  };
  const auto numbers = [](auto member) {
    return [member](const py::object& self) {
      const auto& values = self.cast<const Snapshot&>().*member;
      return view_of(values.data(), static_cast<py::ssize_t>(values.size()), self);
    };
  };
  py::class_<Snapshot, std::shared_ptr<Snapshot>>(
      module, "Snapshot", "The state of a run at one moment. Arrays are read-only views, world frame, SI units.")
      .def_readonly("time", &Snapshot::time, "s.")
      .def_readonly("step", &Snapshot::step, "Integration steps so far.")
      .def_property_readonly("positions", view(&Snapshot::positions), "(nodes, 3), m.")
      .def_property_readonly("velocities", view(&Snapshot::velocities), "(nodes, 3), m/s.")
      .def_property_readonly("gradients", view(&Snapshot::gradients), "(gradients, 3), dr/dp.")
      .def_property_readonly("tension", numbers(&Snapshot::tension), "(elements,), N; negative in compression.")
      .def_property_readonly("strain", numbers(&Snapshot::strain), "(elements,), Green strain.")
      .def_property_readonly("rope_element_length", numbers(&Snapshot::rope_element_length),
                             "(ropes,), m, material length of one element of each wound rope.")
      .def_readonly("bodies", &Snapshot::bodies, "Motion of each body, in the order of Structure.bodies.")
      .def_readonly("contacts", &Snapshot::contacts)
      .def_property_readonly("channels", &channels_of, "Value of each channel by name.")
      .def("__getitem__", &channel_value, py::arg("channel"), "Value of a channel.")
      .def("__repr__", [](const Snapshot& s) {
        return fmt::format("<Snapshot t = {:.6g} s, {} nodes, {} contacts>", s.time, s.positions.cols(),
                           s.contacts.size());
      });
}

void bind_structure(py::module_& module) {
  py::class_<ChannelInfo>(module, "Channel", "What a channel of a run holds.")
      .def_readonly("name", &ChannelInfo::name)
      .def_readonly("unit", &ChannelInfo::unit, "'1' for pure numbers.")
      .def_readonly("meaning", &ChannelInfo::meaning)
      .def_property_readonly(
          "kind", [](const ChannelInfo& c) { return to_string(c.kind); }, "value, interval, total or index.")
      .def("__repr__", [](const ChannelInfo& c) { return fmt::format("<Channel {} [{}]>", c.name, c.unit); });
  py::class_<StructureBody>(module, "Body", "A rigid body of a structure.")
      .def_readonly("name", &StructureBody::name)
      .def_readonly("mass", &StructureBody::mass, "kg.");
  py::class_<Structure, std::shared_ptr<Structure>>(module, "Structure",
                                                    "The parts of a run that do not change: elements, names, bodies.")
      .def_readonly("node_count", &Structure::node_count)
      .def_readonly("gradient_count", &Structure::gradient_count)
      .def_property_readonly("element_nodes", &element_nodes, "(elements, 2), rows of Snapshot.positions.")
      .def_property_readonly(
          "element_thread",
          [](const Structure& s) { return of_elements(s, [](const StructureElement& e) { return e.thread; }); },
          "(elements,), index into threads.")
      .def_property_readonly(
          "element_group",
          [](const Structure& s) { return of_elements(s, [](const StructureElement& e) { return e.group; }); },
          "(elements,), index into groups.")
      .def_readonly("threads", &Structure::threads, "Names such as 'rod 3'.")
      .def_property_readonly(
          "groups",
          [](const Structure& s) {
            std::vector<std::string> names;
            for (const ElementGroup& group : s.element_groups) names.push_back(group.name);
            return names;
          },
          "Names of the groups of elements.")
      .def(
          "nodes", [](const Structure& s, const std::string& group) { return s.nodes(group); }, py::arg("group"),
          "Nodes of a named group, such as 'rod tips'; empty if there is none.")
      .def_readonly("bodies", &Structure::bodies)
      .def_property_readonly("channels", [](const Structure& s) {
        return std::vector<ChannelInfo>(s.channels->begin(), s.channels->end());
      });
}

}  // namespace

void bind_state(py::module_& module) {
  bind_body(module);
  bind_structure(module);
  bind_snapshot(module);
  py::class_<RunStatus>(module, "RunStatus", "How far a run came, and why it ended.")
      .def_property_readonly(
          "reason", [](const RunStatus& s) { return to_string(s.reason); },
          "running, finished, stopped, diverged or storage_failed.")
      .def_readonly("time", &RunStatus::time, "s.")
      .def_readonly("message", &RunStatus::message)
      .def("__repr__",
           [](const RunStatus& s) { return fmt::format("<RunStatus {}: {}>", to_string(s.reason), s.message); });
  py::class_<RunStatistics>(module, "RunStatistics", "Resources that a run used.")
      .def_readonly("simulated_seconds", &RunStatistics::simulated_seconds)
      .def_readonly("wall_seconds", &RunStatistics::wall_seconds)
      .def_readonly("cpu_seconds", &RunStatistics::cpu_seconds)
      .def_readonly("steps", &RunStatistics::steps)
      .def_readonly("elements", &RunStatistics::elements)
      .def_readonly("coordinates", &RunStatistics::coordinates)
      .def_readonly("time_step", &RunStatistics::time_step, "s, smallest step used.")
      .def_readonly("step_limit", &RunStatistics::step_limit, "What limits the step.")
      .def_readonly("evaluation", &RunStatistics::evaluation);
}

}  // namespace netpocket::python
