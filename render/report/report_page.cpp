#include "render/report/report_page.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>

#include "engine/analysis/run_labels.h"
#include "engine/analysis/summary.h"
#include "render/report/html_text.h"
#include "render/report/inline_svg.h"

namespace netpocket {
namespace {

using Recordings = std::vector<const Recording*>;

constexpr const char* kStyle = R"(
  :root { color-scheme: light; }
  body { font: 16px/1.5 "DejaVu Sans", "Segoe UI", Helvetica, Arial, sans-serif; color: #1a1c21; background: #fff;
         max-width: 1100px; margin: 2rem auto; padding: 0 1.5rem; }
  h1 { font-size: 1.7rem; margin-bottom: 0.2rem; }
  h2 { font-size: 1.2rem; margin-top: 2.4rem; border-bottom: 1px solid #d5d8de; padding-bottom: 0.3rem; }
  .origin { color: #5a606b; font-size: 0.9rem; }
  table { border-collapse: collapse; width: 100%; font-size: 0.88rem; }
  th, td { text-align: left; vertical-align: top; padding: 0.35rem 0.7rem 0.35rem 0; border-bottom: 1px solid #e4e6ea; }
  td.number { font-variant-numeric: tabular-nums; }
  .holds { color: #00664a; font-weight: bold; }
  .fails { color: #a33b00; font-weight: bold; }
  .open { color: #5a606b; font-weight: bold; }
  .rule { color: #5a606b; font-size: 0.8rem; }
  figure { margin: 1.4rem 0; }
  img, svg, video { max-width: 100%; height: auto; display: block; }
  svg { width: 900px; }
  video { border: 1px solid #d5d8de; }
  pre { background: #f5f6f8; padding: 1rem; overflow-x: auto; font: 0.8rem/1.45 "DejaVu Sans Mono", monospace; }
  summary { cursor: pointer; margin: 0.4rem 0; }
  @media print { details > pre { white-space: pre-wrap; } figure, tr { break-inside: avoid; } }
)";

std::vector<std::string> html_names(const Recordings& recordings) {
  std::vector<std::string> names;
  for (const std::string& label : run_labels(recordings)) names.push_back(html_text(label));
  return names;
}

std::string header_cells(const Recordings& recordings) {
  std::string cells;
  for (const std::string& name : html_names(recordings)) cells += fmt::format("<th scope=\"col\">{}</th>", name);
  return cells;
}

struct KeyFigure {
  const char* label;
  std::function<std::string(const Recording&, const RunSummary&)> text;
};

std::string vector_text(const Eigen::Vector3d& v) { return fmt::format("{:.4g}, {:.4g}, {:.4g}", v.x(), v.y(), v.z()); }

std::string ending(const Recording& recording) {
  const auto& status = recording.status();
  return fmt::format("{} at t = {:.6g} s", to_string(status.reason), status.time);
}

const std::vector<KeyFigure>& key_figures() {
  static const std::vector<KeyFigure> figures = {
      {"Run", [](const auto& r, const auto&) { return ending(r); }},
      {"Target captured", [](const auto&, const auto& s) { return std::string(to_string(s.captured)); }},
      {"First contact",
       [](const auto&, const auto& s) {
         return s.first_contact_time ? fmt::format("{:.4g} s", *s.first_contact_time) : std::string("none");
       }},
      {"Largest force on the target x, y, z (N)",
       [](const auto&, const auto& s) {
         return fmt::format("{}; y at {:.4g} s, means over {:.3g} s", vector_text(s.peak_force), s.peak_time_y,
                            s.averaging_window);
       }},
      {"Impulse on the target x, y, z (N\u2009s)", [](const auto&, const auto& s) { return vector_text(s.impulse); }},
      {"Energy error",
       [](const auto&, const auto& s) { return energy_error_text(s.energy_error_joules, s.energy_put_in); }},
      {"Model",
       [](const auto& r, const auto&) {
         const auto& n = r.statistics();
         return fmt::format("{} elements, {} coordinates, step {:.3g} s", n.elements, n.coordinates, n.time_step);
       }},
      {"Made by",
       [](const auto& r, const auto&) {
         return fmt::format("netpocket {} ({})", r.origin().netpocket_version, r.origin().commit);
       }},
  };
  return figures;
}

std::string summary_table(const Recordings& recordings) {
  std::vector<RunSummary> summaries;
  for (const auto* recording : recordings) summaries.push_back(summarize(*recording));
  std::string rows;
  if (std::ranges::any_of(recordings, [](const auto* recording) { return !recording->origin().draft.empty(); })) {
    rows += "<tr><th scope=\"row\">Draft</th>";
    for (const auto* recording : recordings) {
      const std::string& draft = recording->origin().draft;
      rows += fmt::format("<td>{}</td>", draft.empty() ? "no" : html_text(draft));
    }
    rows += "</tr>\n";
  }
  for (const auto& figure : key_figures()) {
    rows += fmt::format("<tr><th scope=\"row\">{}</th>", figure.label);
    for (std::size_t i = 0; i < recordings.size(); ++i) {
      rows += fmt::format("<td class=\"number\">{}</td>", html_text(figure.text(*recordings[i], summaries[i])));
    }
    rows += "</tr>\n";
  }
  return fmt::format("<table>\n<tr><th></th>{}</tr>\n{}</table>\n", header_cells(recordings), rows);
}

const char* verdict_class(Verdict verdict) {
  if (verdict == Verdict::yes) return "holds";
  return verdict == Verdict::no ? "fails" : "open";
}

std::string findings_table(const Recordings& recordings) {
  std::string rows;
  for (const auto& finding : evaluate_findings(recordings)) {
    rows += fmt::format("<tr><th scope=\"row\">{}</th><td>{}<div class=\"rule\">{}</div></td>", html_text(finding.id),
                        html_text(finding.text), html_text(finding.rule));
    for (const auto& found : finding.cases) {
      rows += fmt::format("<td><span class=\"{}\">{}</span><br>{}</td>", verdict_class(found.verdict),
                          to_string(found.verdict), html_text(found.value));
    }
    rows += "</tr>\n";
  }
  return fmt::format("<table>\n<tr><th></th><th scope=\"col\">Finding and how it is decided</th>{}</tr>\n{}</table>\n",
                     header_cells(recordings), rows);
}

std::string figure_block(const std::string& name, const std::string& svg) {
  return fmt::format("<figure id=\"{}\">{}</figure>\n", html_text(name), inline_svg(name, svg));
}

std::string scenario_block(const std::string& name, const Recording& recording) {
  return fmt::format("<details><summary>{}</summary><pre>{}</pre></details>\n", name,
                     html_text(recording.origin().scenario_text));
}

}  // namespace

std::string report_page(const Recordings& recordings, const ReportMedia& media) {
  const std::vector<std::string> names = html_names(recordings);
  const std::string title = fmt::format("{}", fmt::join(names, "; "));
  std::string page = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<title>Capture by a netted pocket: {}</title>\n<style>{}</style>\n</head>\n<body>\n"
      "<h1>Capture by a netted pocket: {}</h1>\n"
      "<p class=\"origin\">Simulated and written by netpocket; the findings are those of Tang et al., Appl. Sci. 2023, "
      "13, 10377.</p>\n",
      title, kStyle, title);
  page += "<h2>Results</h2>\n" + summary_table(recordings);
  page += fmt::format(
      "<h2>Capture</h2>\n<figure id=\"sheet\"><img alt=\"the capture, step by step\" src=\"{}\"></figure>\n",
      data_url("image/png", media.sheet));
  if (!media.video.empty()) {
    page += fmt::format("<figure id=\"video\"><video controls loop muted src=\"{}\"></video></figure>\n",
                        data_url("video/mp4", media.video));
  }
  page += "<h2>Findings</h2>\n" + findings_table(recordings);
  page += "<h2>Figures</h2>\n";
  for (const auto& [name, svg] : media.figures) page += figure_block(name, svg);
  page += "<h2>Scenarios</h2>\n";
  for (std::size_t i = 0; i < recordings.size(); ++i) page += scenario_block(names[i], *recordings[i]);
  return page + "</body>\n</html>\n";
}

}  // namespace netpocket
