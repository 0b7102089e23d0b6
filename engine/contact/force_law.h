#pragma once
// Contact forces at one point: a Hertz spring with the damper of Antypov & Elliott along the normal, Coulomb friction
// tangentially. Source: Tang et al. (2023), Appl. Sci. 13, 10377, section 3.3. Damper: Antypov & Elliott (2011), EPL
// 94, 50004, doi:10.1209/0295-5075/94/50004.
//
// Signs: `penetration` d > 0 where the partners overlap. `separation_speed` v_n > 0 when they move apart, so that
// ddot = -v_n. Forces are positive when they push the partners apart. SI units.
// All functions are pure. Those used in every step are inline and free of branches.

#include <algorithm>
#include <cmath>

#include "engine/math/elementary.h"

namespace netpocket {

struct ElasticMaterial {
  double youngs_modulus;  // Pa
  double poisson_ratio;
};

// E_eff (Pa): 1/E_eff = (1 - nu_1^2)/E_1 + (1 - nu_2^2)/E_2.
double effective_modulus(const ElasticMaterial& a, const ElasticMaterial& b);

// r_eff (m): 1/r_eff = 1/r_1 + 1/r_2. A plane has an infinite radius.
double effective_radius(double r1, double r2);

// m_eff (kg): m_1 m_2/(m_1 + m_2). A body that cannot move has an infinite mass.
double effective_mass(double m1, double m2);

// K (N/m^1.5) = 4/3 E_eff sqrt(r_eff).
double hertz_stiffness(double effective_modulus, double effective_radius);

// alpha = -sqrt(5) ln c_r / sqrt(ln^2 c_r + pi^2) for Newton's coefficient of restitution c_r. It is sqrt(5) for
// c_r <= 0 and 0 for c_r >= 1. At c_r = 0 the motion is critically damped: the rebound speed is zero.
double restitution_damping(double restitution);

// F_n = K d^1.5 + alpha sqrt(K m_eff) d^0.25 ddot for one pair of partners.
struct NormalLaw {
  double stiffness;  // K, N/m^1.5
  double damping;    // alpha sqrt(K m_eff), N s/m^1.25
};

NormalLaw make_normal_law(double hertz_stiffness, double restitution, double effective_mass);

// The law as written, N. At the end of a contact it pulls (adhesive tail). This makes the rebound speed exactly c_r
// times the speed of approach.
inline double normal_force(const NormalLaw& law, double penetration, double separation_speed) {
  const double root = std::sqrt(std::max(penetration, 0.0));
  return law.stiffness * root * root * root - law.damping * std::sqrt(root) * separation_speed;
}

// The law without its adhesive tail: it never pulls, N. The rebound is a little faster than with c_r (0.550 for
// c_r = 0.5).
inline double repulsive_normal_force(const NormalLaw& law, double penetration, double separation_speed) {
  return std::max(normal_force(law, penetration, separation_speed), 0.0);
}

// Deepest penetration (m) of an undamped impact at `speed` (m/s) with the effective mass `mass` (kg) and the stiffness
// K (N/m^1.5). Hertz: d = 1.093362 (m v^2/K)^0.4 = (5 m v^2/(4 K))^0.4.
inline double depth_of_impact(double mass, double stiffness, double speed) {
  const double root = fifth_root(1.25 * mass * speed * speed / stiffness);
  return root * root;
}

// K (N/m^1.5) of a contact whose impact at `speed` (m/s) with the effective mass `mass` (kg) lasts `duration` (s). This
// is Hertz's duration 3.218 (m^2/(K^2 v))^0.2 solved for K. As long as impacts are short compared to all other motions,
// the momentum that an impact transfers depends on the coefficient of restitution and not on K. Therefore a contact
// stiffer than steps can resolve is softened to this K, as is usual in discrete-element computations (Tsuji, Kawaguchi
// & Tanaka 1993, doi:10.1016/0032-5910(93)85010-7; Lommen, Schott & Lodewijks 2014, doi:10.1016/j.partic.2013.03.002).
inline double stiffness_of_impact(double mass, double speed, double duration) {
  constexpr double kHertzDuration = 3.218065;
  const double ratio = kHertzDuration / duration;
  return mass * ratio * ratio * std::sqrt(ratio / speed);
}

// Largest K (N/m^1.5) for which steps of `dt` (s) resolve a contact of effective mass `mass` (kg). With it an impact at
// 1 m/s lasts eight steps. This resolves the rebound to 1 % up to ten times that speed.
inline double resolved_stiffness(double mass, double dt) {
  constexpr double kSpeed = 1, kSteps = 8;
  return stiffness_of_impact(mass, kSpeed, kSteps * dt);
}

// The durations (s) of a leapfrog step. Forces change velocities over `kick`: half of the last step and half of this
// one. Then velocities move positions over `drift`. Both are equal while steps are equal. When a step is halved, `kick`
// is 1.5 times `drift`.
struct StepTimes {
  double kick;
  double drift;
  // Factor on inverse masses for formulas that assume equal steps of size `drift`. They take the impulse as
  // drift * force, whereas it is kick * force.
  double inertia_factor() const { return kick / drift; }
};

// Speeds of separation (m/s) before and after a step, without the force of this contact.
struct StepSpeeds {
  double before;
  double after;  // includes the other forces of the step, so that a loaded contact rests where its spring carries them
};

// Normal force (N) over the coming step of `dt` (s). `inverse_mass` w (1/kg) is the change of v_n by a unit impulse at
// the contact, for both partners together. With the tangent k = 1.5 K sqrt(d), D = damping d^0.25 and the mean speed
// vm,
//   F = (K d^1.5 - theta k dt v_after - D vm) / (1 + dt w (theta k dt + D/2)).
// - If the step resolves the contact, dt^2 w k <= 1, theta is 0. The spring acts as in the leapfrog scheme, which
//   conserves energy. The damper acts at the mean speed of the step, so that the rebound is that of the law to second
//   order in dt.
// - Otherwise theta = 1 - 1/(dt^2 w k) makes part of the spring implicit. This is stable for any dt, but the rebound is
//   slower.
// The force never pulls. It tends to repulsive_normal_force for dt -> 0.
inline double stepped_normal_force(const NormalLaw& law, double penetration, const StepSpeeds& speed,
                                   double inverse_mass, double dt) {
  const double root = std::sqrt(std::max(penetration, 0.0));
  const double elastic = law.stiffness * root * root * root;
  const double implicit = std::max(1.5 * law.stiffness * root * dt - 1 / (dt * inverse_mass), 0.0);  // theta k dt
  const double damping = law.damping * std::sqrt(root);
  const double unopposed = elastic - implicit * speed.after - damping * 0.5 * (speed.before + speed.after);
  return std::max(unopposed / (1 + dt * inverse_mass * (implicit + 0.5 * damping)), 0.0);
}

// Energy of the spring, J: 2/5 K d^2.5.
inline double elastic_energy(const NormalLaw& law, double penetration) {
  const double d = std::max(penetration, 0.0);
  return 0.4 * law.stiffness * d * d * std::sqrt(d);
}

// Regularised Coulomb friction as a resistance c >= 0 (N s/m). The force on a partner is -c times its sliding velocity
// relative to the other. c = mu F_n / max(v_t, v_f): the force is proportional to v_t below the friction velocity v_f
// (m/s, not negative) and mu F_n above it. The force never exceeds v_t/(w_t dt), which stops the sliding within the
// step; so friction never reverses the sliding. `inverse_mass` w_t (1/kg) is the change of the sliding speed by a unit
// impulse.
inline double sliding_resistance(double friction_coefficient, double friction_velocity, double normal_force,
                                 double sliding_speed, double inverse_mass, double dt) {
  const double stopping = 1 / (inverse_mass * dt);
  const double coulomb = friction_coefficient * normal_force / std::max(sliding_speed, friction_velocity);
  return std::min(stopping, coulomb);  // this order returns `stopping` if coulomb is 0/0 (no force, no speed, v_f = 0)
}

}  // namespace netpocket
