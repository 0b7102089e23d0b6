#include "gui/workbench/panels/window_look.h"

#include <QApplication>
#include <QPalette>

#include "gui/workbench/panels/window_style.h"

namespace netpocket {
namespace {

constexpr double kScales[] = {1, 1.25, 1.5};
double used_scale = 1;

// What can be read on what: grounds, letters on them, and the same paler where nothing can be done.
struct Colours {
  QColor window, base, alternate, button, text, pale, placeholder, mid, highlight, link;
};

const Colours kLight{"#eff0f1", "#ffffff", "#f5f6f7", "#eaebec", "#1b1e20",
                     "#8b9095", "#5f656b", "#b4b8bc", "#0060b0", "#005bab"};
const Colours kDark{"#26292d", "#1c1f22", "#23262a", "#34383d", "#eceff1",
                    "#7b8187", "#a5acb3", "#565c63", "#2671bd", "#7ab8ff"};

QPalette palette_of(const Colours& colours) {
  QPalette palette(colours.text, colours.button, colours.button.lighter(115), colours.window.darker(170), colours.mid,
                   colours.text, Qt::white, colours.base, colours.window);
  palette.setColor(QPalette::AlternateBase, colours.alternate);
  palette.setColor(QPalette::ButtonText, colours.text);
  palette.setColor(QPalette::PlaceholderText, colours.placeholder);
  palette.setColor(QPalette::ToolTipBase, colours.alternate);
  palette.setColor(QPalette::ToolTipText, colours.text);
  palette.setColor(QPalette::Highlight, colours.highlight);
  palette.setColor(QPalette::HighlightedText, Qt::white);
  palette.setColor(QPalette::Link, colours.link);
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
    palette.setColor(QPalette::Disabled, role, colours.pale);
  }
  return palette;
}

}  // namespace

double type_scale() { return used_scale; }

void use_type_size(TypeSize size) {
  static const QFont usual = QApplication::font();
  QFont font = usual;
  used_scale = kScales[static_cast<int>(size)];
  font.setPointSizeF(used_scale * usual.pointSizeF());
  if (font != QApplication::font()) QApplication::setFont(font);
}

// Styles of desktops may paint in colours of their own.
void use_theme(Theme theme) {
  static Theme used = Theme::system;
  if (theme == used) return;
  used = theme;
  if (theme == Theme::system) {
    QApplication::setStyle(new WindowStyle);
    QApplication::setPalette(QPalette());
  } else {
    QApplication::setStyle(new WindowStyle("Fusion"));
    QApplication::setPalette(palette_of(theme == Theme::dark ? kDark : kLight));
  }
}

}  // namespace netpocket
