// Scenarios and the parameter table.

#include <optional>

#include "engine/python/conversions.h"
#include "engine/scenario/check_scenario.h"
#include "engine/scenario/parameter_text.h"
#include "engine/scenario/parameters.h"
#include "engine/scenario/read_scenario.h"
#include "engine/scenario/write_scenario.h"

namespace netpocket::python {
namespace {

void demand(const Diagnostics& problems) {
  if (!problems.ok()) throw ScenarioFault{problems};
}

// Thrown as KeyError, with the nearest key.
const Parameter& parameter_of(const Scenario& scenario, const std::string& key) {
  if (const Parameter* parameter = find_parameter(key, scenario)) return *parameter;
  std::string text = fmt::format("there is no parameter \"{}\"", key);
  if (const auto nearest = nearest_parameter_key(key, scenario.system)) {
    text += fmt::format("; did you mean \"{}\"?", *nearest);
  }
  throw py::key_error(text);
}

py::object to_python(const Parameter& parameter, const ParameterValue& value) {
  if (const auto* choice = std::get_if<Choice>(&value)) {
    return py::str(std::string(parameter.choices[static_cast<std::size_t>(choice->index)]));
  }
  if (const auto* vector = std::get_if<Eigen::Vector3d>(&value)) {
    return py::make_tuple(vector->x(), vector->y(), vector->z());
  }
  if (const auto* pairs = std::get_if<std::vector<Eigen::Vector2d>>(&value)) {
    py::list list;
    for (const Eigen::Vector2d& pair : *pairs) list.append(py::make_tuple(pair.x(), pair.y()));
    return list;
  }
  if (const auto* number = std::get_if<double>(&value)) return py::float_(*number);
  if (const auto* integer = std::get_if<std::int64_t>(&value)) return py::int_(*integer);
  if (const auto* flag = std::get_if<bool>(&value)) return py::bool_(*flag);
  return py::str(std::get<std::string>(value));
}

[[noreturn]] void refuse(const Parameter& parameter, const py::handle& value) {
  throw py::type_error(
      fmt::format("{} takes {}, not {}", parameter.key, expected_text(parameter), py::repr(value).cast<std::string>()));
}

// A number of any kind that Python or numpy has; truth values are no numbers here.
std::optional<double> number_of(const py::handle& value) {
  if (py::isinstance<py::bool_>(value) || py::isinstance<py::str>(value)) return std::nullopt;
  const double number = PyFloat_AsDouble(value.ptr());
  if (!PyErr_Occurred()) return number;
  PyErr_Clear();
  return std::nullopt;
}

std::optional<std::int64_t> integer_of(const py::handle& value) {
  if (py::isinstance<py::bool_>(value)) return std::nullopt;
  const py::object index = py::reinterpret_steal<py::object>(PyNumber_Index(value.ptr()));
  const long long integer = index ? PyLong_AsLongLong(index.ptr()) : -1;
  if (!PyErr_Occurred()) return integer;
  PyErr_Clear();
  return std::nullopt;
}

template <int kSize>
std::optional<Eigen::Matrix<double, kSize, 1>> vector_of(const py::handle& value) {
  if (!PySequence_Check(value.ptr()) || py::isinstance<py::str>(value) || py::len(value) != kSize) return std::nullopt;
  Eigen::Matrix<double, kSize, 1> vector = Eigen::Matrix<double, kSize, 1>::Zero();
  for (int i = 0; i < kSize; ++i) {
    const auto number = number_of(value[py::int_(i)]);
    if (!number) return std::nullopt;
    vector[i] = *number;
  }
  return vector;
}

std::optional<ParameterValue> pairs_of(const py::handle& value) {
  if (!PySequence_Check(value.ptr()) || py::isinstance<py::str>(value)) return std::nullopt;
  std::vector<Eigen::Vector2d> pairs;
  for (const py::handle item : value) {
    const auto pair = vector_of<2>(item);
    if (!pair) return std::nullopt;
    pairs.push_back(*pair);
  }
  return pairs;
}

std::optional<ParameterValue> value_of(const Parameter& parameter, const py::handle& value) {
  switch (parameter.type) {
    case ParameterType::number:
      if (const auto number = number_of(value)) return *number;
      return std::nullopt;
    case ParameterType::integer:
      if (const auto integer = integer_of(value)) return *integer;
      return std::nullopt;
    case ParameterType::boolean:
      if (py::isinstance<py::bool_>(value)) return value.cast<bool>();
      return std::nullopt;
    case ParameterType::text:
      if (py::isinstance<py::str>(value)) return value.cast<std::string>();
      return std::nullopt;
    case ParameterType::choice: {
      if (!py::isinstance<py::str>(value)) return std::nullopt;
      const auto text = value.cast<std::string>();
      for (std::size_t i = 0; i < parameter.choices.size(); ++i) {
        if (parameter.choices[i] == text) return Choice{static_cast<int>(i)};
      }
      return std::nullopt;
    }
    case ParameterType::vector:
      if (const auto vector = vector_of<3>(value)) return *vector;
      return std::nullopt;
    case ParameterType::pairs:
      return pairs_of(value);
  }
  return std::nullopt;
}

void set_item(Scenario& scenario, const std::string& key, const py::handle& object) {
  const Parameter& parameter = parameter_of(scenario, key);
  const auto value = value_of(parameter, object);
  if (!value) refuse(parameter, object);
  if (const auto problem = limit_problem(parameter, *value)) {
    Diagnostics problems;
    problems.add({.key = key, .message = *problem});
    throw ScenarioFault{problems};
  }
  parameter.set(scenario, *value);
}

std::vector<std::string> keys_of(const Scenario& scenario) {
  std::vector<std::string> keys;
  for (const Parameter* parameter : parameters_of(scenario)) keys.emplace_back(parameter->key);
  return keys;
}

Scenario loaded(ScenarioResult result) {
  demand(result.diagnostics);
  return std::move(result.scenario);
}

py::object limit_or_none(const Parameter& parameter, double limit) {
  const bool has_limits = parameter.type != ParameterType::boolean && parameter.type != ParameterType::choice;
  return has_limits ? py::object(py::float_(limit)) : py::none();
}

const char* type_name(ParameterType type) {
  constexpr const char* kNames[] = {"number", "integer", "boolean", "text", "choice", "vector", "pairs"};
  return kNames[static_cast<std::size_t>(type)];
}

}  // namespace

void bind_scenario(py::module_& module) {
  py::class_<Parameter>(module, "Parameter", "One parameter of a scenario, from the parameter table.")
      .def_property_readonly(
          "key", [](const Parameter& p) { return std::string(p.key); }, "Such as 'net.diameter'.")
      .def_property_readonly(
          "type", [](const Parameter& p) { return type_name(p.type); },
          "number, integer, boolean, text, choice, vector (3 numbers) or pairs (rows of 2 numbers).")
      .def_property_readonly(
          "unit", [](const Parameter& p) { return std::string(p.unit); }, "SI unit; empty when dimensionless.")
      .def_property_readonly("help", [](const Parameter& p) { return std::string(p.help); })
      .def_property_readonly(
          "source", [](const Parameter& p) { return std::string(p.source); }, "Where the default comes from.")
      .def_property_readonly(
          "choices", [](const Parameter& p) { return std::vector<std::string>(p.choices.begin(), p.choices.end()); })
      .def_property_readonly(
          "minimum", [](const Parameter& p) { return limit_or_none(p, p.limits.minimum); },
          "Smallest value, or length of a text.")
      .def_property_readonly("maximum", [](const Parameter& p) { return limit_or_none(p, p.limits.maximum); })
      .def("__repr__", [](const Parameter& p) { return fmt::format("<Parameter {}: {}>", p.key, expected_text(p)); });

  module.def(
      "parameters",
      [](const std::string& system) {
        py::list list;
        for (const Parameter& p : parameters(system)) list.append(py::cast(&p, py::return_value_policy::reference));
        return list;
      },
      py::arg("system") = std::string(kPocketSystem), "All parameters of a kind of capture system, in their order.");

  py::class_<Scenario>(module, "Scenario",
                       "Everything that a user decides about a capture. SI units; the pocket's axis is +Y.\n\n"
                       "Parameters are read and set by key: scenario['closing.duration'] = 5.")
      .def(py::init<>(), "Case 1 of Tang et al. (2023).")
      .def("__getitem__",
           [](const Scenario& s, const std::string& key) {
             const Parameter& parameter = parameter_of(s, key);
             return to_python(parameter, parameter.get(s));
           })
      .def("__setitem__", &set_item)
      .def("__contains__",
           [](const Scenario& s, const std::string& key) { return find_parameter(key, s) != nullptr; })
      .def("__len__", [](const Scenario& s) { return parameters_of(s).size(); })
      .def("__iter__", [](const Scenario& s) { return py::iter(py::cast(keys_of(s))); })
      .def("keys", &keys_of)
      .def(
          "parameter",
          [](const Scenario& s, const std::string& key) -> const Parameter& { return parameter_of(s, key); },
          py::arg("key"), py::return_value_policy::reference, "Unit, limits and help of a parameter.")
      .def(
          "apply", [](Scenario& s, const std::string& setting) { demand(apply_setting(s, setting)); },
          py::arg("setting"), "Applies text such as 'net.diameter=0.006'.")
      .def(
          "check", [](const Scenario& s) { demand(check_scenario(s)); },
          "Raises ScenarioError with all problems unless the scenario can be simulated.")
      .def("text", &write_scenario_text, "The complete scenario as TOML.")
      .def("copy", [](const Scenario& s) { return s; })
      .def("__copy__", [](const Scenario& s) { return s; })
      .def(
          "__deepcopy__", [](const Scenario& s, const py::dict&) { return s; }, py::arg("memo"))
      .def("__eq__",
           [](const Scenario& a, const Scenario& b) { return write_scenario_text(a) == write_scenario_text(b); })
      .def(py::pickle([](const Scenario& s) { return py::make_tuple(write_scenario_text(s), s.files.folder); },
                      [](const py::tuple& state) {
                        Scenario scenario = loaded(read_scenario_text(state[0].cast<std::string>(), "pickle"));
                        scenario.files.folder = state[1].cast<std::string>();
                        return scenario;
                      }))
      .def("__repr__", [](const Scenario& s) { return fmt::format("<Scenario {}>", quoted(s.name)); });

  module.def(
      "load", [](const std::string& path) { return loaded(read_scenario_file(path)); }, py::arg("path"),
      "Reads a scenario file. Raises ScenarioError with file, line and key of each problem.");
  module.def(
      "loads", [](const std::string& text) { return loaded(read_scenario_text(text, "text")); }, py::arg("text"),
      "Reads a scenario from TOML text.");
}

}  // namespace netpocket::python
