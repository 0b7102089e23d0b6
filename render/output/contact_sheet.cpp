#include "render/output/contact_sheet.h"

#include <cairo.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <sstream>

#include "render/fonts/cairo_font.h"
#include "render/fonts/drawable_text.h"
#include "render/fonts/shortened.h"
#include "render/render_error.h"

namespace netpocket {
namespace {

using Surface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;
using Context = std::unique_ptr<cairo_t, decltype(&cairo_destroy)>;

// Cairo's pixels are words 0x00RRGGBB, its rows may be padded.
std::uint32_t* row_of(cairo_surface_t* surface, int row) {
  return reinterpret_cast<std::uint32_t*>(cairo_image_surface_get_data(surface) +
                                          static_cast<std::ptrdiff_t>(row) * cairo_image_surface_get_stride(surface));
}

void copy_panel(const Image& image, cairo_surface_t* surface, int left, int top) {
  const std::uint8_t* rgb = image.rgb.data();
  for (int y = 0; y < image.height; ++y) {
    std::uint32_t* pixel = row_of(surface, top + y) + left;
    for (int x = 0; x < image.width; ++x, rgb += 3) {
      *pixel++ = static_cast<std::uint32_t>(rgb[0]) << 16 | static_cast<std::uint32_t>(rgb[1]) << 8 | rgb[2];
    }
  }
}

Image to_image(cairo_surface_t* surface) {
  Image image{cairo_image_surface_get_width(surface), cairo_image_surface_get_height(surface), {}};
  image.rgb.reserve(image.row_bytes() * image.height);
  for (int y = 0; y < image.height; ++y) {
    const std::uint32_t* pixel = row_of(surface, y);
    for (int x = 0; x < image.width; ++x, ++pixel) {
      for (const int shift : {16, 8, 0}) image.rgb.push_back(static_cast<std::uint8_t>(*pixel >> shift));
    }
  }
  return image;
}

struct CaptionStyle {
  double size;   // pixels
  double width;  // pixels, that there are
  bool bold = false;
};

double advance(cairo_t* context, const std::string& text) {
  cairo_text_extents_t extents;
  cairo_text_extents(context, text.c_str(), &extents);
  return extents.x_advance;
}

// Long captions are written in smaller letters; beyond that their ends are left out.
void draw_caption(cairo_t* context, const std::string& caption, const CaptionStyle& style, double center,
                  double baseline) {
  constexpr double kSmallest = 0.7;
  const DrawableText drawable = drawable_text(caption, {.bold = style.bold});
  use_cairo_font(context, drawable.font, style.size, true);
  const double needed = advance(context, drawable.text);
  if (needed > style.width) {
    use_cairo_font(context, drawable.font, style.size * std::max(kSmallest, style.width / needed), true);
  }
  const std::string text =
      shortened(drawable.text, [&](const std::string& part) { return advance(context, part) <= style.width; });
  cairo_move_to(context, center - advance(context, text) / 2, baseline);
  cairo_show_text(context, text.c_str());
}

std::vector<std::string> lines_of(const std::string& caption) {
  std::vector<std::string> lines;
  std::istringstream text(caption);
  for (std::string line; std::getline(text, line);) lines.push_back(line);
  return lines;
}

int most_lines(const std::vector<SheetPanel>& panels) {
  std::size_t most = 1;
  for (const SheetPanel& panel : panels) most = std::max(most, lines_of(panel.caption).size());
  return static_cast<int>(most);
}

}  // namespace

int balanced_columns(int panels, double aspect) {
  constexpr double kBestAspect = 16.0 / 9, kAspectWeight = 0.5;
  const auto cost = [&](int columns) {
    const int rows = (panels + columns - 1) / columns;
    const double empty = static_cast<double>(rows * columns - panels) / columns;
    return empty + kAspectWeight * std::abs(std::log(columns * aspect / (rows * kBestAspect)));
  };
  int best = 1;
  for (int columns = 2; columns <= panels; ++columns) {
    if (cost(columns) < cost(best)) best = columns;
  }
  return best;
}

Image make_contact_sheet(const std::vector<SheetPanel>& panels, const SheetLayout& layout) {
  if (panels.empty() || layout.columns < 1) throw RenderError("a contact sheet needs a picture and a column");
  const int count = static_cast<int>(panels.size()), columns = std::min(layout.columns, count);
  const int rows = (count + columns - 1) / columns;
  int width = 0, height = 0;
  for (const auto& panel : panels) {
    width = std::max(width, panel.image.width);
    height = std::max(height, panel.image.height);
  }
  const int line_height = layout.caption_size * 6 / 5;
  const int caption_height = layout.caption_size * 3 / 2 + line_height * (most_lines(panels) - 1);
  const int step_x = width + layout.margin, step_y = height + caption_height + layout.margin;
  const int head = layout.margin + (layout.headings.empty() ? 0 : 2 * layout.caption_size);

  const Surface surface(
      cairo_image_surface_create(CAIRO_FORMAT_RGB24, layout.margin + columns * step_x, head + rows * step_y),
      cairo_surface_destroy);
  if (cairo_surface_status(surface.get()) != CAIRO_STATUS_SUCCESS) {
    throw RenderError(fmt::format("a contact sheet of {}x{} panels is too large", columns, rows));
  }
  const Context context(cairo_create(surface.get()), cairo_destroy);
  cairo_set_source_rgb(context.get(), 1, 1, 1);
  cairo_paint(context.get());
  cairo_set_source_rgb(context.get(), 0.1, 0.11, 0.13);
  const CaptionStyle heading{1.2 * layout.caption_size, static_cast<double>(width), true};
  const CaptionStyle caption_style{static_cast<double>(layout.caption_size), static_cast<double>(width)};
  for (int i = 0; i < std::min(columns, static_cast<int>(layout.headings.size())); ++i) {
    draw_caption(context.get(), layout.headings[i], heading, layout.margin + i * step_x + width / 2.0,
                 layout.margin + 1.2 * layout.caption_size);
  }
  for (int i = 0; i < count; ++i) {
    const auto& [image, caption] = panels[i];
    const int left = layout.margin + i % columns * step_x + (width - image.width) / 2;
    const int top = head + i / columns * step_y;
    cairo_surface_flush(surface.get());
    copy_panel(image, surface.get(), left, top);
    cairo_surface_mark_dirty(surface.get());
    if (layout.caption_size == 0) continue;
    double baseline = top + height + 1.15 * layout.caption_size;
    for (const std::string& line : lines_of(caption)) {
      draw_caption(context.get(), line, caption_style, left + image.width / 2.0, baseline);
      baseline += line_height;
    }
  }
  cairo_surface_flush(surface.get());
  return to_image(surface.get());
}

}  // namespace netpocket
