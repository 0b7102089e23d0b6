#pragma once
// The orbit that the origin of a model follows, and what acts on masses near it.
//
// The axes of the model do not turn. Its origin falls freely on the reference orbit, so a mass at r feels only the
// difference of gravity there and at the origin, the tide: r'' = G(t) r with the gradient G of gravity on the orbit.
// The next term of the series is smaller by about 3 |r|/(2 R): 2e-5 at 100 m in a low orbit. In axes that turn with a
// circular orbit this is the equation of Hill and of Clohessy & Wiltshire (1960), J. Aerosp. Sci. 27, 653,
// doi:10.2514/8.8704.
//
// Local axes, as in Fehse, Automated Rendezvous and Docking of Spacecraft (2003), section 3.1: V-bar points ahead (in a
// circular orbit along the velocity), R-bar to the Earth's centre, H-bar against the orbit's angular momentum. V-bar,
// H-bar and R-bar, in this order, are right-handed.

#include <Eigen/Core>
#include <vector>

namespace netpocket {

// hill: a circle, in closed form. two_body: any closed orbit about a point mass. two_body_j2: likewise, with the
// Earth's oblateness.
enum class OrbitField { hill, two_body, two_body_j2 };

// Directions of the local axes.
enum class LocalAxis { v_bar, minus_v_bar, r_bar, minus_r_bar, h_bar, minus_h_bar };

struct Orbit {
  OrbitField field = OrbitField::hill;
  // Of the origin at t = 0, Earth-centred inertial axes with z along the Earth's axis; m, m/s. A `hill` orbit keeps the
  // radius and the plane.
  Eigen::Vector3d position = Eigen::Vector3d::Zero(), velocity = Eigen::Vector3d::Zero();
  // Directions of the model's axes x and y at t = 0.
  LocalAxis x = LocalAxis::h_bar, y = LocalAxis::v_bar;
};

// An orbit from its elements at t = 0; angles in rad. `perigee_radius`: m. The node is on the inertial x axis; gravity
// makes no difference between nodes. Source: Vallado (2013), algorithm 10.
struct OrbitElements {
  double perigee_radius = 6778137, eccentricity = 0, inclination = 0, argument_of_perigee = 0, true_anomaly = 0;
};
Orbit orbit_of(const OrbitElements& elements, OrbitField field, LocalAxis x, LocalAxis y);

// Whether x and y can be directions of two axes at right angles.
bool are_perpendicular(LocalAxis x, LocalAxis y);

// Follows the orbit. The state is a function of time alone, whatever was asked for before, to the last bit.
//
// `two_body` and `two_body_j2` are integrated by the pair of Dormand & Prince (1980), J. Comput. Appl. Math. 6, 19,
// doi:10.1016/0771-050X(80)90013-3, with an error of at most 1e-12 of the radius per step; between its steps a
// polynomial of degree 5 fits position, velocity and acceleration at both ends.
//
// Thread contract: one thread at a time per object.
class ReferenceOrbit {
 public:
  // Throws std::invalid_argument if the axes of `orbit` are not at right angles.
  explicit ReferenceOrbit(const Orbit& orbit);

  struct State {
    Eigen::Vector3d position, velocity;  // m, m/s, inertial axes
  };
  // At `time` (s), not negative.
  State at(double time);
  // G (1/s^2) in the model's axes.
  Eigen::Matrix3d tide(double time);
  // Columns: V-bar, R-bar and H-bar in the model's axes.
  Eigen::Matrix3d local_axes(double time);
  // Angular velocity (rad/s) of the local axes, in the model's axes.
  Eigen::Vector3d turning(double time);

 private:
  struct Knot {
    double time = 0;
    State state{};
    Eigen::Vector3d acceleration = Eigen::Vector3d::Zero();
  };

  Eigen::Vector3d acceleration_at(const Eigen::Vector3d& position) const;
  void extend(double time);
  State on_circle(double time) const;

  Orbit orbit_;
  double j2_ = 0;
  Eigen::Matrix3d axes_;       // columns: the model's axes in inertial axes
  double rate_ = 0;            // rad/s, of a circular orbit
  Eigen::Vector3d ahead_;      // m: a circular orbit's position a quarter of a turn after the start
  std::vector<Knot> knots_;    // ascending in time
  double next_step_ = 0;       // s
  std::size_t last_knot_ = 0;  // of the last call: times mostly follow each other
};

}  // namespace netpocket
