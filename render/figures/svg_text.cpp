#include "render/figures/svg_text.h"

#include <fmt/format.h>

#include <cmath>
#include <string_view>

namespace netpocket {
namespace {

const cairo_user_data_key_t kTaker = {};

// Where DejaVu Sans is not installed, the font whose letters are as wide.
constexpr const char* kFontFamilies = "DejaVu Sans, Bitstream Vera Sans, Verdana, sans-serif";

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '&') {
      result += "&amp;";
    } else if (c == '<') {
      result += "&lt;";
    } else {
      result += c;
    }
  }
  return result;
}

std::string hexadecimal(const FigureColour& colour) {
  const auto byte = [](double value) { return std::lround(255 * value); };
  return fmt::format("#{:02x}{:02x}{:02x}", byte(colour.red), byte(colour.green), byte(colour.blue));
}

const char* anchor(TextAlign align) {
  if (align == TextAlign::left) return "start";
  return align == TextAlign::centre ? "middle" : "end";
}

// The place as attributes: by a matrix when the text is turned, too.
std::string placed(cairo_t* context, double x, double y) {
  cairo_matrix_t m;
  cairo_get_matrix(context, &m);
  if (m.yx == 0 && m.xx == 1) return fmt::format("x=\"{:.2f}\" y=\"{:.2f}\"", m.x0 + x, m.y0 + y);
  return fmt::format("transform=\"matrix({:.4g} {:.4g} {:.4g} {:.4g} {:.2f} {:.2f})\" x=\"{:.2f}\" y=\"{:.2f}\"", m.xx,
                     m.yx, m.xy, m.yy, m.x0, m.y0, x, y);
}

// `drop` (points, downwards): how far the run before stands from the baseline; becomes this run's.
std::string run_element(const TextRun& run, const TextStyle& style, double& drop) {
  const double own_drop = baseline_shift(run, style);
  std::string attributes;
  if (run.italic) attributes += " font-style=\"italic\"";
  if (run.script != 0) attributes += fmt::format(" font-size=\"{:.2f}\"", font_size(run, style));
  if (own_drop != drop) attributes += fmt::format(" dy=\"{:.2f}\"", own_drop - drop);
  drop = own_drop;
  if (attributes.empty()) return escaped(run.text);
  return fmt::format("<tspan{}>{}</tspan>", attributes, escaped(run.text));
}

}  // namespace

SvgText::SvgText(cairo_surface_t* surface) { cairo_surface_set_user_data(surface, &kTaker, this, nullptr); }

SvgText* SvgText::of(cairo_t* context) {
  return static_cast<SvgText*>(cairo_surface_get_user_data(cairo_get_target(context), &kTaker));
}

void SvgText::add(cairo_t* context, const std::vector<TextRun>& runs, const TextStyle& style, double x, double y,
                  TextAlign align) {
  if (runs.empty()) return;
  elements_ +=
      fmt::format("<text {} font-size=\"{:.2f}\" text-anchor=\"{}\" fill=\"{}\"{}>", placed(context, x, y), style.size,
                  anchor(align), hexadecimal(style.colour), style.bold ? " font-weight=\"bold\"" : "");
  double drop = 0;
  for (const TextRun& run : runs) elements_ += run_element(run, style, drop);
  elements_ += "</text>\n";
}

std::string SvgText::added_to(std::string svg) const {
  const auto end = svg.rfind("</svg>");
  if (end == std::string::npos) return svg;
  return svg.insert(end,
                    fmt::format("<g font-family=\"{}\" xml:space=\"preserve\">\n{}</g>\n", kFontFamilies, elements_));
}

}  // namespace netpocket
