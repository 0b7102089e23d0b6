// Draws the made-up pocket of the tests into a PNG: used by the tests that need a process of its own for each back end,
// and to look at the scene without a run. `draw_pocket` alone says how it is called.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <exception>

#include "render/output/frame_renderer.h"
#include "render/output/png_file.h"
#include "render/render_error.h"
#include "render/scene/visible_points.h"
#include "tests/render/synthetic_pocket.h"

namespace netpocket {
namespace {

struct Arguments {
  std::string file;
  std::string backend = "osmesa";
  std::string camera = "iso";
  std::string color_by = "none";
  std::string background = "white";
  std::string target = "sphere";
  std::string title;
  double closed = 0;
  int width = 1280;
  int height = 720;
  int supersampling = 2;
};

Shape target_shape(const std::string& name) {
  if (name == "box") return Box{{6, 7, 5}};
  if (name == "cylinder") return Cylinder{3, 7};
  return Sphere{4.5};
}

void draw(const Arguments& arguments) {
  const auto structure = synthetic::make_structure(target_shape(arguments.target));
  FrameOptions options{arguments.width, arguments.height, arguments.supersampling, {}};
  options.scene.color_by = color_by_from_name(arguments.color_by);
  options.scene.background = background_from_name(arguments.background);
  options.scene.phases = pocket_phases(0, 10, 10);
  options.scene.title = arguments.title;
  FrameRenderer renderer(make_gl_host(gl_backend_from_name(arguments.backend)), structure, options);
  const auto open = synthetic::make_snapshot(structure, 0, 0);
  renderer.set_view(frame_view(camera_from_name(arguments.camera), visible_points(structure, open), renderer.aspect()));
  const auto snapshot = synthetic::make_snapshot(structure, 10 * arguments.closed, arguments.closed);
  write_png(renderer.render(snapshot), arguments.file);
}

}  // namespace
}  // namespace netpocket

int main(int argc, char** argv) {
  netpocket::Arguments arguments;
  CLI::App app("Draws a made-up pocket");
  app.add_option("file", arguments.file, "PNG to write")->required();
  app.add_option("--backend", arguments.backend, "auto, osmesa or egl");
  app.add_option("--camera", arguments.camera, "iso, side, front, mouth or follow");
  app.add_option("--color-by", arguments.color_by, "none, tension, strain or speed");
  app.add_option("--background", arguments.background, "white or space");
  app.add_option("--target", arguments.target, "sphere, box or cylinder");
  app.add_option("--title", arguments.title, "written above");
  app.add_option("--closed", arguments.closed, "0 (open) to 1 (closed)");
  app.add_option("--width", arguments.width, "pixels");
  app.add_option("--height", arguments.height, "pixels");
  app.add_option("--supersampling", arguments.supersampling, "1 to 4");
  CLI11_PARSE(app, argc, argv);
  try {
    netpocket::draw(arguments);
    return 0;
  } catch (const std::exception& error) {
    fmt::print(stderr, "draw_pocket: {}\n", error.what());
    return 6;
  }
}
