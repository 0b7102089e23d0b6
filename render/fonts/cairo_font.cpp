#include "render/fonts/cairo_font.h"

#include <cairo-ft.h>
#include <fontconfig/fontconfig.h>

#include <memory>

namespace netpocket {
namespace {

using Pattern = std::unique_ptr<FcPattern, decltype(&FcPatternDestroy)>;
using Face = std::unique_ptr<cairo_font_face_t, decltype(&cairo_font_face_destroy)>;
using Options = std::unique_ptr<cairo_font_options_t, decltype(&cairo_font_options_destroy)>;

}  // namespace

void use_cairo_font(cairo_t* context, const std::string& file, double size, bool hinted) {
  // Cairo takes a pattern that names a file as it is; it keeps open files to itself.
  const Pattern pattern(FcPatternCreate(), FcPatternDestroy);
  FcPatternAddString(pattern.get(), FC_FILE, reinterpret_cast<const FcChar8*>(file.c_str()));
  FcPatternAddInteger(pattern.get(), FC_INDEX, 0);
  const Face face(cairo_ft_font_face_create_for_pattern(pattern.get()), cairo_font_face_destroy);
  const Options options(cairo_font_options_create(), cairo_font_options_destroy);
  cairo_font_options_set_antialias(options.get(), CAIRO_ANTIALIAS_GRAY);
  cairo_font_options_set_hint_style(options.get(), hinted ? CAIRO_HINT_STYLE_SLIGHT : CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_hint_metrics(options.get(), hinted ? CAIRO_HINT_METRICS_ON : CAIRO_HINT_METRICS_OFF);
  cairo_set_font_face(context, face.get());
  cairo_set_font_size(context, size);
  cairo_set_font_options(context, options.get());
}

}  // namespace netpocket
