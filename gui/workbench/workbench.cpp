#include "gui/workbench/workbench.h"

#include <QApplication>
#include <QTimer>
#include <cstdlib>

#include "gui/workbench/main_window.h"
#include "gui/workbench/viewport/viewport.h"

namespace netpocket {
namespace {

PresenterKind presenter_kind(const std::string& name) {
  if (name == "opengl") return PresenterKind::opengl;
  return name == "image" ? PresenterKind::image : PresenterKind::automatic;
}

// Saves the window once its first picture has been there for a moment.
void take_screenshot(MainWindow& window, const QString& path) {
  auto* timer = new QTimer(&window);
  timer->setSingleShot(true);
  timer->setInterval(1000);
  QObject::connect(&window.viewport(), &Viewport::picture_shown, timer, [timer] {
    if (!timer->isActive()) timer->start();
  });
  QObject::connect(timer, &QTimer::timeout, &window,
                   [&window, path] { QApplication::exit(window.grab().save(path) ? 0 : 1); });
}

}  // namespace

bool can_open_window() {
  const auto set = [](const char* name) {
    const char* value = std::getenv(name);
    return value != nullptr && *value != '\0';
  };
  return set("DISPLAY") || set("WAYLAND_DISPLAY") || set("QT_QPA_PLATFORM");
}

int run_workbench(const WorkbenchOptions& options) {
  if (!can_open_window()) {
    throw NoDisplay(
        "the workbench needs a display, and neither DISPLAY nor WAYLAND_DISPLAY is set; the other commands need none "
        "(see netpocket --help)");
  }
  prepare_opengl_format();
  int argc = 1;
  char name[] = "netpocket";
  char* argv[] = {name, nullptr};
  QApplication application(argc, argv);
  QApplication::setApplicationName("netpocket");
  QApplication::setApplicationDisplayName("Netpocket");
  QApplication::setApplicationVersion(QString::fromStdString(options.version));

  WindowOptions window_options;
  window_options.presenter = presenter_kind(options.presenter);
  window_options.session.origin = {options.threads, true, options.version, options.commit, "workbench"};
  window_options.about = QString::fromStdString(options.version_text);
  window_options.program = QApplication::applicationFilePath();
  MainWindow window(window_options);
  if (!options.file.empty()) window.open(QString::fromStdString(options.file));
  if (!options.screenshot.empty()) take_screenshot(window, QString::fromStdString(options.screenshot));
  window.show();
  return QApplication::exec();
}

}  // namespace netpocket
