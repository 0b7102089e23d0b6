#pragma once
// The numbers of a figure as a table, for whoever draws it elsewhere.

#include <filesystem>
#include <string>

#include "render/figures/figure.h"

namespace netpocket {

// CSV (RFC 4180): the header panel,title,curve,x_axis,x,y_axis,y, then a line for each point of each curve, in the
// order in which they are drawn. `panel` counts from 1, row by row. Axes are named with their units, without markup.
// Where an axis has names instead of numbers, so has its column. Numbers have the fewest digits that read back to the
// same double, times without the rounding errors of summation; a point that is not finite is a gap of the curve and is
// left out.
std::string figure_csv(const Figure& figure);

// Writes the table; only a whole file is left. Throws FileError.
void save_figure_csv(const Figure& figure, const std::filesystem::path& path);

// The table's place beside a figure: its name with the suffix .csv.
std::filesystem::path table_beside(const std::filesystem::path& figure);

}  // namespace netpocket
