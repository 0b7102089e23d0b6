#include "render/figures/figure_file.h"

#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <cairo.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>

#include "engine/base/whole_file.h"
#include "render/figures/svg_text.h"
#include "render/fonts/font_file.h"

namespace netpocket {
namespace {

using SurfacePointer = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;
using ContextPointer = std::unique_ptr<cairo_t, decltype(&cairo_destroy)>;

cairo_status_t append(void* closure, const unsigned char* data, unsigned int length) {
  static_cast<std::string*>(closure)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

void require_success(cairo_status_t status, const Figure& figure) {
  if (status == CAIRO_STATUS_SUCCESS) return;
  throw FigureError(fmt::format("cannot draw figure '{}': {}", figure.title, cairo_status_to_string(status)));
}

void draw_onto(const Figure& figure, cairo_surface_t* surface, double width, double height, double scale) {
  require_success(cairo_surface_status(surface), figure);
  const ContextPointer context(cairo_create(surface), &cairo_destroy);
  cairo_scale(context.get(), scale, scale);
  draw_figure(figure, context.get(), width, height);
  require_success(cairo_status(context.get()), figure);
}

std::string big_endian(std::uint32_t value) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>((value >> shift) & 0xff);
  return bytes;
}

// CRC-32 of the PNG specification (ISO 3309).
std::uint32_t checksum(std::string_view bytes) {
  std::uint32_t crc = 0xffffffff;
  for (const char byte : bytes) {
    crc ^= static_cast<unsigned char>(byte);
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ ((crc & 1) != 0 ? 0xedb88320 : 0);
  }
  return ~crc;
}

// Cairo does not say how large a pixel is; without it a program would place the picture several times too large.
void state_resolution(std::string& png, double resolution) {
  constexpr std::size_t kEndOfHeader = 8 + 25;  // signature, IHDR chunk
  const std::string pixels_per_metre = big_endian(static_cast<std::uint32_t>(std::lround(resolution / 0.0254)));
  const std::string chunk = "pHYs" + pixels_per_metre + pixels_per_metre + '\x01';
  png.insert(kEndOfHeader, big_endian(9) + chunk + big_endian(checksum(chunk)));
}

std::string encode_png(const Figure& figure, double resolution) {
  const double scale = resolution / 72;
  const double width = std::round(figure.width() * scale);
  const double height = std::round(figure.height() * scale);
  constexpr double kLargestSide = 32767;  // pixels, limit of Cairo's image surface
  if (!(width >= 1 && height >= 1 && width <= kLargestSide && height <= kLargestSide)) {
    throw FigureError(
        fmt::format("cannot draw figure '{}' with {} dots per inch: a side would have {} pixels, allowed are 1 to {}",
                    figure.title, resolution, std::max(width, height), kLargestSide));
  }
  const SurfacePointer surface(
      cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(width), static_cast<int>(height)),
      &cairo_surface_destroy);
  draw_onto(figure, surface.get(), width / scale, height / scale, scale);  // whole pixels to the edge
  std::string bytes;
  require_success(cairo_surface_write_to_png_stream(surface.get(), append, &bytes), figure);
  state_resolution(bytes, resolution);
  return bytes;
}

using MakeSurface = decltype(&cairo_svg_surface_create_for_stream);

// Draws on a surface that writes into `bytes`, which must stay until the surface is finished.
SurfacePointer make_surface(MakeSurface make, const Figure& figure, std::string& bytes) {
  return {make(append, &bytes, figure.width(), figure.height()), &cairo_surface_destroy};
}

void draw_and_finish(const Figure& figure, cairo_surface_t* surface) {
  draw_onto(figure, surface, figure.width(), figure.height(), 1);
  cairo_surface_finish(surface);
  require_success(cairo_surface_status(surface), figure);
}

std::string encode_svg(const Figure& figure) {
  std::string bytes;
  const auto surface = make_surface(cairo_svg_surface_create_for_stream, figure, bytes);
  const SvgText text(surface.get());
  draw_and_finish(figure, surface.get());
  return text.added_to(std::move(bytes));
}

std::string encode_pdf(const Figure& figure) {
  std::string bytes;
  const auto surface = make_surface(cairo_pdf_surface_create_for_stream, figure, bytes);
  cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_TITLE, figure.title.c_str());
  draw_and_finish(figure, surface.get());
  return bytes;
}

}  // namespace

FigureFormat figure_format(std::string_view name) {
  const std::string_view bare = name.substr(name.starts_with('.') ? 1 : 0);
  for (const FigureFormat format : {FigureFormat::png, FigureFormat::svg, FigureFormat::pdf}) {
    if (bare == to_string(format)) return format;
  }
  throw FigureError(fmt::format("unknown figure format '{}': allowed are png, svg and pdf", bare));
}

const char* to_string(FigureFormat format) {
  switch (format) {
    case FigureFormat::svg:
      return "svg";
    case FigureFormat::pdf:
      return "pdf";
    case FigureFormat::png:
      break;
  }
  return "png";
}

FileKind file_kind(FigureFormat format) {
  switch (format) {
    case FigureFormat::svg:
      return FileKind::svg;
    case FigureFormat::pdf:
      return FileKind::pdf;
    case FigureFormat::png:
      break;
  }
  return FileKind::png;
}

std::string encode_figure(const Figure& figure, FigureFormat format, double resolution) {
  font_file();  // SVG files name it without looking for it
  if (format == FigureFormat::svg) return encode_svg(figure);
  return format == FigureFormat::pdf ? encode_pdf(figure) : encode_png(figure, resolution);
}

void save_figure(const Figure& figure, const std::filesystem::path& path, double resolution) {
  const FigureFormat format = figure_format(path.extension().string());
  write_whole_file(path.string(), file_kind(format), encode_figure(figure, format, resolution));
}

}  // namespace netpocket
