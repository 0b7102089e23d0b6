#include "tests/gui/plain_desktop.h"

#include <QApplication>
#include <QFont>
#include <QStandardPaths>
#include <QStyle>

#include "gui/workbench/panels/window_fonts.h"
#include "gui/workbench/panels/window_style.h"

namespace netpocket {
namespace {

constexpr const char* kSettingsOfDesktops[] = {"QT_SCALE_FACTOR",
                                               "QT_SCREEN_SCALE_FACTORS",
                                               "QT_AUTO_SCREEN_SCALE_FACTOR",
                                               "QT_ENABLE_HIGHDPI_SCALING",
                                               "QT_USE_PHYSICAL_DPI",
                                               "QT_FONT_DPI",
                                               "QT_SCALE_FACTOR_ROUNDING_POLICY",
                                               "QT_QPA_PLATFORMTHEME",
                                               "QT_STYLE_OVERRIDE",
                                               "XDG_CURRENT_DESKTOP",
                                               "DESKTOP_SESSION",
                                               "KDE_FULL_SESSION",
                                               "GTK_THEME",
                                               "FREETYPE_PROPERTIES",
                                               "LANGUAGE"};

}  // namespace

void leave_desktop() {
  for (const char* name : kSettingsOfDesktops) qunsetenv(name);
  qputenv("LC_ALL", "C.UTF-8");
  qputenv("FONTCONFIG_FILE", NETPOCKET_SOURCE_DIR "/tests/gui/fonts.conf");
  QStandardPaths::setTestModeEnabled(true);
}

void use_plain_look() {
  QApplication::setStyle(new WindowStyle("Fusion"));
  QApplication::setPalette(QApplication::style()->standardPalette());
  QApplication::setFont(QFont("DejaVu Sans", 9));
  use_window_fonts();
  QApplication::setCursorFlashTime(0);
}

}  // namespace netpocket
