#pragma once
// Text of an SVG file as text, to be searched, selected and edited. Cairo's SVG surfaces turn letters into outlines; so
// what is written on such a surface is set aside and added to the file as <text> elements.

#include <cairo.h>

#include <string>
#include <vector>

#include "render/figures/rich_text.h"

namespace netpocket {

class SvgText {
 public:
  // From now on takes what draw_text() writes on the surface, which must not outlive it.
  explicit SvgText(cairo_surface_t* surface);
  SvgText(const SvgText&) = delete;
  SvgText& operator=(const SvgText&) = delete;

  // The one that takes what is written with a context; null: nobody does.
  static SvgText* of(cairo_t* context);

  // As draw_text().
  void add(cairo_t* context, const std::vector<TextRun>& runs, const TextStyle& style, double x, double y,
           TextAlign align);

  // The surface's file with the text in front of everything else.
  std::string added_to(std::string svg) const;

 private:
  std::string elements_;
};

}  // namespace netpocket
