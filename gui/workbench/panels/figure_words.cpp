#include "gui/workbench/panels/figure_words.h"

#include "gui/workbench/panels/engine_words.h"

namespace netpocket {

Figure in_window_language(Figure figure) {
  const auto put = [](std::string& text) { text = engine_words(std::string_view(text)).toStdString(); };
  for (Panel& panel : figure.panels) {
    for (std::string* text : {&panel.title, &panel.x.title, &panel.y.title, &panel.empty}) put(*text);
    for (Curve& curve : panel.curves) put(curve.label);
    for (PhaseBand& phase : panel.phases) put(phase.label);
  }
  return figure;
}

}  // namespace netpocket
