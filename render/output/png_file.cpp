#include "render/output/png_file.h"

#include <fmt/format.h>
#include <isa-l/crc.h>
#include <isa-l/igzip_lib.h>
#include <spng.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <string_view>

#include "engine/base/whole_file.h"
#include "render/render_error.h"

namespace netpocket {
namespace {

using Context = std::unique_ptr<spng_ctx, decltype(&spng_ctx_free)>;
using File = std::unique_ptr<std::FILE, decltype(&std::fclose)>;

using Bytes = std::vector<std::uint8_t>;

constexpr std::string_view kCommentKey = "Comment";

void append_word(Bytes& bytes, std::uint32_t word) {
  for (const int shift : {24, 16, 8, 0}) bytes.push_back(static_cast<std::uint8_t>(word >> shift));
}

void put_word(std::uint8_t* place, std::uint32_t word) {
  for (const int shift : {24, 16, 8, 0}) *place++ = static_cast<std::uint8_t>(word >> shift);
}

// A chunk of the format is length, type, data, checksum of type and data. Begins one; where it begins.
std::size_t begin_chunk(Bytes& file, std::string_view type) {
  const auto start = file.size();
  append_word(file, 0);
  file.insert(file.end(), type.begin(), type.end());
  return start;
}

// The data of the chunk is what has been appended since.
void end_chunk(Bytes& file, std::size_t start) {
  const auto type_and_data = start + 4;
  put_word(file.data() + start, static_cast<std::uint32_t>(file.size() - type_and_data - 4));
  append_word(file, crc32_gzip_refl(0, file.data() + type_and_data, file.size() - type_and_data));
}

void append_header(Bytes& file, const Image& image) {
  constexpr std::uint8_t kBitDepth = 8, kTrueColor = 2, kWithAlpha = 6, kDeflate = 0, kAdaptive = 0, kNotInterlaced = 0;
  const auto chunk = begin_chunk(file, "IHDR");
  append_word(file, static_cast<std::uint32_t>(image.width));
  append_word(file, static_cast<std::uint32_t>(image.height));
  file.insert(file.end(),
              {kBitDepth, image.alpha.empty() ? kTrueColor : kWithAlpha, kDeflate, kAdaptive, kNotInterlaced});
  end_chunk(file, chunk);
}

// Text: keyword, a zero, text.
void append_comment(Bytes& file, const std::string& comment) {
  const auto chunk = begin_chunk(file, "tEXt");
  file.insert(file.end(), kCommentKey.begin(), kCommentKey.end());
  file.push_back(0);
  file.insert(file.end(), comment.begin(), comment.end());
  end_chunk(file, chunk);
}

// Rows as they are, each preceded by the number of the filter "none": pictures of thin lines on a plain ground repeat
// pixels and rows, and differences repeat less.
void arrange_rows(const Image& image, Bytes& rows) {
  constexpr std::uint8_t kNoFilter = 0;
  const std::size_t width = static_cast<std::size_t>(image.width), channels = image.alpha.empty() ? 3 : 4;
  rows.resize((channels * width + 1) * static_cast<std::size_t>(image.height));
  std::uint8_t* out = rows.data();
  const std::uint8_t *rgb = image.rgb.data(), *alpha = image.alpha.data();
  for (int row = 0; row < image.height; ++row, rgb += 3 * width) {
    *out++ = kNoFilter;
    if (channels == 3) {
      out = std::copy_n(rgb, 3 * width, out);
      continue;
    }
    for (std::size_t i = 0; i < width; ++i) {
      out = std::copy_n(rgb + 3 * i, 3, out);
      *out++ = *alpha++;
    }
  }
}

// Appends the bytes in zlib's format. ISA-L takes a seventh of the time of libdeflate's or zlib's fastest level.
void append_compressed(Bytes& file, Bytes& bytes) {
  Bytes memory(ISAL_DEF_LVL1_DEFAULT);
  isal_zstream stream;
  isal_deflate_init(&stream);
  stream.gzip_flag = IGZIP_ZLIB;
  stream.level = 1;
  stream.level_buf = memory.data();
  stream.level_buf_size = static_cast<std::uint32_t>(memory.size());
  stream.end_of_stream = 1;
  stream.next_in = bytes.data();
  stream.avail_in = static_cast<std::uint32_t>(bytes.size());
  while (stream.internal_state.state != ZSTATE_END) {
    const auto size = file.size();
    constexpr std::size_t kStep = 1 << 20;
    file.resize(size + kStep);
    stream.next_out = file.data() + size;
    stream.avail_out = kStep;
    if (isal_deflate(&stream) != COMP_OK) throw std::logic_error("ISA-L cannot compress a picture");
    file.erase(file.end() - stream.avail_out, file.end());
  }
}

// The format (ISO/IEC 15948) written directly: several times as fast as through a PNG library on zlib.
void encode(const Image& image, const std::string& comment, Bytes& pixels, Bytes& file) {
  file.assign({0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'});
  append_header(file, image);
  if (!comment.empty()) append_comment(file, comment);
  arrange_rows(image, pixels);
  const auto chunk = begin_chunk(file, "IDAT");
  append_compressed(file, pixels);
  end_chunk(file, chunk);
  end_chunk(file, begin_chunk(file, "IEND"));
}

File open_file(const std::string& path) {
  return {std::fopen(path.c_str(), "rb"), [](std::FILE* open) { return open ? std::fclose(open) : 0; }};
}

}  // namespace

void PngWriter::write(const Image& image, const std::string& path, const std::string& comment) {
  encode(image, comment, pixels_, file_);
  write_whole_file(path, FileKind::png, {reinterpret_cast<const char*>(file_.data()), file_.size()});
}

std::string png_bytes(const Image& image) {
  Bytes pixels, file;
  encode(image, {}, pixels, file);
  return {file.begin(), file.end()};
}

void write_png(const Image& image, const std::string& path, const std::string& comment) {
  PngWriter().write(image, path, comment);
}

Image read_png(const std::string& path) {
  const File stream = open_file(path);
  if (!stream) throw RenderError(fmt::format("cannot read {}: {}", path, std::strerror(errno)));
  const Context context(spng_ctx_new(0), spng_ctx_free);
  spng_set_png_file(context.get(), stream.get());
  spng_ihdr header = {};
  std::size_t size = 0;
  int error = spng_get_ihdr(context.get(), &header);
  const bool with_alpha = (header.color_type & SPNG_COLOR_TYPE_GRAYSCALE_ALPHA) != 0;
  const auto format = with_alpha ? SPNG_FMT_RGBA8 : SPNG_FMT_RGB8;
  if (!error) error = spng_decoded_image_size(context.get(), format, &size);
  Bytes pixels(size);
  if (!error) error = spng_decode_image(context.get(), pixels.data(), size, format, 0);
  if (error) throw RenderError(fmt::format("cannot read {}: {}", path, spng_strerror(error)));
  Image image{static_cast<int>(header.width), static_cast<int>(header.height), {}};
  if (!with_alpha) {
    image.rgb = std::move(pixels);
    return image;
  }
  for (std::size_t i = 0; i < size; i += 4) {
    image.rgb.insert(image.rgb.end(), pixels.begin() + i, pixels.begin() + i + 3);
    image.alpha.push_back(pixels[i + 3]);
  }
  return image;
}

std::optional<std::string> png_comment(const std::string& path) {
  const File stream = open_file(path);
  if (!stream) return std::nullopt;
  const Context context(spng_ctx_new(0), spng_ctx_free);
  spng_set_png_file(context.get(), stream.get());
  std::uint32_t count = 0;
  if (spng_get_text(context.get(), nullptr, &count) != 0) return std::nullopt;
  std::vector<spng_text> texts(count);
  if (spng_get_text(context.get(), texts.data(), &count) != 0) return std::nullopt;
  for (const auto& text : texts) {
    if (text.keyword == kCommentKey) return std::string(text.text, text.length);
  }
  return std::nullopt;
}

}  // namespace netpocket
