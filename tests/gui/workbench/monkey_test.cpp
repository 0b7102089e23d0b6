// Random valid actions: nothing may crash, hang or fail an assertion. The seed is printed; NETPOCKET_MONKEY_SEED and
// NETPOCKET_MONKEY_ACTIONS repeat or lengthen a walk.

#include <QAction>
#include <QTest>
#include <QUndoStack>
#include <functional>
#include <iostream>
#include <random>

#include "gui/workbench/run_actions.h"
#include "gui/workbench/timeline/timeline_bar.h"
#include "gui/workbench/viewport/viewport.h"
#include "tests/gui/workbench/window_fixture.h"

namespace netpocket {
namespace {

class Monkey {
 public:
  Monkey(MainWindow& window, unsigned seed) : window_(window), random_(seed) {
    actions_ = {
        [this] { window_.run_actions().run_or_pause(); },
        [this] { window_.run_actions().run_or_pause(); },
        [this] { window_.session().single_step(); },
        [this] { window_.run_actions().branch(); },
        [this] {
          if (number(10) == 0) window_.run_actions().restart();
        },
        [this] { window_.timeline().go_to(2.0 * number(1000) / 1000); },
        [this] { window_.timeline().step_frames(number(7) - 3); },
        [this] { window_.timeline().go_to_mark(number(2) == 0 ? -1 : 1); },
        [this] { window_.timeline().add_mark(); },
        [this] { window_.timeline().playback().play(number(2) == 0 ? -1 : 1); },
        [this] { window_.timeline().playback().stop(); },
        [this] { window_.viewport().set_preset(static_cast<CameraPreset>(number(5))); },
        [this] { window_.viewport().fit(); },
        [this] { window_.viewport().set_measuring(number(2) == 0); },
        [this] { drag(); },
        [this] { QTest::mouseClick(&window_.viewport(), Qt::LeftButton, {}, somewhere()); },
        [this] { edit(); },
        [this] { window_.document().undo_stack()->undo(); },
        [this] { window_.document().undo_stack()->redo(); },
        [this] { window_.session().set_pace(number(3)); },
        [this] { show_any_run(); },
        [this] { remove_any_run(); },
        [this] { window_.resize(700 + number(900), 450 + number(500)); },
        [this] { QTest::qWait(number(30)); },
    };
  }

  void act() { actions_[static_cast<std::size_t>(number(static_cast<int>(actions_.size())))](); }

 private:
  int number(int below) { return std::uniform_int_distribution<int>(0, below - 1)(random_); }
  QPoint somewhere() { return {number(window_.viewport().width()), number(window_.viewport().height())}; }

  void drag() {
    auto& viewport = window_.viewport();
    const auto button = number(2) == 0 ? Qt::LeftButton : Qt::MiddleButton;
    QTest::mousePress(&viewport, button, {}, somewhere());
    QTest::mouseMove(&viewport, somewhere());
    QTest::mouseRelease(&viewport, button, {}, somewhere());
  }

  void edit() {
    static constexpr std::array kKeys = {"closing.duration", "towing.size", "contact.friction", "target.radius",
                                         "net.diameter"};
    const Parameter& parameter = *find_parameter(kKeys[static_cast<std::size_t>(number(kKeys.size()))]);
    const double value = std::get<double>(parameter.get(window_.document().scenario()));
    // Refusals are fine too.
    (void)window_.document().set_value(parameter, value * (0.5 + number(100) / 100.0));
  }

  void show_any_run() {
    const auto ids = window_.session().runs().ids();
    if (!ids.empty()) window_.session().show_run(ids[static_cast<std::size_t>(number(static_cast<int>(ids.size())))]);
  }

  // Keeps the number of runs small.
  void remove_any_run() {
    const auto ids = window_.session().runs().ids();
    if (ids.size() > 3) window_.session().remove_run(ids.front());
  }

  MainWindow& window_;
  std::mt19937 random_;
  std::vector<std::function<void()>> actions_;
};

TEST_F(WindowTest, SurvivesAMonkey) {
  const unsigned seed = qEnvironmentVariableIsSet("NETPOCKET_MONKEY_SEED")
                            ? qEnvironmentVariable("NETPOCKET_MONKEY_SEED").toUInt()
                            : std::random_device{}();
  const int actions = qEnvironmentVariableIsSet("NETPOCKET_MONKEY_ACTIONS")
                          ? qEnvironmentVariableIntValue("NETPOCKET_MONKEY_ACTIONS")
                          : 2000;
  std::cout << "monkey seed " << seed << ", " << actions << " actions\n";
  SCOPED_TRACE(seed);
  Monkey monkey(*window_, seed);
  for (int i = 0; i < actions; ++i) {
    monkey.act();
    QCoreApplication::processEvents();
  }
  // Still alive: a run can be made and shown.
  window_->session().set_pace(0);
  EXPECT_TRUE(run_to(0.1) || !window_->document().diagnostics().ok());
}

}  // namespace
}  // namespace netpocket
