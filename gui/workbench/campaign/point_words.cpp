#include "gui/workbench/campaign/point_words.h"

#include <QCoreApplication>
#include <QStringList>
#include <cmath>

#include "engine/statistics/proportion.h"
#include "gui/workbench/editor/parameter_words.h"

namespace netpocket {
namespace {

constexpr double kConfidence = 0.95;

// Columns that tell most of a capture, as far as there are any.
constexpr const char* kTelling[] = {"escape_depth",     "smallest_gap", "closed_time",
                                    "utilisation_peak", "load_body",    "peak_fy_N"};

struct PointWords {
  Q_DECLARE_TR_FUNCTIONS(PointWords)
};

QString value_row(const ResultColumn& column, std::size_t row) {
  const double value = column.values[row];
  if (std::isnan(value)) return {};
  const QString number = QString::number(value, 'g', 4).replace('-', QChar(0x2212));
  const QString unit = column.unit == "1" ? QString() : unit_words(column.unit);
  return QString("<tr><td>%1&nbsp;&nbsp;</td><td align='right'>%2</td><td>&nbsp;%3</td></tr>")
      .arg(from_utf8(column.name).toHtmlEscaped(), number, unit.toHtmlEscaped());
}

}  // namespace

QString outcome_words(double captured) {
  if (std::isnan(captured)) return PointWords::tr("not judged");
  return captured == 1 ? PointWords::tr("captured") : PointWords::tr("missed");
}

QString point_words(const StudyResults& results, std::size_t row) {
  QString text = PointWords::tr("<b>Point %1</b>: %2")
                     .arg(static_cast<qlonglong>(results.points[row]))
                     .arg(outcome_words(results.captured[row]));
  text += "<table cellspacing='0'>";
  for (const ResultColumn& input : results.inputs) text += value_row(input, row);
  for (const char* name : kTelling) {
    if (const ResultColumn* column = results.find(name)) text += value_row(*column, row);
  }
  return text + "</table>";
}

QString estimate_words(std::int64_t captured, std::int64_t judged) {
  if (judged == 0) return PointWords::tr("No capture has been judged yet.");
  const Interval wilson = wilson_interval(captured, judged, kConfidence);
  const auto number = [](double value) { return QString::number(value, 'f', 3); };
  return PointWords::tr("Probability of capture <b>%1</b>, 95 % interval %2 to %3: %4 of %5 captured")
      .arg(number(static_cast<double>(captured) / static_cast<double>(judged)), number(wilson.lower),
           number(wilson.upper))
      .arg(captured)
      .arg(judged);
}

QString time_words(double seconds) {
  const auto whole = static_cast<qlonglong>(std::ceil(seconds));
  if (whole < 90) return PointWords::tr("%1 s").arg(whole);
  const qlonglong minutes = (whole + 30) / 60;
  if (minutes < 100) return PointWords::tr("%1 min").arg(minutes);
  return PointWords::tr("%1 h %2 min").arg(minutes / 60).arg(minutes % 60);
}

}  // namespace netpocket
