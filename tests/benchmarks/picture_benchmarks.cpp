// What a picture costs, by stage: drawing, smoothing, compressing and all of them overlapping. 1280x720, OSMesa.

#include <benchmark/benchmark.h>

#include <filesystem>

#include "engine/recording/recorder.h"
#include "engine/recording/recording.h"
#include "render/output/frame_renderer.h"
#include "render/output/png_file.h"
#include "render/output/render_frames.h"
#include "render/scene/visible_points.h"
#include "tests/render/synthetic_pocket.h"

namespace netpocket {
namespace {

constexpr int kFrames = 60;

std::vector<Snapshot> closing(const Structure& structure) {
  std::vector<Snapshot> snapshots;
  for (int i = 0; i < kFrames; ++i) {
    snapshots.push_back(synthetic::make_snapshot(structure, i / 6.0, static_cast<double>(i) / kFrames));
  }
  return snapshots;
}

struct Scene {
  explicit Scene(int supersampling) {
    FrameOptions options;
    options.supersampling = supersampling;
    renderer = std::make_unique<FrameRenderer>(make_gl_host(GlBackend::osmesa), structure, options);
    renderer->set_view(frame_view(CameraPreset::iso, visible_points(structure, snapshots[0]), renderer->aspect()));
  }

  Structure structure = synthetic::make_structure();
  std::vector<Snapshot> snapshots = closing(structure);
  std::unique_ptr<FrameRenderer> renderer;
};

// Argument: supersampling; 1 is what the workbench shows while something moves.
void draw_frame(benchmark::State& state) {
  Scene scene(static_cast<int>(state.range(0)));
  DrawnFrame frame;
  std::size_t i = 0;
  for (auto _ : state) frame = scene.renderer->draw(scene.snapshots[i++ % kFrames], std::move(frame));
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(draw_frame)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();

void smooth_a_frame(benchmark::State& state) {
  Scene scene(2);
  const auto frame = scene.renderer->draw(scene.snapshots[30]);
  Image image;
  for (auto _ : state) image = smooth_frame(frame, std::move(image));
}
BENCHMARK(smooth_a_frame)->Unit(benchmark::kMillisecond)->UseRealTime();

void write_a_png(benchmark::State& state) {
  Scene scene(2);
  const auto image = scene.renderer->render(scene.snapshots[30]);
  const auto file = (std::filesystem::temp_directory_path() / "netpocket_benchmark.png").string();
  PngWriter png;
  for (auto _ : state) png.write(image, file);
  std::filesystem::remove(file);
}
BENCHMARK(write_a_png)->Unit(benchmark::kMillisecond)->UseRealTime();

// Argument: supersampling. Everything that `netpocket render` does for a frame.
void frame_to_png(benchmark::State& state) {
  const auto folder = std::filesystem::temp_directory_path() / "netpocket_benchmark";
  std::filesystem::create_directories(folder);
  const auto file = (folder / "run.h5").string();
  const auto structure = synthetic::make_structure();
  Recorder recorder(file, {}, structure, true);
  for (const auto& snapshot : closing(structure)) recorder.write(snapshot);
  recorder.finish({RunReason::finished, 10, ""}, {});
  const Recording recording(file);
  RenderOptions options;
  options.view.backend = GlBackend::osmesa;
  options.view.frame.supersampling = static_cast<int>(state.range(0));
  options.folder = (folder / "frames").string();
  for (auto _ : state) render_frames(recording, recording.times(), options);
  state.SetItemsProcessed(state.iterations() * kFrames);
  std::filesystem::remove_all(folder);
}
BENCHMARK(frame_to_png)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace netpocket
