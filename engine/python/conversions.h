#pragma once
// What the files of the Python module share. All arrays that Python gets are views that keep their owner alive, and are
// read-only: the owner decides when they change.

#include <fmt/format.h>
#include <pybind11/eigen.h>
#include <pybind11/functional.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <vector>

#include "engine/base/diagnostics.h"
#include "engine/state/run_status.h"

namespace netpocket::python {

namespace py = pybind11;

// Thrown for the problems of a scenario; Python sees netpocket.ScenarioError.
struct ScenarioFault {
  Diagnostics problems;
};
// Thrown for a run that diverged; Python sees netpocket.DivergedError.
struct RunDiverged {
  RunStatus status;
};

inline const Eigen::Vector3d kZeroVector = Eigen::Vector3d::Zero();

// Throws IndexError unless the index is that of one of `count` items.
inline std::int32_t checked_index(std::int64_t index, std::size_t count, const char* what) {
  if (index < 0 || index >= static_cast<std::int64_t>(count)) {
    throw py::index_error(fmt::format("there is no {} {}; there are {}", what, index, count));
  }
  return static_cast<std::int32_t>(index);
}

// A view of numbers that `owner` holds: one row for each of `count` items of `width` numbers.
template <typename Number>
py::array_t<Number> view_of_rows(const Number* first, py::ssize_t count, py::ssize_t width, const py::handle& owner) {
  py::array_t<Number> view({count, width}, first, owner);
  view.attr("setflags")(py::arg("write") = false);
  return view;
}
template <typename Number>
py::array_t<Number> view_of(const Number* first, py::ssize_t count, const py::handle& owner) {
  py::array_t<Number> view({count}, first, owner);
  view.attr("setflags")(py::arg("write") = false);
  return view;
}
template <typename Number>
py::array_t<Number> view_of(const std::vector<Number>& numbers, const py::handle& owner) {
  return view_of(numbers.data(), static_cast<py::ssize_t>(numbers.size()), owner);
}

// Each file adds its classes to the module.
void bind_errors(py::module_& module);
void bind_scenario(py::module_& module);
void bind_state(py::module_& module);
void bind_model(py::module_& module);
void bind_simulation(py::module_& module);
void bind_recording(py::module_& module);

}  // namespace netpocket::python
