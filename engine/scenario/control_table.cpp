#include "engine/scenario/control_table.h"

#include <array>

#include "engine/scenario/parameter_row.h"

namespace netpocket {

using namespace std::string_view_literals;

namespace parameter_rows {

template <>
constexpr std::array kNames<ControllerKind> = {"attitude_pd"sv, "attitude_sliding_mode"sv, "attitude_double_loop"sv,
                                               "position_pd"sv, "position_sliding_mode"sv, "tow"sv,
                                               "spin_damping"sv};
template <>
constexpr std::array kNames<ControlPhase> = {"always"sv, "open"sv, "closing"sv, "closed"sv, "towing"sv, "off"sv};
template <>
constexpr std::array kNames<ControlledAxes> = {"all"sv, "lateral"sv, "axial"sv};
template <>
constexpr std::array kNames<TowQuantity> = {"speed"sv, "separation"sv};
template <>
constexpr std::array kNames<SensorKind> = {"attitude"sv,      "angular_velocity"sv, "position"sv,
                                           "velocity"sv,      "target_position"sv,  "target_velocity"sv,
                                           "contact_force"sv, "rope_tension"sv};
template <>
constexpr std::array kNames<ActuatorKind> = {"ideal"sv, "box"sv, "thrusters"sv};
template <>
constexpr std::array kNames<DeflationStart> = {"never"sv, "time"sv, "closing"sv, "closed"sv};
template <>
constexpr std::array kNames<WinchDrive> = {"prescribed"sv, "length"sv, "rate"sv, "tension"sv, "torque"sv};
template <>
constexpr std::array kNames<DisturbedBody> = {"spacecraft"sv, "target"sv};

}  // namespace parameter_rows

namespace {

using namespace parameter_rows;

using S = Scenario;
using Controller = ControllerParameters;
using Sensor = SensorParameters;
using Actuators = ActuatorParameters;
using Thruster = ThrusterParameters;
using Wheel = WheelParameters;
using Winch = WinchParameters;
using Deflated = DeflationParameters;
using Disturbance = DisturbanceParameters;

constexpr auto kControllers = &S::controllers;
constexpr auto kSensors = &S::sensors;
constexpr auto kThrusters = &S::thrusters;
constexpr auto kWheels = &S::wheels;
constexpr auto kDisturbances = &S::disturbances;
constexpr auto kActuators = &S::actuators;
constexpr auto kWinch = &S::winch;
constexpr auto kDeflation = &S::deflation;

constexpr std::array kControlGroups = {
    ParameterGroup{"winch", "Winches", "Retractors of the closing ropes, as drums with motor and brake."},
    ParameterGroup{"deflation", "Deflation", "Gas that is let out of the rods, so that they bend more easily."},
    ParameterGroup{"actuators", "Actuators",
                   "What exerts the forces and torques that the spacecraft's controllers demand."},
};

// clang-format off
constexpr std::array kControlParameters = {
    parameter<kWinch, &Winch::drive>("winch.drive", kNone, "", "prescribed: ropes follow closing.law exactly; length: motors follow it; rate, tension, torque: motors keep winch.rate, winch.tension or winch.torque from closing.start until the rope has its closed length", kAssumption),
    parameter<kWinch, &Winch::rate>("winch.rate", within(0, 100), "m/s", "speed of winding in, for the drive rate", kAssumption),
    parameter<kWinch, &Winch::tension>("winch.tension", within(0, 1e6), "N", "tension to be kept, for the drive tension", kAssumption),
    parameter<kWinch, &Winch::torque>("winch.torque", within(0, 1e6), "N m", "torque of the motors, for the drive torque", kAssumption),
    parameter<kWinch, &Winch::drum_radius>("winch.drum_radius", within(1e-3, 10), "m", "radius of a drum", kAssumption),
    parameter<kWinch, &Winch::drum_inertia>("winch.drum_inertia", within(1e-6, 1e4), "kg m^2", "moment of inertia of drum, gears and motor, referred to the drum", kAssumption),
    parameter<kWinch, &Winch::most_torque>("winch.most_torque", within(0, 1e6), "N m", "largest torque of a motor, at the drum", kAssumption),
    parameter<kWinch, &Winch::brake_torque>("winch.brake_torque", within(0, 1e6), "N m", "largest torque of a brake; brakes are on before the closing", kAssumption),
    parameter<kWinch, &Winch::fastest>("winch.fastest", within(0, 100), "m/s", "largest rate that a loop asks of its motor", kAssumption),
    parameter<kWinch, &Winch::rate_gain>("winch.rate_gain", within(0, 1e6), "N s/m", "proportional gain of the loop of the rate", kAssumption),
    parameter<kWinch, &Winch::rate_integral>("winch.rate_integral", within(0, 1e6), "N/m", "integral gain of the loop of the rate", kAssumption),
    parameter<kWinch, &Winch::length_gain>("winch.length_gain", within(0, 1e3), "1/s", "wanted rate by error of the length, for the drive length", kAssumption),
    parameter<kWinch, &Winch::tension_gain>("winch.tension_gain", within(0, 1e3), "m/(N s)", "wanted rate by error of the tension, for the drive tension", kAssumption),
    parameter<kWinch, &Winch::tension_derivative>("winch.tension_derivative", within(0, 1e3), "m/N", "wanted rate by rate of the tension, for the drive tension", kAssumption),
    parameter<kWinch, &Winch::take_up_rate>("winch.take_up_rate", within(0, 100), "m/s", "speed at which a slack rope is taken up at least, for the drive tension", kAssumption),
    parameter<kWinch, &Winch::late>("winch.late", within(0, 1e5), "1, s", "[rope, delay]: ropes that start later than the others; not for the drive prescribed", kChoice),
    parameter<kWinch, &Winch::jammed>("winch.jammed", within(0, 1e5), "1, s", "[rope, time]: ropes whose retractor jams at a time; not for the drive prescribed", kChoice),

    parameter<kDeflation, &Deflated::starts_at>("deflation.starts_at", kNone, "", "what starts the deflation: never; the time deflation.start; the closing's start or its end, and deflation.start after it", kChoice),
    parameter<kDeflation, &Deflated::start>("deflation.start", within(0, 1e5), "s", "time of the deflation, or how long after its event it starts", kChoice),
    parameter<kDeflation, &Deflated::rate>("deflation.rate", above(0, 1e9), "Pa/s", "rate at which the pressure falls", kAssumption),
    parameter<kDeflation, &Deflated::pressure>("deflation.pressure", above(0, 1e9), "Pa", "pressure that stays; less than rods.pressure", kAssumption),

    parameter<kActuators, &Actuators::kind>("actuators.kind", kNone, "", "ideal: exert at once what is demanded; box: within limits by component; thrusters: those of the list actuators.thruster. Wheels, if any, take the torque", kAssumption),
    parameter<kActuators, &Actuators::most_force>("actuators.most_force", within(0, 1e7), "N", "box: largest size of each component of the force, body axes", kAssumption),
    parameter<kActuators, &Actuators::most_torque>("actuators.most_torque", within(0, 1e7), "N m", "box: largest size of each component of the torque, body axes", kAssumption),
    parameter<kActuators, &Actuators::time_constant>("actuators.time_constant", within(0, 100), "s", "first-order lag of the box or of the thrusters' valves; 0: none", kAssumption),
    parameter<kActuators, &Actuators::impulse_bit>("actuators.impulse_bit", within(0, 1e4), "N s", "thrusters: least impulse of a pulse; 0: any", kAssumption),
    parameter<kActuators, &Actuators::specific_impulse>("actuators.specific_impulse", within(1, 1e5), "s", "specific impulse, for the propellant", "assumption: hydrazine"),
};

constexpr std::array kControllerRows = {
    item_parameter<kControllers, &Controller::kind>("controller.kind", kNone, "", "what it controls, and how; of the spacecraft", kChoice),
    item_parameter<kControllers, &Controller::phase>("controller.phase", kNone, "", "phase of the capture in which it acts", kChoice),
    item_parameter<kControllers, &Controller::rate>("controller.rate", above(0, 1e4), "Hz", "rate of its samples; its demand is held in between", kAssumption),
    item_parameter<kControllers, &Controller::attitude>("controller.attitude", within(-10, 10), "rad", "attitude: wanted rotation vector from world to body axes", kChoice),
    item_parameter<kControllers, &Controller::position>("controller.position", within(-1e4, 1e4), "m", "position: wanted place of the centre of mass, from its place at the start", kChoice),
    item_parameter<kControllers, &Controller::velocity>("controller.velocity", within(-100, 100), "m/s", "position: velocity at which the wanted place moves", kChoice),
    item_parameter<kControllers, &Controller::axes>("controller.axes", kNone, "", "position: all; lateral: x and z; axial: y", kChoice),
    item_parameter<kControllers, &Controller::frequency>("controller.frequency", within(0, 1e3), "rad/s", "PD: natural frequency of the loop", kAssumption),
    item_parameter<kControllers, &Controller::damping_ratio>("controller.damping_ratio", within(0, 100), "", "PD: damping ratio of the loop", kAssumption),
    item_parameter<kControllers, &Controller::slope>("controller.slope", within(0, 1e3), "1/s", "sliding mode, double loop's outer loop: rate at which the error decays", kAssumption),
    item_parameter<kControllers, &Controller::reaching>("controller.reaching", within(0, 1e3), "1/s", "sliding mode: rate at which the surface is reached", kAssumption),
    item_parameter<kControllers, &Controller::switching>("controller.switching", within(0, 1e3), "rad/s^2, m/s^2", "sliding mode: acceleration towards the surface; more than the disturbance keeps the state on it", kAssumption),
    item_parameter<kControllers, &Controller::layer>("controller.layer", within(0, 10), "rad/s, m/s", "sliding mode: boundary layer in which the switching is linear", kAssumption),
    item_parameter<kControllers, &Controller::observer>("controller.observer", within(0, 1e3), "rad/s", "sliding mode: bandwidth of the extended state observer; 0: none", kAssumption),
    item_parameter<kControllers, &Controller::feed_forward>("controller.feed_forward", kNone, "", "sliding mode: cancels the force of the target on the pocket, taken to act through the target's centre of mass", kAssumption),
    item_parameter<kControllers, &Controller::outer_switching>("controller.outer_switching", within(0, 10), "rad/s", "double loop: switching rate of the outer loop", kAssumption),
    item_parameter<kControllers, &Controller::outer_layer>("controller.outer_layer", within(0, 10), "rad", "double loop: boundary layer of the outer loop", kAssumption),
    item_parameter<kControllers, &Controller::fastest>("controller.fastest", within(0, 10), "rad/s", "double loop: largest wanted rate by component", kAssumption),
    item_parameter<kControllers, &Controller::quantity>("controller.quantity", kNone, "", "tow: speed of the spacecraft along -Y, or separation of the centres of spacecraft and target", kChoice),
    item_parameter<kControllers, &Controller::wanted>("controller.wanted", within(-1e4, 1e4), "m/s or m by quantity", "tow: wanted value of the quantity", kChoice),
    item_parameter<kControllers, &Controller::ramp>("controller.ramp", within(1e-3, 1e5), "s", "tow: time in which the quantity goes to the wanted value", kAssumption),
    item_parameter<kControllers, &Controller::proportional>("controller.proportional", within(0, 1e7), "N s/m or N/m", "tow: thrust by error of the quantity", kAssumption),
    item_parameter<kControllers, &Controller::integral>("controller.integral", within(0, 1e7), "N/m or N/(m s)", "tow: thrust by integral of the error", kAssumption),
    item_parameter<kControllers, &Controller::derivative>("controller.derivative", within(0, 1e7), "N s/m", "tow: thrust by rate of the error of the separation", kAssumption),
    item_parameter<kControllers, &Controller::most_tension>("controller.most_tension", within(0, 1e7), "N", "tow: cap of the force that pulls the target; 0: none", kAssumption),
    item_parameter<kControllers, &Controller::damping>("controller.damping", within(0, 1e7), "N m s/rad", "spin damping: torque by angular velocity", kAssumption),
    item_parameter<kControllers, &Controller::most_torque>("controller.most_torque", within(0, 1e7), "N m", "spin damping: largest torque", kAssumption),
};

constexpr std::array kSensorRows = {
    item_parameter<kSensors, &Sensor::kind>("sensor.kind", kNone, "", "measured quantity: of the spacecraft, the target, the force on the target, or the tension of each closing rope", kChoice),
    item_parameter<kSensors, &Sensor::rate>("sensor.rate", above(0, 1e4), "Hz", "rate of its samples", kAssumption),
    item_parameter<kSensors, &Sensor::noise>("sensor.noise", within(0, 1e4), "rad, rad/s, m, m/s or N", "standard deviation of the white noise of each component", kAssumption),
    item_parameter<kSensors, &Sensor::bias>("sensor.bias", within(-1e4, 1e4), "rad, rad/s, m, m/s or N", "constant error by component; a rope's tension has the first", kAssumption),
    item_parameter<kSensors, &Sensor::delay>("sensor.delay", within(0, 100), "s", "time from a sample to its arrival", kAssumption),
    item_parameter<kSensors, &Sensor::dropout>("sensor.dropout", within(0, 1), "", "probability that a sample is lost", kAssumption),
    item_parameter<kSensors, &Sensor::seed>("sensor.seed", within(0, 2147483647), "", "seed of noise and dropouts", kAssumption),
};

constexpr std::array kThrusterRows = {
    item_parameter<kThrusters, &Thruster::position>("actuators.thruster.position", within(-100, 100), "m", "place of the nozzle from the spacecraft's centre of mass, body axes", kChoice),
    item_parameter<kThrusters, &Thruster::direction>("actuators.thruster.direction", within(-1e3, 1e3), "", "direction of the force on the spacecraft, body axes; any length but 0", kChoice),
    item_parameter<kThrusters, &Thruster::thrust>("actuators.thruster.thrust", above(0, 1e6), "N", "thrust when it fires", kAssumption),
};

constexpr std::array kWheelRows = {
    item_parameter<kWheels, &Wheel::axis>("actuators.wheel.axis", within(-1e3, 1e3), "", "axis, body axes; any length but 0", kChoice),
    item_parameter<kWheels, &Wheel::most_torque>("actuators.wheel.most_torque", above(0, 1e6), "N m", "largest torque", kAssumption),
    item_parameter<kWheels, &Wheel::most_momentum>("actuators.wheel.most_momentum", above(0, 1e6), "N m s", "largest momentum relative to the spacecraft", kAssumption),
};

constexpr std::array kDisturbanceRows = {
    item_parameter<kDisturbances, &Disturbance::body>("disturbance.body", kNone, "", "body on which it acts", kChoice),
    item_parameter<kDisturbances, &Disturbance::force>("disturbance.force", within(-1e7, 1e7), "N", "force through the body's centre of mass, body axes", kChoice),
    item_parameter<kDisturbances, &Disturbance::torque>("disturbance.torque", within(-1e7, 1e7), "N m", "torque, body axes", kChoice),
    item_parameter<kDisturbances, &Disturbance::start>("disturbance.start", within(0, 1e5), "s", "time at which it begins", kChoice),
    item_parameter<kDisturbances, &Disturbance::duration>("disturbance.duration", above(0, 1e5), "s", "how long it acts", kChoice),
};
// clang-format on

template <auto List>
constexpr ParameterList list(std::string_view name, std::string_view title, std::string_view help,
                             std::span<const Parameter> rows) {
  return {.name = name,
          .title = title,
          .help = help,
          .rows = rows,
          .size = [](const Scenario& scenario) { return (scenario.*List).size(); },
          .resize = [](Scenario& scenario, std::size_t size) { (scenario.*List).resize(size); }};
}

constexpr std::array kControlLists = {
    list<kControllers>("controller", "Controllers",
                       "Controllers of the spacecraft. Their demands add up, and the actuators exert them.",
                       kControllerRows),
    list<kSensors>("sensor", "Sensors",
                   "What controllers know of a quantity. A quantity without a sensor is known exactly.", kSensorRows),
    list<kThrusters>("actuators.thruster", "Thrusters", "Thrusters of the spacecraft.", kThrusterRows),
    list<kWheels>("actuators.wheel", "Reaction wheels", "Reaction wheels of the spacecraft.", kWheelRows),
    list<kDisturbances>("disturbance", "Disturbances",
                        "Forces and torques that act on a body for a while, to see how controllers answer.",
                        kDisturbanceRows),
};

}  // namespace

std::span<const Parameter> control_parameters() { return kControlParameters; }

std::span<const ParameterGroup> control_groups() { return kControlGroups; }

std::span<const ParameterList> control_lists() { return kControlLists; }

}  // namespace netpocket
