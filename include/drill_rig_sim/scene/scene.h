#ifndef DRILL_RIG_SIM_SCENE_SCENE_H
#define DRILL_RIG_SIM_SCENE_SCENE_H

#include <limits>
#include <string>
#include <vector>

#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/scene/numerics_spec.h"

/// What the user asked for: plain structs that mirror the scene file key by key.
/// Units are SI and radians throughout; a YAML key that ends in `_deg` or `_rpm` loses that suffix here and
/// holds radians or rad/s. A Scene that came from read_scene() has been checked; inside, values are trusted.
namespace drill_rig_sim
{
/// One station of a directional survey.
struct SurveyStation
{
  double md = 0.0;           ///< measured depth [m]
  double inclination = 0.0;  ///< from vertical down [rad], 0 .. pi
  double azimuth = 0.0;      ///< clockwise from north [rad]
};

/// A stretch of hole, from the end of the section above it down to measured depth `to`.
struct HoleSection
{
  double to = 0.0;        ///< measured depth of its lower end [m]
  double diameter = 0.0;  ///< [m]
  double friction = 0.0;  ///< kinetic friction coefficient, pipe on wall [-]
};

struct WellSpec
{
  std::vector<SurveyStation> survey;  ///< from `survey` (a CSV file) or `stations`; strictly increasing md, first at md 0
  double hole_depth = 0.0;            ///< measured depth of the hole's bottom [m]; at most the last station's md
  std::vector<HoleSection> sections;  ///< top down; the last reaches at least hole_depth
};

/// Rock between the layer above and `to_tvd`. ROP = drillability (weight - threshold)^weight_exponent bit_speed^speed_exponent.
struct FormationLayer
{
  double to_tvd = 0.0;           ///< true vertical depth of its base [m]
  double drillability = 0.0;     ///< K [m/s; N; rad/s]
  double weight_exponent = 1.0;  ///< alpha [-]
  double speed_exponent = 1.0;   ///< beta [-]
  double threshold = 0.0;        ///< F_0 [N]
  double dip = 0.0;              ///< bed dip below horizontal [rad]
  double strike = 0.0;           ///< azimuth of the strike, dip to its right [rad]
  double anisotropy = 0.0;       ///< h in [0, 1); 0 = isotropic
};

struct MudSpec
{
  double density = 1150.0;          ///< [kg/m3]
  double axial_damping = 0.0;       ///< [N s/m per m]
  double lateral_damping = 20.0;    ///< [N s/m per m]
  double torsional_damping = 5e-4;  ///< [N m s/rad per m]
  double added_mass = 1.0;          ///< factor on the displaced mud's mass, lateral motion only [-]
};

/// Hertz stiffness with Hunt-Crossley damping: F = stiffness delta^exponent (1 + damping delta').
struct ContactLaw
{
  double stiffness = 5e7;  ///< [N/m^exponent]
  double exponent = 1.5;   ///< [-], 1 .. 3
  double damping = 0.3;    ///< [s/m]
};

/// Wall contact of the whole string unless a part sets its own law, and the friction law's shape.
struct ContactSpec
{
  ContactLaw law;
  double stribeck_speed = 0.05;       ///< slip speed over which friction falls from static to kinetic [m/s]
  double static_ratio = 1.2;          ///< static / kinetic friction [-], >= 1
  double tangential_stiffness = 5e6;  ///< of the bristle that carries sticking friction [N/m]
};

enum class PartType
{
  bit,
  mud_motor,
  collar,
  stabilizer,
  mwd,
  pipe
};

enum class BitTorqueModel
{
  stribeck,  ///< T = mu_b(omega) F D / 3 with mu_b falling from static to kinetic
  detournay  ///< T = cutting energy * a^2 d / 2 + wear-flat friction
};

struct BitTorqueSpec
{
  BitTorqueModel model = BitTorqueModel::stribeck;
  double static_friction = 0.6;   ///< YAML `static` [-]
  double kinetic_friction = 0.4;  ///< YAML `kinetic` [-]
  double speed = 30.0 * rpm;      ///< YAML `speed_rpm`: bit speed over which it falls [rad/s]
  double cutting_energy = 60e6;   ///< detournay: intrinsic specific energy epsilon [J/m3]
  double wear_friction = 0.6;     ///< detournay: mu * gamma of the wear flat [-]
  double wear_weight = 0.0;       ///< detournay: weight carried by the wear flats [N]
};

/// One entry of the `string` list; entries go from the bit up. Values that a type does not use stay at their defaults.
struct PartSpec
{
  std::string name;
  PartType type = PartType::collar;
  double length = 0.0;          ///< of the whole part if it has no joints [m]
  int joints = 1;               ///< number of joints; 0 means `fill`: as many as reach the surface
  double joint_length = 0.0;    ///< [m]; equal to length where the part has no joints
  double outer_diameter = 0.0;  ///< [m]
  double inner_diameter = 0.0;  ///< [m]
  double linear_mass = 0.0;     ///< in air [kg/m]
  double young_modulus = 206e9;
  double poisson_ratio = 0.3;
  double density = 7850.0;           ///< of its material: displaced volume = linear mass / density [kg/m3]
  double tool_joint_diameter = 0.0;  ///< pipe: at its joints' ends; 0 = outer diameter [m]
  double blade_diameter = 0.0;       ///< stabilizer [m]
  double squeeze_film_damping = 5e4;         ///< bit, stabilizer: lateral, by the mud squeezed between gauge or blades and wall [N s/m]
  double sensor_offset = 0.0;        ///< mwd: from the part's lower end up to the sensor [m]
  bool has_contact = false;          ///< true where the part sets its own wall contact law
  ContactLaw contact;

  // bit only
  double mass = 0.0;          ///< [kg]
  double diameter = 0.0;      ///< gauge [m]
  double side_cutting = 0.0;  ///< i_b in [0, 1]
  BitTorqueSpec torque;
  ContactLaw bottom{1e9, 1.5, 1.0};  ///< bit against the hole's bottom

  // mud motor only
  double bend = 0.0;                  ///< angle of the bent housing [rad]
  double bit_to_bend = 0.0;           ///< from the bit's face to the bend [m]
  double displacement_per_rev = 0.0;  ///< [m3/rev]
  double stall_torque = 0.0;          ///< [N m]
};

struct HoistingSpec
{
  int sheaves = 5;              ///< n in the travelling block; 2 n lines
  double line_ea = 4e7;         ///< E A of the drill line [N]
  double crown_height = 46.0;   ///< of the crown block above the rotary table [m]
  double fixed_length = 60.0;   ///< strung length outside the block: fast and dead line [m]
  double block_mass = 17500.0;  ///< travelling block, hook and top drive [kg]
  double sheave_efficiency = 0.98;
  double max_speed = 1.5;         ///< of the block [m/s]
  double max_acceleration = 0.5;  ///< of the block [m/s2]
  double max_hook_load = 2.5e6;   ///< [N]
  double lowest_block_height = 1.0;
  double highest_block_height = 40.0;
};

struct TopDriveSpec
{
  double inertia = 2500.0;             ///< [kg m2]
  double proportional_gain = 20000.0;  ///< [N m s/rad]
  double integral_gain = 5000.0;       ///< [N m/rad]
  double max_torque = 50000.0;         ///< [N m]
  double max_speed = 220.0 * rpm;      ///< [rad/s]
  double max_power = 750e3;            ///< [W]
  double meter_stiffness = 1e6;        ///< torque meter spring [N m/rad]
};

struct MudPumpSpec
{
  double max_flow = 0.06;             ///< [m3/s]
  double pressure_coefficient = 4e9;  ///< stand-pipe pressure / flow^2 [Pa s2/m6]
};

struct RigSpec
{
  HoistingSpec hoisting;
  TopDriveSpec top_drive;
  MudPumpSpec mud_pump;
};

struct TrajectorySpec
{
  double stage_two_length = 0.1;  ///< drilled length between second-stage corrections [m]; used when stage_two_steps is 0
  int stage_two_steps = 0;        ///< or every so many physics steps, as the paper counts
};

struct StartSpec
{
  double bit_depth = 0.0;      ///< [m MD]
  double block_height = 30.0;  ///< top-drive shaft above the rotary table [m]
  double weight_on_bit = 0.0;  ///< [N]
  double torque_on_bit = 0.0;  ///< [N m]
  double toolface = 0.0;       ///< of the bend, after the equilibrium [rad]
};

struct SensorSpec
{
  double noise = 0.0;        ///< standard deviation [unit of the signal]
  double bias = 0.0;         ///< [unit of the signal]
  double delay = 0.0;        ///< [s]
  double filter_time = 0.0;  ///< first-order time constant [s]
};

struct MwdSpec
{
  double period = 30.0;                 ///< between surveys [s]; 0 = only after a pumps-off/on cycle
  double latency = 8.0;                 ///< measurement to surface [s]
  double inclination_resolution = 0.0;  ///< [rad]
  double noise = 0.0;                   ///< standard deviation of inclination and azimuth [rad]
  double scribe_offset = 0.0;           ///< added to the sensor's toolface to name the bend's [rad]
};

struct ToolfaceSpec
{
  double period = 10.0;  ///< [s]
  double latency = 4.0;  ///< [s]
};

struct InstrumentsSpec
{
  MwdSpec mwd;
  ToolfaceSpec toolface;
  SensorSpec hook_load;            ///< dead-line sensor [N]
  SensorSpec torque;               ///< torque meter [N m]
  SensorSpec stand_pipe_pressure;  ///< [Pa]
};

enum class Connections
{
  off,
  automatic
};

/// One line of the scene's program: set points at a simulated time; NaN means "not set by this line".
struct ProgramStep
{
  static constexpr double unset = std::numeric_limits<double>::quiet_NaN();
  double at = 0.0;                  ///< simulated time [s]
  double block_velocity = unset;    ///< [m/s], + up; releases the brake
  double top_drive_speed = unset;   ///< [rad/s]
  double top_drive_torque = unset;  ///< [N m]: torque mode
  double flow = unset;              ///< [m3/s]
  double brake = unset;             ///< 1 sets, 0 releases
};

struct Scene
{
  std::string name;
  std::string file;  ///< where it was read from; empty if built in code
  WellSpec well;
  std::vector<FormationLayer> formation;
  MudSpec mud;
  std::vector<PartSpec> string;
  RigSpec rig;
  ContactSpec contact;
  TrajectorySpec trajectory;
  StartSpec start;
  NumericsSpec numerics;
  InstrumentsSpec instruments;
  Connections connections = Connections::off;
  std::vector<ProgramStep> program;
};

}  // namespace drill_rig_sim

#endif
