// The engine as a Python module, netpocket._engine. The package netpocket (netpocket/__init__.py) re-exports it.

#include "engine/python/conversions.h"
#include "engine/recording/recording.h"
#include "generated/commit.h"

namespace netpocket::python {
namespace {

py::object error_class(const char* name) { return py::module_::import("netpocket.errors").attr(name); }

void raise(const char* name, const std::string& message) { PyErr_SetString(error_class(name).ptr(), message.c_str()); }

void raise(const ScenarioFault& fault) {
  py::list problems;
  for (const Diagnostic& problem : fault.problems.list()) {
    problems.append(error_class("Problem")(problem.file, problem.line, problem.key, problem.message));
  }
  const py::object cls = error_class("ScenarioError");
  PyErr_SetObject(cls.ptr(), cls(problems).ptr());
}

void translate(std::exception_ptr error) {
  try {
    if (error) std::rethrow_exception(error);
  } catch (const ScenarioFault& fault) {
    raise(fault);
  } catch (const RunDiverged& run) {
    raise("DivergedError", run.status.message);
  } catch (const RecordingError& e) {
    raise("RecordingError", e.what());
  } catch (const FileError& e) {
    raise("FileError", e.what());
  }
}

}  // namespace

void bind_errors(py::module_& /*module*/) { py::register_exception_translator(translate); }

}  // namespace netpocket::python

PYBIND11_MODULE(_engine, module) {
  using namespace netpocket::python;
  module.doc() = "Netpocket's engine: scenarios, models, simulations and recordings.";
  module.attr("__version__") = NETPOCKET_VERSION;
  module.attr("__commit__") = NETPOCKET_COMMIT;
  bind_errors(module);
  bind_scenario(module);
  bind_state(module);
  bind_model(module);
  bind_simulation(module);
  bind_recording(module);
}
