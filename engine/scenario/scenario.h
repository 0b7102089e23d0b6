#pragma once
// A scenario: everything that a user decides about a capture. Plain data in SI units. The world's Y axis is the
// pocket's axis; the mouth opens towards +Y. The parameter table (parameters.h) declares every member once more, with
// its TOML key, unit, limits, help and source. The defaults here are those of scenarios/case1.toml.

#include <Eigen/Core>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "engine/orbit/reference_orbit.h"
#include "engine/scenario/control_parameters.h"
#include "engine/scenario/parameter_value.h"

namespace netpocket {

class TriangleMesh;  // bodies/triangle_mesh.h

enum class TargetShape { sphere, box, cylinder, satellite, mesh };
enum class MeshUnit { metre, centimetre, millimetre, inch, foot };
enum class InertiaSource { given, shape };
enum class ClosingLaw { cycloid, quintic, trapezoid, linear, table };
enum class ClosingStart { time, target_inside, distance };
enum class TowingMode { none, force, acceleration, velocity, controlled };
enum class TowingStart { time, closed };
enum class StationKeeping { free, attitude, lateral };
enum class Evaluation { mean_strain, full };
enum class Fidelity { full, draft };
enum class Symmetry { off, automatic };
enum class OrbitModel { off, hill, two_body, two_body_j2 };
enum class OrbitAxes { fixed, local };

// A round cord (net or closing rope).
struct CordParameters {
  double diameter = 0.004;        // m
  double density = 1430;          // kg/m^3
  double youngs_modulus = 12e9;   // Pa
  double poisson_ratio = 0.3;     //
  double axial_damping = 1e-5;    // s, c in EA (eps + c epsdot)
  double bending_damping = 1e-2;  // s, c in EI (kappa + c kappadot)
  double compression = 1.0;       // fraction of EA that is effective in compression
};

struct PocketParameters {
  int rod_count = 8;          // rods on a regular polygon
  int mesh_columns = 6;       // cells across a panel at the kink row; also rows of the triangular part
  int mesh_rows = 6;          // rows of the square part
  int elements_per_side = 2;  // cable elements per mesh side
  double bow = 1e-3;          // rise of a mesh side at its middle, as a fraction of its length
};

struct RodParameters {
  // Polyline in the radial plane, columns (r, y) in m in the pocket frame: root, kink, tip.
  std::vector<Eigen::Vector2d> profile = {{0.6, 0.0}, {4.8, 5.3}, {7.56, 12.0}};
  double outer_diameter = 0.1;     // m
  double wall_lower = 0.0015;      // m, root to kink
  double wall_upper = 0.001;       // m, kink to tip
  double density = 164;            // kg/m^3
  double youngs_modulus = 0.75e9;  // Pa
  double poisson_ratio = 0.3;
  double axial_damping = 1e-5;    // s
  double bending_damping = 1e-5;  // s
  int elements_per_side = 0;      // number of elements between two rows of the net; 0: as many as the net has
  double pressure = 0;            // Pa, of the gas inside; 0: wrinkling is not modelled
  double hinge_stiffness = 48;    // N m/rad, of the kink
  double hinge_damping = 0.5;     // N m s/rad
  double tip_mass = 0.0;          // kg, retractor at each rod tip
};

struct SpacecraftParameters {
  double mass = 1210;                              // kg
  Eigen::Vector3d inertia = {4282, 12736, 14498};  // kg m^2, about the body axes at the centre of mass
  Eigen::Vector3d position = {0, -1, 0};           // m, position of the centre of mass
  Eigen::Vector3d size = {1.6, 2.0, 1.6};          // m, bus (box centred at the centre of mass)
  StationKeeping station_keeping = StationKeeping::free;
};

struct TargetParameters {
  TargetShape shape = TargetShape::sphere;
  double radius = 4.5;                   // m, sphere and cylinder
  Eigen::Vector3d size = {6, 6, 6};      // m, edges of a box, or of a satellite's bus
  double length = 6;                     // m, cylinder (axis: body y)
  double span = 8.4;                     // m, satellite: distance between the outer tips of its panels (along body x)
  double panel_width = 1.7;              // m, satellite: width of its panels (along body y)
  double dish_diameter = 1.6;            // m, satellite: diameter of its dish (at body +y)
  std::string mesh_file;                 // mesh: STL or OBJ file, relative to the folder of the scenario
  MeshUnit mesh_unit = MeshUnit::metre;  // mesh: unit of the file's coordinates
  double mass = 200;                     // kg
  Eigen::Vector3d inertia = {1210, 1210, 1210};       // kg m^2, body axes
  InertiaSource inertia_from = InertiaSource::given;  // shape: inertia of the shape filled evenly with the mass
  Eigen::Vector3d position = {0, 7.5, 0};             // m, position of the centre of mass
  Eigen::Vector3d attitude = {0, 0, 0};               // rad, rotation vector from world to body axes
  Eigen::Vector3d velocity = {0, 0, 0};               // m/s
  Eigen::Vector3d spin = {0, 0, 0};                   // rad/s, world axes
  Eigen::Vector3d thrust = {0, 0, 0};                 // N, of its own, body axes, through the centre of mass
  Eigen::Vector3d torque = {0, 0, 0};                 // N m, of its own, body axes
  double acts_from = 0;                               // s, thrust and torque begin
  double acts_until = 1e5;                            // s, and end
  double youngs_modulus = 70e9;                       // Pa, for the contact stiffness
  double poisson_ratio = 0.33;
};

struct ContactParameters {
  double restitution = 0.5;         // Newton's coefficient of restitution c_r
  double friction = 0.4;            // Coulomb's coefficient mu
  double friction_velocity = 1e-3;  // m/s, sliding speed from which friction is fully developed
  double edge_radius = 0;           // m, of boxes and cylinders for cords; 0: sharp edges
  bool spacecraft = true;           // whether cords touch the spacecraft
  bool cords = true;                // whether net, ropes and rods touch each other
  bool bodies = true;               // whether target and spacecraft touch each other
};

struct ClosingParameters {
  ClosingLaw law = ClosingLaw::cycloid;
  ClosingStart starts_at = ClosingStart::time;
  double start = 0;                    // s; an event starts the closing no earlier
  double distance = 8;                 // m, between the centres of spacecraft and target, for starts_at = distance
  double duration = 10;                // s
  double closed_length = 2.1;          // m, rope length between adjacent tips when closed
  std::vector<Eigen::Vector2d> table;  // (t in s after start, L in m), for law = table
  int elements = 2;                    // variable-length elements per rope

  friend bool operator==(const ClosingParameters&, const ClosingParameters&) = default;
};

struct TowingParameters {
  TowingMode mode = TowingMode::acceleration;
  TowingStart starts_at = TowingStart::time;
  double start = 10;        // s; not used by starts_at = closed
  double duration = 4;      // s, of the thrust or of the velocity ramp
  double size = 0.01;       // N, m/s^2 or m/s, by mode; pulls towards -Y
  double offset = 0.005;    // m, of the line of thrust from the axis
  double offset_angle = 0;  // rad, direction of the offset, from +X towards +Z
  double abort_force = 0;   // N, force on the target that ends the towing; 0: none does

  friend bool operator==(const TowingParameters&, const TowingParameters&) = default;
};

struct SolverParameters {
  Evaluation evaluation = Evaluation::mean_strain;
  double time_step = 0;                 // s; 0: chosen from elements and contact
  double safety = 0.9;                  // fraction of the stable step that is used
  bool pair_strains = true;             // whether pairs of elements of a mesh side share their axial strain
  Eigen::Vector3d gravity = {0, 0, 0};  // m/s^2
  double perturbation = 0;              // m, largest random displacement of free nodes at the start, by component
  int seed = 1;                         // of the perturbation's random numbers
  int most_steps = 0;                   // after which a run ends; 0: no limit
  Fidelity fidelity = Fidelity::full;   // draft: fidelity.h
  Symmetry symmetry = Symmetry::off;    // whether one sector stands for all while they are alike
};

// The orbit of the world's origin (orbit/reference_orbit.h). The world's axes do not turn.
struct OrbitParameters {
  OrbitModel model = OrbitModel::off;  // off: no gravity but solver.gravity
  double altitude = 400e3;             // m, of the perigee above the Earth's equatorial radius
  double eccentricity = 0;
  double inclination = 0;                                            // rad
  double perigee = 0;                                                // rad, from the ascending node to the perigee
  double anomaly = 0;                                                // rad, true anomaly at the start
  LocalAxis x_along = LocalAxis::h_bar, y_along = LocalAxis::v_bar;  // directions of the world's axes at the start
  // Whether velocities at the start, towing thrust and held attitude count in the world's axes or in the local axes,
  // which turn with the orbit.
  OrbitAxes axes = OrbitAxes::fixed;

  bool is_on() const { return model != OrbitModel::off; }
  bool turns() const { return is_on() && axes == OrbitAxes::local; }
};

struct OutputParameters {
  double end_time = 20;    // s
  double frame_rate = 50;  // recorded frames per simulated second
};

// The mesh of target.mesh_file as it was when a run began. The run uses it even if the file changes later. Another file
// name or unit means another mesh.
struct KeptMesh {
  std::string file;
  MeshUnit unit = MeshUnit::metre;
  std::shared_ptr<const TriangleMesh> mesh;  // null: none
};

// Where the files that a scenario names may lie. Not a parameter: it depends on where the scenario was read from.
struct FileScope {
  std::string folder;            // folder of the scenario's file; empty: none, and relative names are not found
  bool allows_absolute = false;  // set when the user named the file, on the command line
  KeptMesh kept_mesh = {};
};

struct Scenario {
  std::string name = "case1";
  std::string description;
  std::string system = "pocket";  // kind of the capture system (system_parameters.h)
  PocketParameters pocket;
  CordParameters net;
  CordParameters rope;  // closing ropes
  RodParameters rods;
  SpacecraftParameters spacecraft;
  TargetParameters target;
  ContactParameters contact;
  ClosingParameters closing;
  TowingParameters towing;
  WinchParameters winch;
  DeflationParameters deflation;
  ActuatorParameters actuators;
  OrbitParameters orbit;
  SolverParameters solver;
  OutputParameters output;
  std::vector<ControllerParameters> controllers;
  std::vector<SensorParameters> sensors;
  std::vector<ThrusterParameters> thrusters;
  std::vector<WheelParameters> wheels;
  std::vector<DisturbanceParameters> disturbances;
  // Parameters that only another kind of system has, by key. Those left out have their defaults.
  std::map<std::string, ParameterValue, std::less<>> own;
  FileScope files;
};

}  // namespace netpocket
