#pragma once
// Draws snapshots without a display.
// Thread contract: FrameRenderer belongs to the thread that made its host; smooth_frame may run on any thread.

#include <vtkSmartPointer.h>

#include <memory>
#include <optional>

#include "render/gl/hosted_render_window.h"
#include "render/output/image.h"
#include "render/scene/pocket_scene.h"

namespace netpocket {

struct FrameOptions {
  int width = 1280;       // pixels
  int height = 720;       // pixels
  int supersampling = 2;  // 1: jagged and fastest; n: each pixel is the mean of n x n, 1 to 4
  SceneOptions scene;
};

// Pixels as drawn: `supersampling` times as many in each direction, rows from the bottom, 4 bytes each.
struct DrawnFrame {
  int width = 0;   // of the finished picture, pixels
  int height = 0;  // of the finished picture, pixels
  int supersampling = 1;
  std::optional<ByteColor> transparent_background = {};  // what shows through where alpha is below 255
  std::vector<std::uint8_t> rgba = {};
};

// The finished picture of a drawn frame. A used picture may be given back: its memory is used again.
Image smooth_frame(const DrawnFrame& frame, Image used = {});

class FrameRenderer {
 public:
  // Throws RenderError for sizes below 16 or above 16384 pixels, supersampling included.
  FrameRenderer(std::shared_ptr<GlHost> host, const Structure& structure, const FrameOptions& options);

  void set_view(const CameraView& view);
  double aspect() const { return static_cast<double>(options_.width) / options_.height; }
  PocketScene& scene() { return scene_; }

  // The two halves of render(), so that one thread can draw while another smooths. A used frame may be given back: its
  // memory is used again.
  DrawnFrame draw(const Snapshot& snapshot, DrawnFrame used = {});
  Image render(const Snapshot& snapshot) { return smooth_frame(draw(snapshot)); }

 private:
  FrameOptions options_;
  vtkSmartPointer<HostedRenderWindow> window_;
  PocketScene scene_;
};

}  // namespace netpocket
