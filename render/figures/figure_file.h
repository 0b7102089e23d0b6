#pragma once
// Figures as files.

#include <filesystem>
#include <string>
#include <string_view>

#include "engine/base/file_kind.h"
#include "render/figures/figure.h"
#include "render/figures/figure_error.h"

namespace netpocket {

enum class FigureFormat { png, svg, pdf };

inline constexpr double kPrintResolution = 300;  // dots per inch

// "png", "svg" or "pdf", with or without a leading dot. Throws FigureError on any other name.
FigureFormat figure_format(std::string_view name);
const char* to_string(FigureFormat format);
FileKind file_kind(FigureFormat format);

// The figure as the bytes of a file. `resolution` (dots per inch) matters for PNG only, which also states it inside.
// Text is text in SVG and PDF, which can be searched; PDF embeds the font, SVG names it and one that is as wide.
// Throws FigureError when the picture would be larger than Cairo can make, RenderError when the font is not installed.
std::string encode_figure(const Figure& figure, FigureFormat format, double resolution = kPrintResolution);

// Writes the file in the format of its extension: first under a temporary name in the same directory, so that a reader
// never sees half a figure and a failure leaves an older file alone. Throws FigureError on an unknown format, FileError
// where it cannot be written.
void save_figure(const Figure& figure, const std::filesystem::path& path, double resolution = kPrintResolution);

}  // namespace netpocket
