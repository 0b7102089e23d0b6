#include "render/report/study_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/base/whole_file.h"
#include "engine/statistics/proportion.h"
#include "engine/study/draft_runs.h"
#include "engine/study/study_manifest.h"
#include "render/figures/drawn_captures.h"
#include "render/figures/figure_file.h"
#include "render/figures/study_figures.h"
#include "render/output/png_file.h"
#include "render/report/html_text.h"
#include "render/report/inline_svg.h"
#include "render/report/study_page_parts.h"

namespace netpocket {
namespace {

using Json = nlohmann::ordered_json;
using Pictures = std::vector<std::pair<std::size_t, std::string>>;
using Figures = std::vector<std::pair<std::string, std::string>>;

constexpr double kShownConfidence = 0.95;
constexpr int kDigits = 5;  // of numbers in the page

// What a reader wants to know of a capture besides its inputs.
const std::vector<std::string> kShownMeasures = {"escape_depth", "smallest_gap", "closed_time",   "first_contact_time",
                                                 "load_body",    "peak_fy_N",    "covered_share", "utilisation_peak"};

// Figures that the map replaces.
bool is_in_the_map(const std::string& figure) { return figure == "scatter_matrix"; }

Json number_json(double value) {
  if (!std::isfinite(value)) return nullptr;
  return std::stod(fmt::format("{:.{}g}", value, kDigits));
}

Json numbers_json(const std::vector<double>& values) {
  Json list = Json::array();
  for (const double value : values) list.push_back(number_json(value));
  return list;
}

Json column_json(const ResultColumn& column) { return {column.name, column.unit, numbers_json(column.values)}; }

std::string picture_id(std::size_t row) { return fmt::format("picture_{}", row); }

// The inputs that decide most.
Json axes_json(const StudyResults& results) {
  std::vector<std::size_t> order;
  for (const InputInfluence& influence : input_influences(results)) order.push_back(influence.input);
  for (std::size_t i = 0; i < results.inputs.size() && order.size() < 2; ++i) order.push_back(i);
  return {order.front(), order[order.size() > 1 ? 1 : 0]};
}

Json study_json(const StudyResults& results, const Pictures& pictures, const Json& axes) {
  Json json = {{"inputs", Json::array()},
               {"measures", Json::array()},
               {"points", numbers_json(results.points)},
               {"captured", numbers_json(results.captured)},
               {"pictures", Json::object()},
               {"axes", axes}};
  for (const ResultColumn& input : results.inputs) json["inputs"].push_back(column_json(input));
  for (const std::string& name : kShownMeasures) {
    if (const ResultColumn* column = results.find(name)) json["measures"].push_back(column_json(*column));
  }
  for (const auto& [row, png] : pictures) json["pictures"][std::to_string(row)] = picture_id(row);
  return json;
}

// "</" would end the script that holds it.
std::string in_script(std::string text) {
  for (std::size_t at = text.find("</"); at != text.npos; at = text.find("</", at + 3)) text.replace(at, 2, "<\\/");
  return text;
}

std::string result_text(const StudyResults& results) {
  const auto captured = std::ranges::count(results.captured, 1.0), missed = std::ranges::count(results.captured, 0.0);
  const std::int64_t judged = captured + missed;
  if (judged == 0) return "<p class=\"result\">No capture was judged.</p>\n";
  const Interval wilson = wilson_interval(captured, judged, kShownConfidence),
                 exact = clopper_pearson_interval(captured, judged, kShownConfidence);
  return fmt::format(
      "<p class=\"result\">Probability of capture <b>{:.4f}</b>, 95 % interval {:.4f} to {:.4f} (Wilson), {:.4f} to "
      "{:.4f} (Clopper-Pearson): {} of {} captured.</p>\n",
      static_cast<double>(captured) / static_cast<double>(judged), wilson.lower, wilson.upper, exact.lower, exact.upper,
      captured, judged);
}

// Captures that the page holds: those with a picture and of the others as many as a map can show.
StudyResults shown_in_page(const StudyResults& results, Pictures& pictures) {
  StudyResults shown;
  const auto copy_columns = [](const std::vector<ResultColumn>& from, std::vector<ResultColumn>& to) {
    for (const ResultColumn& column : from) to.push_back({column.name, column.unit, {}});
  };
  copy_columns(results.inputs, shown.inputs);
  copy_columns(results.measures, shown.measures);
  for (std::size_t row = 0; row < results.size(); ++row) {
    const auto picture = std::ranges::find(pictures, row, &Pictures::value_type::first);
    if (picture == pictures.end() && !is_drawn(row, results.size())) continue;
    if (picture != pictures.end()) picture->first = shown.size();
    shown.points.push_back(results.points[row]);
    shown.captured.push_back(results.captured[row]);
    for (std::size_t i = 0; i < shown.inputs.size(); ++i)
      shown.inputs[i].values.push_back(results.inputs[i].values[row]);
    for (std::size_t i = 0; i < shown.measures.size(); ++i)
      shown.measures[i].values.push_back(results.measures[i].values[row]);
  }
  return shown;
}

std::string map_section(const StudyResults& results) {
  if (results.inputs.empty()) return "";
  const std::string title = title_with_drawn("Captures", results.size());
  return fmt::format("<h2>{}</h2>\n", title) +
         "<p><label>Across <select id=\"across\"></select></label> <label>Up <select id=\"up\"></select></label> "
         "<span class=\"note\">blue: captured, red: missed, ringed: with a picture. A click keeps a capture; left and "
         "right go to the next one.</span></p>\n"
         "<div id=\"chart\"><svg id=\"map\" viewBox=\"0 0 640 490\" role=\"img\" aria-label=\"Map of the captures\" "
         "tabindex=\"0\"></svg><div id=\"about\" aria-live=\"polite\"><p class=\"note\">Point at a capture to see its "
         "values.</p></div></div>\n";
}

std::string outcome_of(double captured) {
  return std::isnan(captured) ? "not judged" : captured == 1 ? "captured" : "missed";
}

std::string pictures_section(const StudyResults& results, const Pictures& pictures) {
  if (pictures.empty()) return "";
  std::string text = "<h2>Worst and typical captures, at their ends</h2>\n<div class=\"sheet\">\n";
  for (const auto& [row, png] : pictures) {
    text += fmt::format(
        "<button data-row=\"{0}\"><img id=\"{1}\" alt=\"Point {2} at its end\" src=\"{3}\">Point {2}: {4}</button>\n",
        row, picture_id(row), results.points[row], data_url("image/png", png), outcome_of(results.captured[row]));
  }
  return text + "</div>\n";
}

std::string figures_section(const Figures& figures) {
  std::string text;
  for (const auto& [name, svg] : figures) text += fmt::format("<figure>\n{}</figure>\n", inline_svg(name, svg));
  return text.empty() ? text : "<h2>Figures</h2>\n" + text;
}

}  // namespace

std::string study_page(const std::string& name, const StudyResults& results, const Pictures& pictures,
                       const Figures& figures, const std::string& drafts) {
  std::string page = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
      "content=\"width=device-width, initial-scale=1\">\n<title>{0}</title>\n<style>{1}</style>\n</head>\n<body>\n"
      "<h1>{0}</h1>\n",
      html_text(name), kStudyPageStyle);
  if (!drafts.empty()) page += fmt::format("<p>{}</p>\n", html_text(drafts));
  Pictures shown_pictures = pictures;
  const StudyResults shown = shown_in_page(results, shown_pictures);
  page += result_text(results) + map_section(results) + pictures_section(shown, shown_pictures);
  page += figures_section(figures);
  if (!results.inputs.empty()) {
    page += fmt::format("<script id=\"data\" type=\"application/json\">{}</script>\n<script>{}</script>\n",
                        in_script(study_json(shown, shown_pictures, axes_json(results)).dump()), kStudyPageScript);
  }
  return page + "</body>\n</html>\n";
}

RenderOutcome write_study_report(const std::string& folder, const std::string& path, const StudyReportOptions& options,
                                 const RenderProgressCallback& progress, const std::stop_token& stop) {
  const StudyResults results = read_study_results(folder);
  std::vector<std::size_t> rows = worst_captures(results, options.ranking, options.worst);
  for (const std::size_t row : typical_captures(results, options.ranking.by, options.typical)) {
    if (std::ranges::find(rows, row) == rows.end()) rows.push_back(row);
  }
  const std::vector<Image> images = draw_captures(folder, results, rows, options.picture, progress, stop);
  if (images.size() < rows.size()) return RenderOutcome::cancelled;
  Pictures pictures;
  for (std::size_t i = 0; i < rows.size(); ++i) pictures.emplace_back(rows[i], png_bytes(images[i]));
  Figures figures;
  for (const std::string& name : suitable_study_figures(results)) {
    if (is_in_the_map(name)) continue;
    figures.emplace_back(name, encode_figure(make_study_figure(name, results), FigureFormat::svg));
  }
  write_whole_file(
      path, FileKind::html,
      study_page(read_study_manifest(folder).study, results, pictures, figures, recorded_drafts_text(folder)));
  return RenderOutcome::finished;
}

}  // namespace netpocket
