#include "gui/workbench/workbench.h"

#include <fmt/format.h>

#include <QApplication>
#include <QScreen>
#include <QSettings>
#include <QTimer>
#include <cstdlib>
#include <memory>

#include "engine/base/file_error.h"
#include "gui/workbench/filming/film_actions.h"
#include "gui/workbench/filming/window_picture.h"
#include "gui/workbench/language.h"
#include "gui/workbench/main_window.h"
#include "gui/workbench/panels/window_fonts.h"
#include "gui/workbench/panels/window_style.h"
#include "gui/workbench/viewport/viewport.h"

namespace netpocket {
namespace {

std::optional<PresenterKind> presenter_kind(const std::string& name) {
  if (name.empty()) return std::nullopt;
  if (name == "opengl") return PresenterKind::opengl;
  return name == "image" ? PresenterKind::image : PresenterKind::automatic;
}

// Turns what Qt says when it finds no display into one sentence, instead of several lines and a core dump. Stands while
// the application is made; what was said in vain is passed on afterwards.
class DisplayTrouble {
 public:
  explicit DisplayTrouble(const std::function<void(const std::string&)>& no_display) : no_display_(no_display) {
    current_ = this;
    previous_ = qInstallMessageHandler(&DisplayTrouble::take);
  }
  ~DisplayTrouble() {
    qInstallMessageHandler(previous_);
    current_ = nullptr;
    for (const QString& warning : warnings_) qWarning("%s", qUtf8Printable(warning));
  }
  DisplayTrouble(const DisplayTrouble&) = delete;
  DisplayTrouble& operator=(const DisplayTrouble&) = delete;

 private:
  static void take(QtMsgType type, const QMessageLogContext&, const QString& text) {
    if (type != QtFatalMsg) {
      current_->warnings_ << text;
    } else if (current_->no_display_) {
      current_->no_display_(current_->reason(text).toStdString());
    }
  }

  // `last`: what Qt says as it gives up.
  QString reason(const QString& last) const {
    const QString start = QStringLiteral("the workbench cannot open a window: ");
    const QString chosen = qEnvironmentVariable("QT_QPA_PLATFORM");
    for (const QString& warning : warnings_) {
      if (!chosen.isEmpty() && warning.contains("Could not find the Qt platform plugin")) {
        return start +
               QString("there is no Qt platform \"%1\"; unset QT_QPA_PLATFORM, or try xcb or offscreen").arg(chosen);
      }
      if (!warning.contains("could not connect to display")) continue;
      const QString display = qEnvironmentVariable("DISPLAY");
      if (display.isEmpty() && chosen.isEmpty()) {
        return start + QStringLiteral(
                           "there is Wayland only, for which Qt's plugin is missing (Debian: qt6-wayland); "
                           "QT_QPA_PLATFORM=offscreen does without a display");
      }
      return start +
             QString("the display \"%1\" cannot be reached; QT_QPA_PLATFORM=offscreen does without one").arg(display);
    }
    // Its closing words tell nothing but that there was no way.
    if (!last.contains("no Qt platform plugin could be initialized")) return start + last.simplified();
    for (auto warning = warnings_.rbegin(); warning != warnings_.rend(); ++warning) {
      if (!warning->contains("XDG_RUNTIME_DIR")) return start + warning->simplified();
    }
    return start + (chosen.isEmpty()
                        ? QStringLiteral("Qt finds no way to show one")
                        : QString("the Qt platform \"%1\" does not start here; try xcb or offscreen").arg(chosen));
  }

  inline static DisplayTrouble* current_ = nullptr;
  const std::function<void(const std::string&)>& no_display_;
  QtMessageHandler previous_;
  QStringList warnings_;
};

// Throws NoDisplay where there is nothing that shows the window's colours.
void check_screen() {
  const QScreen* screen = QGuiApplication::primaryScreen();
  const QString platform = QGuiApplication::platformName();
  if (screen == nullptr || screen->size().isEmpty()) {
    throw NoDisplay(
        fmt::format("the workbench cannot open a window: the Qt platform \"{}\" has no screen here; "
                    "QT_QPA_PLATFORM=offscreen does without one",
                    platform.toStdString()));
  }
  constexpr int kFewestBits = 15;
  if (screen->depth() < kFewestBits) {
    throw NoDisplay(
        fmt::format("the workbench cannot show its pictures: the display has {} bits for a pixel's colour, "
                    "and {} are needed; QT_QPA_PLATFORM=offscreen does without a display",
                    screen->depth(), kFewestBits));
  }
}

// Saves the window once its first picture and its findings are there, and ends. `failure`: why it could not.
void take_screenshot(MainWindow& window, const QString& path, std::string& failure) {
  auto* timer = new QTimer(&window);
  timer->setSingleShot(true);
  timer->setInterval(2500);  // findings are evaluated now and then
  QObject::connect(&window.viewport(), &Viewport::picture_shown, timer, [timer] {
    if (!timer->isActive()) timer->start();
  });
  if (!window.notice().isEmpty()) timer->start();  // perhaps there is nothing to draw
  QObject::connect(timer, &QTimer::timeout, &window, [&window, path, &failure] {
    failure = window.film_actions().save_picture(window_picture(window), path).value_or(QString()).toStdString();
    QApplication::quit();
  });
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
        "the workbench needs a display, and neither DISPLAY nor WAYLAND_DISPLAY is set; the other commands need none, "
        "and with QT_QPA_PLATFORM=offscreen it draws without one");
  }
  require_window_fonts();
  prepare_opengl_format();
  int argc = 1;
  char name[] = "netpocket";
  char* argv[] = {name, nullptr};
  auto trouble = std::make_unique<DisplayTrouble>(options.no_display);
  QApplication application(argc, argv);
  check_screen();
  trouble.reset();
  QApplication::setStyle(new WindowStyle);
  use_window_fonts();
  QApplication::setApplicationName("netpocket");
  QApplication::setApplicationDisplayName("Netpocket");
  QApplication::setApplicationVersion(QString::fromStdString(options.version));
  QSettings settings("netpocket", "workbench");
  const QString language_notice = speak_as_preferred(settings);

  WindowOptions window_options;
  window_options.presenter = presenter_kind(options.presenter);
  window_options.threads = options.threads;
  window_options.origin = {
      .overwrite = true, .version = options.version, .commit = options.commit, .command = "workbench"};
  window_options.about = QString::fromStdString(options.version_text);
  window_options.program = QApplication::applicationFilePath();
  MainWindow window(window_options);
  if (!options.file.empty()) {
    window.open(QString::fromStdString(options.file));
  } else if (!window.offers_recovery()) {
    window.begin();
  }
  if (!language_notice.isEmpty()) window.show_notice(language_notice);
  std::string failure;
  if (!options.screenshot.empty()) take_screenshot(window, QString::fromStdString(options.screenshot), failure);
  window.show();
  const int status = QApplication::exec();
  if (!failure.empty()) throw FileError(failure);
  return status;
}

}  // namespace netpocket
