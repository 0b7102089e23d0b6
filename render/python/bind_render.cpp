// Pictures and figures as a Python module, netpocket._render. Draws without a display. Its classes come from
// netpocket._engine. The interpreter lock is held while a picture is drawn: VTK draws one at a time.

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <memory>
#include <optional>

#include "engine/recording/recording.h"
#include "engine/state/structure.h"
#include "render/figures/figure_file.h"
#include "render/figures/paper_figures.h"
#include "render/output/png_file.h"
#include "render/output/run_renderer.h"
#include "render/render_error.h"
#include "render/scene/visible_points.h"

namespace netpocket {
namespace {

namespace py = pybind11;
using Pixels = py::array_t<std::uint8_t, py::array::c_style | py::array::forcecast>;

struct PictureOptions {
  int width, height;
  std::string camera, color_by, background, title;
  bool contact_arrows, trails, ghost;
  double target_opacity;
  int supersampling;
};

RunView view_of(const PictureOptions& options) {
  RunView view;
  view.frame.width = options.width;
  view.frame.height = options.height;
  view.frame.supersampling = options.supersampling;
  view.camera = camera_from_name(options.camera);
  SceneOptions& scene = view.frame.scene;
  scene.color_by = color_by_from_name(options.color_by);
  scene.background = background_from_name(options.background);
  scene.title = options.title;
  scene.contact_arrows = options.contact_arrows;
  scene.trails = options.trails;
  scene.ghost = options.ghost;
  scene.target_opacity = options.target_opacity;
  return view;
}

// (height, width, 3), rows from the top. The array owns the pixels.
py::array to_array(Image image) {
  auto kept = std::make_unique<Image>(std::move(image));
  const py::capsule owner(kept.get(), [](void* pixels) { delete static_cast<Image*>(pixels); });
  const Image& picture = *kept.release();
  return py::array_t<std::uint8_t>({picture.height, picture.width, 3}, picture.rgb.data(), owner);
}

py::array draw_recording(const Recording& recording, double time, const PictureOptions& options) {
  return to_array(smooth_frame(RunRenderer(recording, view_of(options)).draw(time)));
}

py::array draw_snapshot(const Structure& structure, const Snapshot& snapshot, const PictureOptions& options) {
  if (snapshot.positions.cols() != structure.node_count || snapshot.bodies.size() != structure.bodies.size()) {
    throw RenderError("the snapshot does not belong to this structure");
  }
  const RunView view = view_of(options);
  FrameRenderer renderer(make_gl_host(view.backend), structure, view.frame);
  renderer.set_view(frame_view(view.camera, visible_points(structure, snapshot), renderer.aspect(), view.share));
  return to_array(renderer.render(snapshot));
}

py::bytes png_of(const Pixels& pixels) {
  if (pixels.ndim() != 3 || pixels.shape(2) != 3) throw RenderError("a picture has the shape (height, width, 3)");
  Image image{static_cast<int>(pixels.shape(1)), static_cast<int>(pixels.shape(0)), {}};
  image.rgb.assign(pixels.data(), pixels.data() + pixels.size());
  return png_bytes(image);
}

py::bytes figure_of(const std::vector<std::shared_ptr<Recording>>& recordings, const std::string& name,
                    const std::string& format, double resolution) {
  std::vector<const Recording*> runs;
  for (const auto& recording : recordings) runs.push_back(recording.get());
  return encode_figure(make_figure(name, run_series(runs)), figure_format(format), resolution);
}

void translate(std::exception_ptr error) {
  try {
    if (error) std::rethrow_exception(error);
  } catch (const RenderError& e) {
    PyErr_SetString(PyExc_ValueError, e.what());
  } catch (const FigureError& e) {
    PyErr_SetString(PyExc_ValueError, e.what());
  }
}

}  // namespace
}  // namespace netpocket

PYBIND11_MODULE(_pictures, module) {
  using namespace netpocket;
  module.doc() = "Pictures and figures of runs, drawn without a display.";
  py::module_::import("netpocket._engine");
  py::register_exception_translator(translate);
  py::class_<PictureOptions>(module, "PictureOptions")
      .def(py::init([](int width, int height, const std::string& camera, const std::string& color_by,
                       const std::string& background, const std::string& title, bool contact_arrows, bool trails,
                       bool ghost, double target_opacity, int supersampling) {
             if (!(target_opacity >= 0 && target_opacity <= 1)) throw RenderError("target_opacity is from 0 to 1");
             return PictureOptions{width,          height, camera, color_by,       background,   title,
                                   contact_arrows, trails, ghost,  target_opacity, supersampling};
           }),
           py::arg("width"), py::arg("height"), py::arg("camera"), py::arg("color_by"), py::arg("background"),
           py::arg("title"), py::arg("contact_arrows"), py::arg("trails"), py::arg("ghost"), py::arg("target_opacity"),
           py::arg("supersampling"));
  module.def("draw_recording", &draw_recording);
  module.def("draw_snapshot", &draw_snapshot);
  module.def("png_of", &png_of);
  module.def("figure_of", &figure_of);
  module.def("figure_names", &figure_names);
}
