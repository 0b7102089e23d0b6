// The window with a second kind of capture system: its form, its preview, its run and its figure.

#include "engine/scenario/parameters.h"
#include "gui/workbench/editor/parameter_form.h"
#include "gui/workbench/editor/parameter_row.h"
#include "gui/workbench/panels/plots_panel.h"
#include "gui/workbench/viewport/viewport.h"
#include "tests/gui/workbench/window_fixture.h"
#include "tests/systems/falling_net/falling_net.h"

namespace netpocket {
namespace {

class SecondSystemWindow : public WindowTest {
 protected:
  static void SetUpTestSuite() { register_falling_net(); }
};

TEST_F(SecondSystemWindow, EditsRunsAndPlots) {
  write_file("net.toml", R"(system = "falling_net"
[falling_net]
cells = 4
height = 1.4
speed = 3
[target]
radius = 0.7
mass = 40
inertia = [8, 8, 8]
position = [0, 0, 0]
[output]
end_time = 0.8
)");
  ASSERT_NE(window_->findChild<ParameterForm*>()->row("closing.duration"), nullptr);
  window_->open(file("net.toml"));
  auto* form = window_->findChild<ParameterForm*>();
  EXPECT_EQ(form->row("closing.duration"), nullptr);
  EXPECT_EQ(form->closing_preview(), nullptr);
  ASSERT_NE(form->row("falling_net.speed"), nullptr);
  ASSERT_TRUE(run_to(0.7));
  ASSERT_TRUE(wait_for_picture());
  // The view that showed the pocket, which is 12 m deep, has turned to the net about the origin.
  EXPECT_LT(window_->viewport().state().camera.focal_point.norm(), 1.5);
  window_->plots().show_figure("own_channels");
  EXPECT_EQ(window_->plots().figure_name(), "own_channels");
  screenshot("second_system");
}

}  // namespace
}  // namespace netpocket
