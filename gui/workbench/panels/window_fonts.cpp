#include "gui/workbench/panels/window_fonts.h"

#include <QApplication>
#include <QFont>
#include <QLocale>

#include "render/fonts/font_file.h"

namespace netpocket {

void use_window_fonts() {
  QFont font = QApplication::font();
  font.setFamily(kFontFamily);
  QApplication::setFont(font);
  QLocale::setDefault(QLocale::c());
}

void require_window_fonts() {
  for (const FontStyle& style : {FontStyle{}, FontStyle{.bold = true}, FontStyle{.mono = true}}) font_file(style);
}

}  // namespace netpocket
