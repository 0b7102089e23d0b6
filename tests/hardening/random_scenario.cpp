#include "tests/hardening/random_scenario.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "engine/bodies/shape.h"
#include "engine/scenario/check_scenario.h"
#include "engine/scenario/parameters.h"
#include "engine/scenario/pocket_outline.h"

namespace netpocket::test {
namespace {

class Draw {
 public:
  explicit Draw(std::mt19937& random) : random_(random) {}

  Scenario scenario() {
    Scenario s;
    s.name = "random";
    s.output.end_time = 2;
    s.output.frame_rate = 25;
    draw_pocket(s);
    if (one_in(2)) draw_cord(s.net);
    if (one_in(4)) draw_cord(s.rope);
    if (one_in(4)) draw_material(s.rods.density, s.rods.youngs_modulus);
    draw_target(s.target);
    draw_contact(s.contact);
    draw_closing(s);
    draw_towing(s.towing);
    s.spacecraft.station_keeping = static_cast<StationKeeping>(whole(0, 2));
    if (one_in(4)) s.spacecraft.mass = logarithmic(1, 1e6);
    if (one_in(8)) s.solver.evaluation = Evaluation::full;
    if (one_in(8)) s.solver.gravity = direction() * uniform(0, 10);
    if (one_in(4)) s.solver.perturbation = uniform(0, 0.01);
    return s;
  }

 private:
  bool one_in(int n) { return whole(1, n) == 1; }
  int whole(int lowest, int highest) { return lowest + static_cast<int>(random_() % (highest - lowest + 1u)); }
  double uniform(double lowest, double highest) { return lowest + (highest - lowest) * (random_() / 4294967296.0); }
  double logarithmic(double lowest, double highest) { return std::exp(uniform(std::log(lowest), std::log(highest))); }
  Eigen::Vector3d direction() { return Eigen::Vector3d(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)).normalized(); }
  // One of the ends of a range as often as something between them.
  double with_ends(double lowest, double highest) {
    const int which = whole(0, 3);
    return which == 0 ? lowest : which == 1 ? highest : uniform(lowest, highest);
  }

  // Over all that densities may be, kg/m^3.
  double density() {
    const int which = whole(0, 5);
    return which == 0 ? 1 : which == 1 ? 3e4 : logarithmic(1, 3e4);
  }

  void draw_pocket(Scenario& s) {
    s.pocket.rod_count = whole(3, 10);
    s.pocket.mesh_columns = whole(1, 3);
    s.pocket.mesh_rows = whole(1, 3);
    s.pocket.elements_per_side = whole(1, 2);
    for (Eigen::Vector2d& point : s.rods.profile) point *= uniform(0.9, 1.1);
    if (one_in(4)) s.rods.tip_mass = uniform(0, 20);
  }

  // Waves of 100 to 3000 m/s, as far as the modulus allows: faster ones take steps too short for trials.
  void draw_material(double& drawn_density, double& modulus) {
    drawn_density = density();
    const double speed = logarithmic(100, 3000);
    modulus = std::clamp(drawn_density * speed * speed, 1e3, 1e13);
  }

  void draw_cord(CordParameters& cord) {
    cord.diameter = logarithmic(1e-3, 2e-2);
    draw_material(cord.density, cord.youngs_modulus);
    cord.axial_damping = one_in(2) ? 0 : logarithmic(1e-7, 1e-3);
    cord.bending_damping = one_in(2) ? 0 : logarithmic(1e-5, 1e-1);
    cord.compression = with_ends(0, 1);
  }

  void draw_target(TargetParameters& t) {
    t.shape = static_cast<TargetShape>(whole(0, 2));
    t.radius = uniform(0.3, 4);
    t.length = uniform(0.5, 6);
    t.size = {uniform(0.3, 6), uniform(0.3, 6), uniform(0.3, 6)};
    const Shape shape = t.shape == TargetShape::sphere ? Shape(Sphere{t.radius})
                        : t.shape == TargetShape::box  ? Shape(Box{t.size})
                                                       : Shape(Cylinder{t.radius, t.length});
    // Of evenly filled bodies; of a density between those of an aerogel and of osmium, as far as masses may be.
    const double volume = 4 * std::pow(bounding_radius(shape), 3);
    t.mass = std::clamp(density() * volume, 1e-3, 1e7);
    t.inertia = solid_inertia(shape, t.mass).diagonal().cwiseMax(1e-6).cwiseMin(1e10);
    t.position = {uniform(-3, 3), uniform(4, 14), uniform(-3, 3)};
    t.attitude = direction() * uniform(0, 3);
    t.velocity = direction() * (one_in(4) ? 0 : with_ends(0, 20));
    t.spin = direction() * (one_in(4) ? 0 : with_ends(0, 10));
  }

  void draw_contact(ContactParameters& c) {
    c.restitution = with_ends(0, 1);
    c.friction = with_ends(0, 10);
    whole(1, 5);  // what was drawn here until 0.1: seeds keep their scenarios
    c.spacecraft = !one_in(4);
  }

  void draw_closing(Scenario& s) {
    s.closing.law = static_cast<ClosingLaw>(whole(0, 3));
    s.closing.start = uniform(0, 1);
    s.closing.duration = logarithmic(0.3, 20);
    s.closing.elements = whole(1, 4);
    s.closing.closed_length = uniform(0.1, 0.95) * open_tip_distance(s);
  }

  void draw_towing(TowingParameters& t) {
    t.mode = static_cast<TowingMode>(whole(0, 3));
    t.start = uniform(0, 2);
    t.size = t.mode == TowingMode::force ? uniform(0, 100) : uniform(0, 0.5);
  }

  std::mt19937& random_;
};

}  // namespace

Scenario random_scenario(unsigned seed, int& drawn) {
  std::mt19937 random(seed);
  Draw draw(random);
  while (true) {
    ++drawn;
    Scenario scenario = draw.scenario();
    if (check_scenario(scenario).ok()) return scenario;
  }
}

}  // namespace netpocket::test
