#include "render/output/png_file.h"

#include <fmt/format.h>
#include <spng.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include "render/output/whole_file.h"
#include "render/render_error.h"

namespace netpocket {
namespace {

using Context = std::unique_ptr<spng_ctx, decltype(&spng_ctx_free)>;
using File = std::unique_ptr<std::FILE, decltype(&std::fclose)>;

// Pictures of thin lines on a plain ground: level 1 without a search for filters takes a third of the default's time
// for files a tenth larger.
constexpr int kCompressionLevel = 1;

std::vector<std::uint8_t> encode(const Image& image, const std::string& path) {
  const Context context(spng_ctx_new(SPNG_CTX_ENCODER), spng_ctx_free);
  spng_ihdr header = {};
  header.width = static_cast<std::uint32_t>(image.width);
  header.height = static_cast<std::uint32_t>(image.height);
  header.bit_depth = 8;
  header.color_type = SPNG_COLOR_TYPE_TRUECOLOR;
  spng_set_option(context.get(), SPNG_ENCODE_TO_BUFFER, 1);
  spng_set_option(context.get(), SPNG_IMG_COMPRESSION_LEVEL, kCompressionLevel);
  spng_set_option(context.get(), SPNG_FILTER_CHOICE, SPNG_FILTER_CHOICE_UP);
  spng_set_ihdr(context.get(), &header);
  int error = spng_encode_image(context.get(), image.rgb.data(), image.rgb.size(), SPNG_FMT_PNG, SPNG_ENCODE_FINALIZE);
  std::size_t size = 0;
  const std::unique_ptr<void, decltype(&std::free)> bytes(
      error ? nullptr : spng_get_png_buffer(context.get(), &size, &error), std::free);
  if (!bytes) throw RenderError(fmt::format("cannot make the picture {}: {}", path, spng_strerror(error)));
  const auto* first = static_cast<const std::uint8_t*>(bytes.get());
  return {first, first + size};
}

}  // namespace

void write_png(const Image& image, const std::string& path) {
  const auto bytes = encode(image, path);
  WholeFile file(path);
  const File stream(std::fopen(file.temporary_path().c_str(), "wb"), std::fclose);
  if (!stream || std::fwrite(bytes.data(), 1, bytes.size(), stream.get()) != bytes.size() ||
      std::fflush(stream.get()) != 0) {
    throw RenderError(fmt::format("cannot write {}: {}", path, std::strerror(errno)));
  }
  file.commit();
}

Image read_png(const std::string& path) {
  const File stream(std::fopen(path.c_str(), "rb"), [](std::FILE* open) { return open ? std::fclose(open) : 0; });
  if (!stream) throw RenderError(fmt::format("cannot read {}: {}", path, std::strerror(errno)));
  const Context context(spng_ctx_new(0), spng_ctx_free);
  spng_set_png_file(context.get(), stream.get());
  spng_ihdr header = {};
  std::size_t size = 0;
  int error = spng_get_ihdr(context.get(), &header);
  if (!error) error = spng_decoded_image_size(context.get(), SPNG_FMT_RGB8, &size);
  Image image;
  if (!error) {
    image = {static_cast<int>(header.width), static_cast<int>(header.height), std::vector<std::uint8_t>(size)};
    error = spng_decode_image(context.get(), image.rgb.data(), size, SPNG_FMT_RGB8, 0);
  }
  if (error) throw RenderError(fmt::format("cannot read {}: {}", path, spng_strerror(error)));
  return image;
}

}  // namespace netpocket
