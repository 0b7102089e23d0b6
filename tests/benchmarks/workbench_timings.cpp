// How quick the window is, as a table: start, previews, event loop, scrubbing. Wall time is what a user feels and
// depends on what else the machine does; the processor time of the user interface's thread does not. Usage:
// netpocket_workbench_timings [SCENARIO.toml]; the platform is Qt's choice (QT_QPA_PLATFORM).

#include <fmt/format.h>
#include <time.h>

#include <QApplication>
#include <QElapsedTimer>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <algorithm>
#include <map>

#include "engine/capture/simulation.h"
#include "engine/scenario/read_scenario.h"
#include "gui/workbench/filming/film_actions.h"
#include "gui/workbench/filming/window_picture.h"
#include "gui/workbench/main_window.h"
#include "gui/workbench/panels/plots_panel.h"
#include "gui/workbench/run_actions.h"
#include "gui/workbench/viewport/viewport.h"

namespace netpocket {
namespace {

double thread_milliseconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

// Knows the longest work that the event loop did in one go, and on whose behalf.
class WatchedApplication : public QApplication {
 public:
  using QApplication::QApplication;

  bool notify(QObject* receiver, QEvent* event) override {
    if (depth_ > 0) return QApplication::notify(receiver, event);
    const std::string name = fmt::format("{} (event {})", receiver->metaObject()->className(), int(event->type()));
    ++depth_;
    const double start = thread_milliseconds();
    const bool result = QApplication::notify(receiver, event);
    --depth_;
    double& longest = longest_[name];
    longest = std::max(longest, thread_milliseconds() - start);
    return result;
  }

  void forget() { longest_.clear(); }
  void print(std::size_t count) const {
    std::vector<std::pair<double, std::string>> sorted;
    for (const auto& [name, time] : longest_) sorted.emplace_back(time, name);
    std::ranges::sort(sorted, std::ranges::greater());
    sorted.resize(std::min(sorted.size(), count));
    for (const auto& [time, name] : sorted) fmt::print("    {:6.1f} ms of processor time: {}\n", time, name);
  }

 private:
  int depth_ = 0;
  std::map<std::string, double> longest_;
};

class Samples {
 public:
  void add(double value) { values_.push_back(value); }
  void print(const char* what, double bound) {
    if (values_.empty()) return fmt::print("{:<46} nothing measured\n", what);
    std::ranges::sort(values_);
    const auto at = [&](double part) { return values_[static_cast<std::size_t>(part * double(values_.size() - 1))]; };
    fmt::print("{:<46} median {:7.1f}  99 % {:7.1f}  worst {:7.1f} ms  of {:5}  (aim: {:g} ms)\n", what, at(0.5),
               at(0.99), values_.back(), values_.size(), bound);
  }

 private:
  std::vector<double> values_;
};

// How late a timer's events come.
class DelayMeter {
 public:
  explicit DelayMeter(Samples& samples) : samples_(samples) {
    timer_.setInterval(kInterval);
    timer_.setTimerType(Qt::PreciseTimer);
    QObject::connect(&timer_, &QTimer::timeout, [this] {
      samples_.add(std::max(0.0, 1e-6 * static_cast<double>(clock_.nsecsElapsed()) - kInterval));
      clock_.restart();
    });
    clock_.start();
    timer_.start();
  }

 private:
  static constexpr int kInterval = 2;  // ms

  Samples& samples_;
  QTimer timer_;
  QElapsedTimer clock_;
};

bool wait_until(const std::function<bool()>& condition, double seconds = 120) {
  QElapsedTimer timer;
  timer.start();
  while (!condition()) {
    if (timer.elapsed() > 1000 * seconds) return false;
    QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents | QEventLoop::AllEvents, 1);
  }
  return true;
}

class Bench {
 public:
  Bench(WatchedApplication& application, Scenario scenario)
      : application_(application), scenario_(std::move(scenario)) {
    options_.settings_file = folder_.filePath("settings.ini");
    options_.recovery_folder = folder_.filePath("recovery");
    open_window();
  }

  void run() {
    measure_start();
    measure_preview();
    measure_running("while it runs at full speed");
    measure_filming();
    measure_plots();
    measure_scrubbing();
  }

 private:
  // Time until the window shows the pocket, ms.
  double open_window() {
    window_.reset();
    QElapsedTimer timer;
    timer.start();
    window_ = std::make_unique<MainWindow>(options_);
    bool came = false;
    QObject::connect(&window_->viewport(), &Viewport::picture_shown, [&](double, double) { came = true; });
    window_->resize(1920, 1080);
    window_->show();
    wait_until([&] { return came; });
    window_->viewport().disconnect();
    return static_cast<double>(timer.elapsed());
  }

  void measure_start() {
    Samples samples;
    for (int i = 0; i < 5; ++i) samples.add(open_window());
    samples.print("window to first picture of the pocket", 1500);
    window_->document().start_from(scenario_);
    wait_until([&] { return window_->viewport().state().structure != nullptr; });
    QTest::qWait(500);
  }

  void measure_preview() {
    Samples built, shown;
    const Parameter& radius = *find_parameter("target.radius");
    const Parameter& diameter = *find_parameter("net.diameter");
    for (int i = 0; i < 30; ++i) {
      const auto before = window_->viewport().state().structure;
      const auto is_new = [&] { return window_->viewport().state().structure != before; };
      bool came = false;
      const auto connection = QObject::connect(&window_->viewport(), &Viewport::picture_shown,
                                               [&] { came = came || window_->viewport().shown().structure != before; });
      QElapsedTimer timer;
      timer.start();
      if (i % 2 == 0) {
        (void)window_->document().set_value(radius, scenario_.target.radius * (1 - 0.001 * (i + 1)));
      } else {
        (void)window_->document().set_value(diameter, scenario_.net.diameter * (1 + 0.001 * i));
      }
      wait_until(is_new);
      built.add(1e-6 * static_cast<double>(timer.nsecsElapsed()));
      wait_until([&] { return came; });
      shown.add(1e-6 * static_cast<double>(timer.nsecsElapsed()));
      QObject::disconnect(connection);
    }
    built.print("edit to new pocket", 50);
    shown.print("edit to its picture", 50);
    window_->document().start_from(scenario_);
  }

  void measure_running(const char* when) {
    Samples starting, running;
    application_.forget();
    {
      DelayMeter meter(starting);
      window_->run_actions().restart();
      wait_until([&] { return window_->session().live() && window_->session().live()->frame_count() > 5; });
    }
    starting.print("event loop late, while a run starts", 50);
    application_.print(3);
    application_.forget();
    const Run* live = window_->session().live();
    const std::size_t first_frame = live->frame_count();
    const double first_time = live->end_time();
    qint64 running_for = 0;  // ms
    int pictures = 0;
    const auto count =
        QObject::connect(&window_->viewport(), &Viewport::picture_shown, [&](double, double) { ++pictures; });
    {
      DelayMeter meter(running);
      QElapsedTimer timer;
      timer.start();
      wait_until([&] { return timer.elapsed() > 15000 || !window_->session().is_running(); });
      running_for = std::max<qint64>(timer.elapsed(), 1);
    }
    QObject::disconnect(count);
    running.print(fmt::format("event loop late, {}", when).c_str(), 50);
    application_.print(6);
    const double last_time = live->end_time(), seconds = 1e-3 * static_cast<double>(running_for);
    const std::size_t frames = live->frame_count() - first_frame;
    window_->session().pause();
    wait_until([&] { return !window_->session().is_running(); });
    fmt::print("    {} frames, {:.1f} pictures a second, {:.2f} x real time: {:.0f} % of the speed without a window\n",
               frames, static_cast<double>(pictures) / seconds, (last_time - first_time) / seconds,
               100 * seconds_without_window(first_time, last_time) / seconds);
  }

  // The same while the window is recorded as a video; what one picture of it costs.
  void measure_filming() {
    Samples frame, picture;
    for (int i = 0; i < 50; ++i) {
      const double start = thread_milliseconds();
      (void)window_frame(*window_);
      frame.add(thread_milliseconds() - start);
    }
    for (int i = 0; i < 9; ++i) {
      const double start = thread_milliseconds();
      (void)window_picture(*window_);
      picture.add(thread_milliseconds() - start);
    }
    frame.print("processor time of a picture for a video", 10);
    picture.print("processor time of a picture to save", 500);
    WindowFilm& film = window_->film_actions().film();
    QObject::connect(&film, &WindowFilm::stopped, [](const QString&, double seconds, const QString&) {
      fmt::print("    recorded {:.1f} s\n", seconds);
    });
    film.start(folder_.filePath("film.mp4"), 25);
    measure_running("while it runs and is recorded");
    fmt::print("    {} pictures left out\n", film.left_out());
    film.stop();
    wait_until([&] { return !film.is_active(); });
  }

  // s, of the engine alone for the same part of the run, in the same process.
  double seconds_without_window(double from, double until) const {
    Simulation simulation(scenario_);
    simulation.advance(from);
    QElapsedTimer timer;
    timer.start();
    simulation.advance(until);
    return 1e-9 * static_cast<double>(timer.nsecsElapsed());
  }

  // Processor time of what a growing run draws anew, of the run so far.
  void measure_plots() {
    auto& plots = window_->plots();
    for (const char* name : {"figure03_closing", "figure05_force", "figure06_position", "energy", "tension"}) {
      plots.show_figure(name);
      Samples samples;
      for (int i = 0; i < 9; ++i) {
        const double start = thread_milliseconds();
        plots.chart()->set_figure(Figure(plots.chart()->figure()));
        plots.chart()->grab();
        samples.add(thread_milliseconds() - start);
      }
      samples.print(fmt::format("processor time of {}", name).c_str(), 20);
    }
  }

  void measure_scrubbing() {
    Scenario scenario = scenario_;
    scenario.output.frame_rate = 1000;
    auto& session = window_->session();
    session.start(scenario, false);
    session.resume({.until = 1.0});
    wait_until([&] { return session.live()->state == RunState::paused && session.live()->frame_count() >= 1000; });
    scrub("scrubbing 1000 frames, from memory");
    session.runs().set_cache_bytes(1);
    scrub("scrubbing 1000 frames, from the recording");
  }

  void scrub(const char* what) {
    Samples samples, drawing;
    auto& session = window_->session();
    const std::size_t count = session.current()->frame_count();
    for (std::size_t i = 0; i < 300; ++i) {
      const std::size_t index = (i * 617) % count;
      const double time = session.current()->series.times()[index];
      bool came = false;
      const auto connection =
          QObject::connect(&window_->viewport(), &Viewport::picture_shown, [&](double shown, double seconds) {
            drawing.add(1e3 * seconds);
            came = came || shown == time;
          });
      QElapsedTimer timer;
      timer.start();
      session.show_frame(index);
      wait_until([&] { return came; });
      QObject::disconnect(connection);
      samples.add(1e-6 * static_cast<double>(timer.nsecsElapsed()));
    }
    samples.print(what, 50);
    drawing.print("    of which its pictures are being drawn", 50);
  }

  WatchedApplication& application_;
  Scenario scenario_;
  QTemporaryDir folder_;
  WindowOptions options_;
  std::unique_ptr<MainWindow> window_;
};

}  // namespace
}  // namespace netpocket

int main(int argc, char** argv) {
  QStandardPaths::setTestModeEnabled(true);
  netpocket::prepare_opengl_format();
  netpocket::WatchedApplication application(argc, argv);
  netpocket::Scenario scenario;
  if (argc > 1) {
    const auto result = netpocket::read_scenario_file(argv[1]);
    if (!result.ok()) {
      fmt::print(stderr, "{}\n", result.diagnostics.text());
      return 3;
    }
    scenario = result.scenario;
  }
  netpocket::Bench(application, scenario).run();
}
