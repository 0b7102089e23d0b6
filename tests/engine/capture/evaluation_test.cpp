// Both evaluations of one small pocket that closes on a target, as its mesh is refined: how far they are apart, and
// which is nearer to the refined answer.

#include <cmath>

#include "engine/capture/simulation.h"
#include "engine/scenario/check_scenario.h"
#include "engine/state/channels.h"
#include "engine/state/pocket_groups.h"
#include "tests/engine/verification_table.h"

namespace netpocket {
namespace {

using namespace test;

class VerificationEvaluations : public VerificationTest {};

// What two captures are compared by.
struct Capture {
  // m, at 1.5 s, before anything touches: radius of the mouth; height and radius of the net, mean over its material.
  double mouth, net_height, net_radius;
  double strain_energy;    // J, at 1.5 s
  double closing_tension;  // N, mean from 0.9 to 1.5 s
  double first_contact;    // s
  double impulse;          // N s, integral of the size of the axial contact force until 2.1 s
};

void measure_net(const Structure& structure, const Snapshot& snapshot, Capture& capture) {
  double length = 0, height = 0, radius = 0;
  for (const StructureElement& element : structure.elements) {
    if (element.group != index_of(PocketGroup::net)) continue;
    const Eigen::Vector3d middle =
        0.5 * (snapshot.positions.col(element.node[0]) + snapshot.positions.col(element.node[1]));
    length += element.length;
    height += element.length * middle.y();
    radius += element.length * std::hypot(middle.x(), middle.z());
  }
  capture.net_height = height / length;
  capture.net_radius = radius / length;
}

Capture run(Evaluation evaluation, int elements_per_side) {
  Scenario scenario;
  scenario.pocket.mesh_columns = scenario.pocket.mesh_rows = 3;
  scenario.pocket.elements_per_side = elements_per_side;
  scenario.solver.evaluation = evaluation;
  scenario.closing.duration = 3;
  EXPECT_TRUE(check_scenario(scenario).ok());
  Simulation simulation(scenario);
  const double frame = 0.01;
  Capture capture{};
  for (int i = 1; i <= 210; ++i) {
    EXPECT_EQ(simulation.advance(frame * i).reason, RunReason::finished);
    const Snapshot snapshot = simulation.snapshot();
    const double force = snapshot.channel(Channel::contact_fy);
    if (i > 90 && i <= 150) capture.closing_tension += snapshot.channel(Channel::closing_tension) / 60;
    if (force != 0 && capture.first_contact == 0) capture.first_contact = frame * i;
    capture.impulse += std::abs(force) * frame;
    if (i != 150) continue;
    measure_net(simulation.structure(), snapshot, capture);
    capture.mouth = snapshot.channel(Channel::mouth_radius);
    capture.strain_energy = snapshot.channel(Channel::energy_strain);
  }
  return capture;
}

// Bounds of what two captures may differ by.
struct Bounds {
  double mouth, net, energy, tension, first_contact, impulse;
};

void compare(const std::string& what, const Capture& a, const Capture& b, const Bounds& bounds,
             const std::string& source) {
  VerificationTest& test = VerificationTest::current();
  const auto relative = [](double x, double y) { return std::abs(x / y - 1); };
  test.expect_below("radius of the mouth at 1.5 s, m, " + what, std::abs(a.mouth - b.mouth), bounds.mouth, source);
  test.expect_below("height of the net at 1.5 s, m, " + what, std::abs(a.net_height - b.net_height), bounds.net,
                    source);
  test.expect_below("radius of the net at 1.5 s, m, " + what, std::abs(a.net_radius - b.net_radius), bounds.net,
                    source);
  test.expect_below("strain energy at 1.5 s, relative, " + what, relative(a.strain_energy, b.strain_energy),
                    bounds.energy, source);
  test.expect_below("mean tension of the closing ropes, N, " + what, std::abs(a.closing_tension - b.closing_tension),
                    bounds.tension, source);
  test.expect_below("first contact, s, " + what, std::abs(a.first_contact - b.first_contact), bounds.first_contact,
                    source);
  test.expect_below("impulse until 2.1 s, relative, " + what, relative(a.impulse, b.impulse), bounds.impulse, source);
}

TEST_F(VerificationEvaluations, OfACaptureConverge) {
  const std::string source =
      "pocket of 3 x 3 meshes a panel, 7.56 to 3.4 m in 2.1 of 3 s; bounds shrink with the mesh, but for what a slack "
      "net "
      "leaves to chance once it touches";
  const double five_frames = 0.05 + 1e-9;
  const Bounds coarse{0.05, 0.15, 0.35, 3, five_frames, 0.4}, middle{0.002, 0.1, 0.15, 0.5, five_frames, 0.3},
      fine{5e-4, 0.02, 0.03, 0.2, 0.03, 0.2};
  const Capture reference = run(Evaluation::full, 4);
  for (const auto& [elements, between, of_refined] :
       {std::tuple{1, coarse, coarse}, {2, middle, middle}, {4, fine, fine}}) {
    const std::string mesh = ", " + std::to_string(elements) + " a side";
    const Capture mean = run(Evaluation::mean_strain, elements);
    const Capture full = elements == 4 ? reference : run(Evaluation::full, elements);
    compare("mean-strain against full" + mesh, mean, full, between, source);
    if (elements == 4) continue;
    compare("mean-strain against full with 4 a side" + mesh, mean, reference, of_refined, source);
    compare("full against full with 4 a side" + mesh, full, reference, of_refined, source);
  }
}

}  // namespace
}  // namespace netpocket
