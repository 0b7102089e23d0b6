#include "render/output/frame_renderer.h"

#include <fmt/format.h>
#include <vtkNew.h>
#include <vtkUnsignedCharArray.h>

#include "render/render_error.h"

namespace netpocket {
namespace {

constexpr int kSmallest = 16, kLargest = 16384, kMostSamples = 4;

FrameOptions checked(const FrameOptions& options) {
  if (options.supersampling < 1 || options.supersampling > kMostSamples) {
    throw RenderError(fmt::format("supersampling must be from 1 to {}, not {}", kMostSamples, options.supersampling));
  }
  const int largest = kLargest / options.supersampling;
  if (std::min(options.width, options.height) < kSmallest || std::max(options.width, options.height) > largest) {
    throw RenderError(fmt::format("a picture of {}x{} pixels cannot be drawn: each side must be from {} to {} pixels",
                                  options.width, options.height, kSmallest, largest));
  }
  return options;
}

// Mean of `samples` x `samples` pixels, summed down the rows of one row of the finished picture.
void smooth_row(const DrawnFrame& frame, int row, std::uint8_t* rgb) {
  const int samples = frame.supersampling, area = samples * samples;
  const std::size_t source_row_bytes = 4 * static_cast<std::size_t>(frame.width) * samples;
  const std::uint8_t* first =
      frame.rgba.data() + static_cast<std::size_t>(frame.height - 1 - row) * samples * source_row_bytes;
  for (int column = 0; column < frame.width; ++column) {
    unsigned sum[3] = {};
    for (int y = 0; y < samples; ++y) {
      const std::uint8_t* pixel = first + y * source_row_bytes + 4 * static_cast<std::size_t>(column) * samples;
      for (int x = 0; x < samples; ++x, pixel += 4) {
        for (int c = 0; c < 3; ++c) sum[c] += pixel[c];
      }
    }
    for (int c = 0; c < 3; ++c) *rgb++ = static_cast<std::uint8_t>((sum[c] + area / 2) / area);
  }
}

}  // namespace

Image smooth_frame(const DrawnFrame& frame) {
  Image image{frame.width, frame.height, {}};
  image.rgb.resize(image.row_bytes() * frame.height);
  for (int row = 0; row < frame.height; ++row) smooth_row(frame, row, image.rgb.data() + row * image.row_bytes());
  return image;
}

FrameRenderer::FrameRenderer(std::shared_ptr<GlHost> host, const Structure& structure, const FrameOptions& options)
    : options_(checked(options)),
      window_(HostedRenderWindow::make(std::move(host), options.width * options.supersampling,
                                       options.height * options.supersampling)),
      scene_(structure, options.scene) {
  window_->AddRenderer(&scene_.renderer());
}

void FrameRenderer::set_view(const CameraView& view) { apply_view(view, *scene_.renderer().GetActiveCamera()); }

DrawnFrame FrameRenderer::draw(const Snapshot& snapshot, DrawnFrame used) {
  scene_.update(snapshot);
  window_->Render();
  used.width = options_.width;
  used.height = options_.height;
  used.supersampling = options_.supersampling;
  const int width = options_.width * options_.supersampling, height = options_.height * options_.supersampling;
  const auto bytes = 4 * static_cast<std::size_t>(width) * height;
  used.rgba.resize(bytes);
  vtkNew<vtkUnsignedCharArray> pixels;
  pixels->SetNumberOfComponents(4);
  pixels->SetArray(used.rgba.data(), static_cast<vtkIdType>(bytes), 1);
  window_->GetRGBACharPixelData(0, 0, width - 1, height - 1, 0, pixels);
  return used;
}

}  // namespace netpocket
