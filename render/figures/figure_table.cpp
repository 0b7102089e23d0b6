#include "render/figures/figure_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/base/whole_file.h"
#include "engine/state/written_time.h"
#include "render/figures/rich_text.h"

namespace netpocket {
namespace {

std::string without_markup(const std::string& text) {
  std::string plain;
  for (const TextRun& run : parse_rich_text(text)) {
    plain += run.script < 0 ? "_" + run.text : run.script > 0 ? "^" + run.text : run.text;
  }
  return plain;
}

// In quotes where a comma, a quote or the end of a line is in it.
std::string cell(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == text.npos) return text;
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + '"';
}

std::string value_cell(const PanelAxis& axis, double value) {
  const auto name = std::ranges::find_if(axis.names, [&](const NamedTick& tick) { return tick.value == value; });
  if (name != axis.names.end()) return cell(without_markup(name->name));
  return fmt::format("{}", axis.title.starts_with("Time") ? written_time(value) : value);
}

std::string curve_name(const Curve& curve, std::size_t index) {
  if (!curve.name.empty()) return curve.name;
  return curve.label.empty() ? fmt::format("curve {}", index + 1) : without_markup(curve.label);
}

void add_curve(std::string& table, const std::string& panel_cells, const Panel& panel, const std::string& name,
               const Curve& curve) {
  const std::string start = fmt::format("{},{},{},", panel_cells, cell(name), cell(without_markup(panel.x.title)));
  const std::string middle = fmt::format(",{},", cell(without_markup(panel.y.title)));
  for (std::size_t i = 0; i < std::min(curve.x.size(), curve.y.size()); ++i) {
    if (!std::isfinite(curve.x[i]) || !std::isfinite(curve.y[i])) continue;
    table += start + value_cell(panel.x, curve.x[i]) + middle + value_cell(panel.y, curve.y[i]) + '\n';
  }
}

}  // namespace

std::string figure_csv(const Figure& figure) {
  std::string table = "panel,title,curve,x_axis,x,y_axis,y\n";
  for (std::size_t i = 0; i < figure.panels.size(); ++i) {
    const Panel& panel = figure.panels[i];
    const std::string panel_cells = fmt::format("{},{}", i + 1, cell(without_markup(panel.title)));
    for (std::size_t c = 0; c < panel.curves.size(); ++c) {
      add_curve(table, panel_cells, panel, curve_name(panel.curves[c], c), panel.curves[c]);
    }
  }
  return table;
}

void save_figure_csv(const Figure& figure, const std::filesystem::path& path) {
  write_whole_file(path.string(), FileKind::csv, figure_csv(figure));
}

std::filesystem::path table_beside(const std::filesystem::path& figure) {
  auto path = figure;
  return path.replace_extension(".csv");
}

}  // namespace netpocket
