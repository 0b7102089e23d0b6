#include "tests/gui/workbench/window_fixture.h"

#include <QAbstractButton>
#include <QApplication>
#include <QDropEvent>
#include <QFile>
#include <QMimeData>
#include <QTest>
#include <QTimer>
#include <QUrl>

#include "gui/workbench/second_view.h"
#include "gui/workbench/viewport/viewport.h"
#include "tests/gui/patience.h"

namespace netpocket {

Scenario quick_scenario() {
  Scenario scenario;
  scenario.name = "quick";
  scenario.pocket.mesh_columns = 2;
  scenario.pocket.mesh_rows = 2;
  scenario.pocket.elements_per_side = 1;
  scenario.closing.duration = 0.8;
  scenario.towing.start = 1;
  scenario.output.end_time = 2;
  return scenario;
}

WindowTest::WindowTest() {
  options_.settings_file = file("settings.ini");
  options_.recovery_folder = file("recovery");
  options_.program = NETPOCKET_PROGRAM;
  // As the tests' environment says: images, or OpenGL under an X server.
  const bool opengl = qEnvironmentVariable("NETPOCKET_TEST_PRESENTER") == "opengl";
  options_.presenter = opengl ? PresenterKind::opengl : PresenterKind::image;
  QSettings settings(options_.settings_file, QSettings::IniFormat);
  write_preferences({.ask_about_runs = false}, settings);
  settings.sync();
  reopen();
}

WindowTest::~WindowTest() = default;

void WindowTest::reopen() {
  window_.reset();
  window_ = std::make_unique<MainWindow>(options_);
  window_->document().start_from(quick_scenario());
  window_->show();
  window_->activateWindow();
  (void)wait_patiently([this] { return window_->isActiveWindow(); }, 5);
}

void WindowTest::answer_question(QMessageBox::StandardButton button) {
  auto* timer = new QTimer(qApp);
  QObject::connect(timer, &QTimer::timeout, timer, [timer, button] {
    auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
    if (box == nullptr) return;
    timer->stop();
    timer->deleteLater();
    box->button(button)->click();
  });
  timer->start(10);
}

bool WindowTest::wait_until(const std::function<bool()>& condition, double seconds) {
  return wait_patiently(condition, seconds);
}

bool WindowTest::run_to(double time) {
  const auto scenario = window_->scenario_to_run();
  if (!scenario) return false;
  window_->session().start(*scenario, false);
  window_->session().resume({.until = time});
  return wait_until([&] {
    const auto* live = window_->session().live();
    return live && live->end_time() >= time - 1e-6 && live->state == RunState::paused;
  });
}

namespace {

// The picture is of what was asked for last, and as good as it gets: one of an older camera or a draft may come before.
bool is_up_to_date(const Viewport& viewport) {
  const ViewState &asked = viewport.state(), &shown = viewport.shown();
  return !shown.draft && shown.snapshot == asked.snapshot && shown.camera.position == asked.camera.position &&
         shown.camera.focal_point == asked.camera.focal_point && shown.camera.half_height == asked.camera.half_height;
}

}  // namespace

bool WindowTest::wait_for_picture() {
  bool came = false;
  const auto connection = QObject::connect(&window_->viewport(), &Viewport::picture_shown, [&] { came = true; });
  window_->viewport().set_snapshot(window_->viewport().state().snapshot);
  const bool shown = wait_until([&] {
    SecondView* second = window_->second_view();
    return came && is_up_to_date(window_->viewport()) &&
           (second == nullptr || !second->isVisible() || is_up_to_date(second->viewport()));
  });
  QObject::disconnect(connection);
  return shown;
}

// Qt delivers a drop only to what took the drag that entered.
void WindowTest::drop(const QStringList& paths) {
  QMimeData data;
  QList<QUrl> urls;
  for (const QString& path : paths) urls << QUrl::fromLocalFile(path);
  data.setUrls(urls);
  QDragEnterEvent enter(QPoint(100, 100), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(window_.get(), &enter);
  EXPECT_TRUE(enter.isAccepted());
  QDropEvent dropped(QPointF(100, 100), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(window_.get(), &dropped);
}

void WindowTest::screenshot(const QString& name) {
  const QString folder = qEnvironmentVariable("NETPOCKET_SCREENSHOTS");
  if (folder.isEmpty()) return;
  wait_for_picture();
  QTest::qWait(500);
  wait_for_picture();
  window_->grab().save(QString("%1/%2.png").arg(folder, name));
}

void WindowTest::write_file(const QString& name, const QByteArray& content) const {
  QFile out(file(name));
  ASSERT_TRUE(out.open(QIODevice::WriteOnly));
  out.write(content);
}

}  // namespace netpocket
