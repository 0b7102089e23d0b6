#include "render/output/frame_renderer.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstring>

#include "render/render_error.h"
#include "render/scene/palette.h"

namespace netpocket {
namespace {

constexpr int kSmallest = 16, kLargest = 16384, kMostSamples = 4;

FrameOptions checked(const FrameOptions& options) {
  if (options.supersampling < 1 || options.supersampling > kMostSamples) {
    throw RenderError(fmt::format("supersampling must be from 1 to {}, not {}", kMostSamples, options.supersampling));
  }
  const int largest = kLargest / options.supersampling;
  if (std::min(options.width, options.height) < kSmallest || std::max(options.width, options.height) > largest) {
    throw RenderError(fmt::format(
        "a picture of {}x{} pixels with supersampling {} cannot be drawn: sides have {} pixels or more, and "
        "{} or less when multiplied by the supersampling",
        options.width, options.height, options.supersampling, kSmallest, kLargest));
  }
  return options;
}

// Adds up the rows of pixels that make one row of the finished picture. Sums of 4 x 255 fit; contiguous, so that the
// compiler can use wide registers.
template <int samples>
void sum_rows(const std::uint8_t* rows, std::size_t row_bytes, std::uint16_t* sums) {
  for (std::size_t i = 0; i < row_bytes; ++i) {
    std::uint16_t sum = rows[i];
    for (int y = 1; y < samples; ++y) sum = static_cast<std::uint16_t>(sum + rows[y * row_bytes + i]);
    sums[i] = sum;
  }
}

// The rounded mean of neighbouring pixels of the summed rows, as the four bytes of a pixel; all four channels at once,
// each in 16 of 64 bits: sums of 16 x 255 fit.
template <int samples>
std::uint32_t mean_pixel(const std::uint16_t* sums) {
  static_assert(std::endian::native == std::endian::little);
  constexpr std::uint64_t kOnes = 0x0001'0001'0001'0001, kBytes = 0x00FF'00FF'00FF'00FF;
  constexpr unsigned kArea = samples * samples;
  std::uint64_t sum = kOnes * (kArea / 2);
  for (int x = 0; x < samples; ++x) {
    std::uint64_t pixel;
    std::memcpy(&pixel, sums + 4 * x, sizeof pixel);
    sum += pixel;
  }
  if constexpr (std::has_single_bit(kArea)) {
    sum = (sum >> std::countr_zero(kArea)) & kBytes;
  } else {
    std::uint64_t mean = 0;
    for (int bit = 0; bit < 64; bit += 16) mean |= ((sum >> bit & 0xFFFF) / kArea) << bit;
    sum = mean;
  }
  sum = (sum | sum >> 8) & 0x0000'FFFF'0000'FFFF;
  return static_cast<std::uint32_t>(sum | sum >> 16);
}

// Means for a row of pixels: `channels` bytes for each.
template <int samples, int channels>
void average_columns(const std::uint16_t* sums, int width, std::uint8_t* means) {
  // Four bytes are written faster than three; the next pixel covers the last.
  for (int column = 1; column < width; ++column, sums += 4 * samples, means += channels) {
    const std::uint32_t pixel = mean_pixel<samples>(sums);
    std::memcpy(means, &pixel, sizeof pixel);
  }
  const std::uint32_t last = mean_pixel<samples>(sums);
  std::memcpy(means, &last, channels);
}

// Splits a row of means into colour and alpha, taking the background out of the colour: what was drawn is
// mean = alpha colour + (1 - alpha) background.
void uncover(const std::vector<std::uint8_t>& rgba, const ByteColor& background, std::uint8_t* rgb,
             std::uint8_t* alpha) {
  for (std::size_t i = 0; i < rgba.size(); i += 4, rgb += 3) {
    const int cover = rgba[i + 3];
    *alpha++ = rgba[i + 3];
    for (int c = 0; c < 3; ++c) {
      const int drawn = 255 * rgba[i + c] - (255 - cover) * background[c];
      rgb[c] = static_cast<std::uint8_t>(cover ? std::clamp((drawn + cover / 2) / cover, 0, 255) : 0);
    }
  }
}

// Mean of `samples` x `samples` pixels; turns the rows to run from the top.
template <int samples>
void smooth(const DrawnFrame& frame, Image& image) {
  const std::size_t row_bytes = 4 * static_cast<std::size_t>(frame.width) * samples;
  std::vector<std::uint16_t> sums(row_bytes);
  std::vector<std::uint8_t> means(frame.transparent_background ? 4 * static_cast<std::size_t>(frame.width) : 0);
  for (int row = 0; row < frame.height; ++row) {
    const auto below = static_cast<std::size_t>(frame.height - 1 - row);
    sum_rows<samples>(frame.rgba.data() + below * samples * row_bytes, row_bytes, sums.data());
    std::uint8_t* rgb = image.rgb.data() + row * image.row_bytes();
    if (frame.transparent_background) {
      average_columns<samples, 4>(sums.data(), frame.width, means.data());
      uncover(means, *frame.transparent_background, rgb,
              image.alpha.data() + static_cast<std::size_t>(row) * image.width);
    } else {
      average_columns<samples, 3>(sums.data(), frame.width, rgb);
    }
  }
}

}  // namespace

Image smooth_frame(const DrawnFrame& frame, Image used) {
  static constexpr void (*kSmooth[kMostSamples])(const DrawnFrame&, Image&) = {smooth<1>, smooth<2>, smooth<3>,
                                                                               smooth<4>};
  used.width = frame.width;
  used.height = frame.height;
  used.rgb.resize(used.row_bytes() * frame.height);
  used.alpha.resize(frame.transparent_background ? used.rgb.size() / 3 : 0);
  kSmooth[frame.supersampling - 1](frame, used);
  return used;
}

FrameRenderer::FrameRenderer(std::shared_ptr<GlHost> host, const Structure& structure, const FrameOptions& options)
    : options_(checked(options)),
      window_(HostedRenderWindow::make(std::move(host), options.width * options.supersampling,
                                       options.height * options.supersampling)),
      scene_(structure, options.scene) {
  window_->keep_where_drawn();
  window_->AddRenderer(&scene_.renderer());
}

void FrameRenderer::set_view(const CameraView& view) { apply_view(view, *scene_.renderer().GetActiveCamera()); }

DrawnFrame FrameRenderer::draw(const Snapshot& snapshot, DrawnFrame used) {
  scene_.update(snapshot);
  window_->Render();
  used.width = options_.width;
  used.height = options_.height;
  used.supersampling = options_.supersampling;
  used.transparent_background.reset();
  if (options_.scene.transparent_background) {
    used.transparent_background = to_bytes(palette(options_.scene.background).background);
  }
  const std::size_t pixels = static_cast<std::size_t>(options_.width) * options_.height;
  used.rgba.resize(4 * pixels * options_.supersampling * options_.supersampling);
  window_->read_rgba(used.rgba.data());
  return used;
}

}  // namespace netpocket
