#include "gui/workbench/panels/rich_label.h"

#include "render/figures/rich_text.h"

namespace netpocket {

QString to_html(std::string_view markup) {
  QString html;
  for (const TextRun& run : parse_rich_text(markup)) {
    QString text = QString::fromStdString(run.text).toHtmlEscaped();
    if (run.italic) text = "<i>" + text + "</i>";
    if (run.script < 0) text = "<sub>" + text + "</sub>";
    if (run.script > 0) text = "<sup>" + text + "</sup>";
    html += text;
  }
  return html;
}

}  // namespace netpocket
