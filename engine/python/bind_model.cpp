// Models of cables of any kind, and systems that step them.

#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <memory>

#include "engine/dynamics/system/cable_system.h"
#include "engine/model/model.h"
#include "engine/orbit/reference_orbit.h"
#include "engine/python/conversions.h"
#include "engine/python/single_use.h"

namespace netpocket::python {
namespace {

std::int32_t add_node(Model& model, const Eigen::Vector3d& position, double mass, const Eigen::Vector3d& load,
                      const Eigen::Vector3d& velocity, bool fixed) {
  const std::int32_t node = model.add_node(position);
  ModelNode& added = model.nodes.back();
  added.point_mass = mass;
  added.load = load;
  added.velocity = velocity;
  if (fixed) model.fix_node(node);
  return node;
}

std::int32_t add_material(Model& model, double EA, double EI, double mass_per_length, double axial_damping,
                          double bending_damping, double compression, double radius, double youngs_modulus,
                          double poisson_ratio) {
  return model.add_material({.section = {.EA = EA,
                                         .EI = EI,
                                         .mass_per_length = mass_per_length,
                                         .axial_damping = axial_damping,
                                         .bending_damping = bending_damping,
                                         .compression = compression},
                             .radius = radius,
                             .youngs_modulus = youngs_modulus,
                             .poisson_ratio = poisson_ratio});
}

std::vector<std::int32_t> add_cable(Model& model, std::int64_t begin, std::int64_t end, int elements,
                                    std::int64_t material, const std::string& name) {
  if (elements < 1) throw py::value_error("a cable needs at least one element");
  const std::int32_t first = checked_index(begin, model.nodes.size(), "node"),
                     last = checked_index(end, model.nodes.size(), "node");
  if (model.nodes[first].position == model.nodes[last].position) {
    throw py::value_error("the ends of a cable must not coincide");
  }
  const std::int32_t thread = model.add_thread(name);
  return model.add_straight_cable(first, last, elements, checked_index(material, model.materials.size(), "material"), 0,
                                  thread);
}

std::int32_t add_sphere(Model& model, const std::string& name, double radius, double mass,
                        const Eigen::Vector3d& position, const Eigen::Vector3d& velocity) {
  if (!(radius > 0) || !(mass > 0)) throw py::value_error("a sphere needs a positive radius and mass");
  const Shape shape = Sphere{radius};
  ModelBody body{.name = name, .shape = shape, .mass = mass, .inertia = solid_inertia(shape, mass), .state = {}};
  body.state.position = position;
  body.state.velocity = velocity;
  return model.add_body(body);
}

std::int32_t add_box(Model& model, const std::string& name, const Eigen::Vector3d& size, double mass,
                     const Eigen::Vector3d& position, const Eigen::Vector3d& velocity) {
  if (!(size.minCoeff() > 0) || !(mass > 0)) throw py::value_error("a box needs positive edges and mass");
  const Shape shape = Box{size};
  ModelBody body{.name = name, .shape = shape, .mass = mass, .inertia = solid_inertia(shape, mass), .state = {}};
  body.state.position = position;
  body.state.velocity = velocity;
  return model.add_body(body);
}

// The enumerator with the name `given` among `names`, which are in the enumeration's order.
template <typename Enum, std::size_t Count>
Enum named(const std::array<std::string_view, Count>& names, const std::string& given, const char* what) {
  const auto found = std::ranges::find(names, given);
  if (found == names.end()) {
    throw py::value_error(fmt::format("{} \"{}\" is not known; there are {}", what, given, fmt::join(names, ", ")));
  }
  return static_cast<Enum>(found - names.begin());
}

void set_orbit(Model& model, const std::string& field, const OrbitElements& elements, const std::string& x_along,
               const std::string& y_along) {
  constexpr std::array<std::string_view, 3> kFields = {"hill", "two_body", "two_body_j2"};
  constexpr std::array<std::string_view, 6> kAxes = {"v_bar",       "minus_v_bar", "r_bar",
                                                     "minus_r_bar", "h_bar",       "minus_h_bar"};
  const auto x = named<LocalAxis>(kAxes, x_along, "axis"), y = named<LocalAxis>(kAxes, y_along, "axis");
  if (!are_perpendicular(x, y)) throw py::value_error("x_along and y_along must be at right angles");
  if (!(elements.perigee_radius > 6.4e6) || !(elements.eccentricity >= 0 && elements.eccentricity < 1)) {
    throw py::value_error("an orbit needs a perigee radius above 6.4e6 m and an eccentricity from 0 to below 1");
  }
  model.orbit = orbit_of(elements, named<OrbitField>(kFields, field, "field"), x, y);
}

// A system that one thread at a time may use.
class PythonSystem {
 public:
  PythonSystem(const Model& model, const SystemOptions& options) : system_(model, options) {}

  template <typename Function>
  auto with(const Function& function) {
    const SingleUse used(busy_, "system");
    return function(system_);
  }

 private:
  CableSystem system_;
  std::atomic<bool> busy_ = false;
};

void check_fault(const CableSystem& system) {
  if (const auto fault = system.fault()) throw RunDiverged{{RunReason::diverged, system.time(), *fault}};
}

std::int32_t node_of(const CableSystem& system, std::int64_t node) {
  return checked_index(node, system.model().nodes.size(), "node");
}

void step(CableSystem& system, double dt, std::int64_t count) {
  if (!(dt > 0)) throw py::value_error("a step must be positive");
  constexpr std::int64_t kPart = 256;
  for (std::int64_t left = count; left > 0; left -= kPart) {
    {
      const py::gil_scoped_release unlocked;
      for (std::int64_t i = 0; i < std::min(left, kPart); ++i) system.step(dt);
    }
    check_fault(system);
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  }
}

void bind_parts(py::module_& module) {
  py::class_<Model>(module, "Model", "A model of cables and rigid bodies. SI units, world frame.")
      .def(py::init<>())
      .def_readwrite("gravity", &Model::gravity, "m/s^2.")
      .def("add_material", &add_material, py::kw_only(), py::arg("EA"), py::arg("EI"), py::arg("mass_per_length"),
           py::arg("axial_damping") = 0.0, py::arg("bending_damping") = 0.0, py::arg("compression") = 1.0,
           py::arg("radius") = 0.0, py::arg("youngs_modulus") = 0.0, py::arg("poisson_ratio") = 0.0,
           "A cord: EA (N), EI (N m^2), kg/m, damping (s), the fraction of EA in compression; for contact radius (m), "
           "Young's modulus (Pa). Returns its index.")
      .def("add_node", &add_node, py::arg("position"), py::kw_only(), py::arg("mass") = 0.0,
           py::arg("load") = kZeroVector, py::arg("velocity") = kZeroVector, py::arg("fixed") = false,
           "A node (m), with a point mass (kg), a constant load (N) and a velocity (m/s). Returns its index.")
      .def("add_cable", &add_cable, py::arg("begin"), py::arg("end"), py::arg("elements"), py::arg("material"),
           py::arg("name") = "cable", "A straight, unstrained cable between two nodes. Returns its elements.")
      .def("add_sphere", &add_sphere, py::arg("name"), py::kw_only(), py::arg("radius"), py::arg("mass"),
           py::arg("position") = kZeroVector, py::arg("velocity") = kZeroVector,
           "A rigid sphere (m, kg). Returns its index.")
      .def("add_box", &add_box, py::arg("name"), py::kw_only(), py::arg("size"), py::arg("mass"),
           py::arg("position") = kZeroVector, py::arg("velocity") = kZeroVector,
           "A rigid box (m, kg). Returns its index.")
      .def(
          "contact",
          [](Model& m, double restitution, double friction, bool cords, bool bodies) {
            m.contact = {.restitution = restitution, .friction = friction, .cords = cords, .bodies = bodies};
          },
          py::kw_only(), py::arg("restitution") = 0.5, py::arg("friction") = 0.0, py::arg("cords") = false,
          py::arg("bodies") = false, "Constants of contact, and what else touches besides cords and bodies.")
      .def(
          "orbit",
          [](Model& m, const std::string& field, double perigee_radius, double eccentricity, double inclination,
             double argument_of_perigee, double true_anomaly, const std::string& x_along, const std::string& y_along) {
            set_orbit(m, field, {perigee_radius, eccentricity, inclination, argument_of_perigee, true_anomaly}, x_along,
                      y_along);
          },
          py::arg("field") = "hill", py::kw_only(), py::arg("perigee_radius") = OrbitElements{}.perigee_radius,
          py::arg("eccentricity") = 0.0, py::arg("inclination") = 0.0, py::arg("argument_of_perigee") = 0.0,
          py::arg("true_anomaly") = 0.0, py::arg("x_along") = "h_bar", py::arg("y_along") = "v_bar",
          "Puts the origin on an orbit (m, rad), whose tide then acts on everything; the axes do not turn. `field`: "
          "\"hill\" (a circle), \"two_body\" or \"two_body_j2\". `x_along`, `y_along`: where the axes point at the "
          "start, "
          "\"v_bar\", \"r_bar\", \"h_bar\" or these with \"minus_\" before.")
      .def("find_fault", &Model::find_fault, "What is wrong with the model, one sentence, or None.")
      .def_property_readonly("node_count", [](const Model& m) { return m.nodes.size(); })
      .def_property_readonly("element_count", [](const Model& m) { return m.elements.size(); });
}

}  // namespace

void bind_model(py::module_& module) {
  bind_parts(module);
  py::class_<EnergyAudit>(module, "Energies", "Energies of a system at one moment, J.")
      .def_readonly("kinetic", &EnergyAudit::kinetic)
      .def_readonly("strain", &EnergyAudit::strain)
      .def_readonly("contact", &EnergyAudit::contact)
      .def_readonly("input", &EnergyAudit::input, "Work since the start: gravity, loads, controls, winding.")
      .def_property_readonly("spent", [](const EnergyAudit& e) { return e.spent.total(); })
      .def_readonly("error", &EnergyAudit::error, "What the account does not explain.");
  py::class_<PythonSystem>(module, "System", "Steps a model in time. One thread at a time.")
      .def(py::init([](const Model& model, bool full) {
             return std::make_unique<PythonSystem>(
                 model, SystemOptions{full ? ElementEvaluation::full : ElementEvaluation::mean_strain});
           }),
           py::arg("model"), py::kw_only(), py::arg("full") = false,
           "`full`: five Gauss points and consistent mass, the reference; else the fast mean-strain elements. Raises "
           "ValueError with what is wrong with the model.")
      .def_property_readonly(
          "time", [](PythonSystem& s) { return s.with([](auto& system) { return system.time(); }); }, "s.")
      .def(
          "stable_step", [](PythonSystem& s) { return s.with([](auto& system) { return system.stable_step().step; }); },
          "Largest stable step (s), without a safety factor.")
      .def(
          "step",
          [](PythonSystem& s, double dt, std::int64_t count) {
            s.with([&](CableSystem& system) { step(system, dt, count); });
          },
          py::arg("dt"), py::arg("count") = 1,
          "Makes steps of dt (s), without the interpreter lock. Raises DivergedError.")
      .def(
          "position",
          [](PythonSystem& s, std::int64_t node) {
            return s.with([&](auto& system) { return system.position(node_of(system, node)); });
          },
          py::arg("node"), "m.")
      .def(
          "velocity",
          [](PythonSystem& s, std::int64_t node) {
            return s.with([&](auto& system) { return system.velocity(node_of(system, node)); });
          },
          py::arg("node"), "m/s, at the last half step.")
      .def(
          "body",
          [](PythonSystem& s, std::int64_t body) {
            return s.with(
                [&](auto& system) { return system.body(checked_index(body, system.model().bodies.size(), "body")); });
          },
          py::arg("body"), "Motion of a body.")
      .def(
          "energies", [](PythonSystem& s) { return s.with([](auto& system) { return system.audit(); }); },
          "Energies now.")
      .def(
          "snapshot",
          [](PythonSystem& s) {
            auto snapshot = std::make_shared<Snapshot>();
            s.with([&](CableSystem& system) { system.capture(*snapshot); });
            return snapshot;
          },
          "The present state, without channels.");
}

}  // namespace netpocket::python
