// SPDX-License-Identifier: BSD-3-Clause
#include "scene_keys.h"

// Keys of the rig above the rotary table.
namespace drill_rig_sim
{
// clang-format off
const Table<RigSpec> rig_keys = {"rig", "The rig above the rotary table.", {
  {"hoisting",              "",       Nested{},                            none,                 "drill line, block and winch"},
  {"top_drive",             "",       Nested{},                            none,                 "rotary drive and torque meter"},
  {"mud_pump",              "",       Nested{},                            none,                 "pump and stand pipe"},
  {"heave",                 "",       Nested{},                            none,                 "waves under a floating rig"},
  {"plc_latency",           "s",      &RigSpec::plc_latency,               between(0.0, 2.0),
      "dead time of the rig's controller: set points of winch, top drive, pump and steering act so much later; `rig_state` "
      "shows those that act. Interlocks and faults act at once"},
}};

const Table<HoistingSpec> hoisting_keys = {"rig.hoisting", "Drill line, travelling block and winch.", {
  {"sheaves",               "",       &HoistingSpec::sheaves,              between(1, 12),
      "number of sheaves in the travelling block; the number of lines is twice as large"},
  {"line_ea",               "N",      &HoistingSpec::line_ea,              between(1e5, 1e10),
      "axial stiffness E A of the drill line"},
  {"crown_height",          "m",      &HoistingSpec::crown_height,         between(5.0, 200.0),
      "height of the crown block above the rotary table"},
  {"fixed_length",          "m",      &HoistingSpec::fixed_length,         between(0.0, 1000.0),
      "length of line outside the block: fast and dead line"},
  {"block_mass",            "kg",     &HoistingSpec::block_mass,           between(1.0, 3e5),
      "mass of travelling block and top drive"},
  {"sheave_efficiency",     "-",      &HoistingSpec::sheave_efficiency,    between(0.8, 1.0),    "efficiency of one sheave"},
  {"rail_friction",         "-",      &HoistingSpec::rail_friction,        between(0.0, 0.5),
      "friction of the block on its guide rail, relative to its weight"},
  {"line_damping",          "-",      &HoistingSpec::line_damping,         between(0.0, 1.0),
      "damping of the empty block on its lines, relative to critical"},
  {"latency",               "s",      &HoistingSpec::latency,              between(0.0, 2.0),
      "dead time of the drawworks' drive: the winch's set point acts so much later, beyond rig.plc_latency"},
  {"max_speed",             "m/s",    &HoistingSpec::max_speed,            between(0.001, 20.0), "largest speed of the block"},
  {"max_acceleration",      "m/s2",   &HoistingSpec::max_acceleration,     between(0.001, 50.0),
      "largest acceleration of the block"},
  {"max_hook_load",         "N",      &HoistingSpec::max_hook_load,        between(1e3, 5e7),
      "largest pull of the winch, as hook load"},
  {"min_hook_load",         "N",      &HoistingSpec::min_hook_load,        between(0.0, 5e7),
      "the winch stops lowering below this hook load (slack line); 0: never"},
  {"trip_hook_load",        "N",      &HoistingSpec::trip_hook_load,       between(0.0, 5e7),
      "over-pull limit: when `hook_load` of `rig_state` reaches it while raising, the brake is set until a command that does "
      "not raise; 0: never"},
  {"lowest_block_height",   "m",      &HoistingSpec::lowest_block_height,  between(0.0, 200.0),
      "lowest height of the top-drive shaft above the rotary table"},
  {"highest_block_height",  "m",      &HoistingSpec::highest_block_height, between(0.0, 200.0),
      "largest height of the top-drive shaft above the rotary table, below crown_height"},
  {"connection_time",       "s",      &HoistingSpec::connection_time,      between(1.0, 3600.0),
      "time for which the string is in the slips and broken out while pipe is added or removed. The block travels for half of "
      "it, longer where its limits require it"},
  {"stand_joints",          "",       &HoistingSpec::stand_joints,         between(1, 4),
      "number of joints of the last part in a stand"},
}};

const Table<TopDriveSpec> top_drive_keys = {"rig.top_drive",
    "Rotary drive with a PI speed loop, and the spring of the torque meter.", {
  {"inertia",               "kg m2",  &TopDriveSpec::inertia,              between(1.0, 1e6),
      "moment of inertia of the rotor, at the shaft"},
  {"proportional_gain",     "N m s/rad", &TopDriveSpec::proportional_gain, between(0.0, 1e7),
      "proportional gain of the speed loop"},
  {"integral_gain",         "N m/rad", &TopDriveSpec::integral_gain,       between(0.0, 1e7),
      "integral gain of the speed loop"},
  {"max_torque",            "N m",    &TopDriveSpec::max_torque,           between(1.0, 1e6),    "largest torque of the drive"},
  {"max_speed_rpm",         "rpm",    &TopDriveSpec::max_speed,            between(1.0, 1000.0), "largest speed of the drive"},
  {"max_acceleration_rpm",  "rpm/s",  &TopDriveSpec::max_acceleration,     between(0.0, 1e4),
      "largest acceleration of the speed set point; 0: no limit (ANGLE and OSCILLATE: 2 rad/s2)"},
  {"max_power",             "W",      &TopDriveSpec::max_power,            between(1e3, 1e8),    "largest power of the drive"},
  {"meter_stiffness",       "N m/rad", &TopDriveSpec::meter_stiffness,     between(1e3, 1e9),
      "stiffness of the torque meter's spring"},
  {"gearbox_friction",      "N m",    &TopDriveSpec::gearbox_friction,     between(0.0, 1e5),
      "friction torque of the gearbox"},
  {"brake_torque",          "N m",    &TopDriveSpec::brake_torque,         between(0.0, 1e6),
      "torque of the brake, which is set at a set point of 0 when the rotor stands; 0: no brake"},
  {"soft_torque",           "",       Nested{},                            none,                 "settings of mode SOFT_TORQUE"},
  {"z_torque",              "",       Nested{},                            none,                 "settings of mode Z_TORQUE"},
}};

namespace
{
std::vector<Key<DriveImpedance>> impedance_rows(const char* damping, const char* stiffness)
{
  return {
  {"damping",               "N m s/rad", &DriveImpedance::damping,         between(0.0, 1e6),    "damping P; 0: the default",
      no_kind, every_kind, damping},
  {"stiffness",             "N m/rad", &DriveImpedance::stiffness,         between(0.0, 1e6),    "stiffness I; 0: the default",
      no_kind, every_kind, stiffness},
  {"inertia_compensation",  "-",      &DriveImpedance::inertia_compensation, between(0.0, 0.99),
      "c: share of the rotor's inertia that the drive compensates by feedback of the torque meter"},
  };
}
}  // namespace

const Table<DriveImpedance> soft_torque_keys = {"rig.top_drive.soft_torque",
    "In mode SOFT_TORQUE the drive acts on the string as the impedance P + s (1 - c) inertia + I/s.",
    impedance_rows("twice the pipe's impedance",
    "what cancels the inertia left at the string's lowest torsional frequency, at 1 Hz where that is higher")};

const Table<DriveImpedance> z_torque_keys = {"rig.top_drive.z_torque",
    "As SOFT_TORQUE, with most of the rotor's inertia compensated, so that it damps over a wide band of frequencies.",
    impedance_rows("the pipe's impedance", "P w / 8, with w the string's lowest torsional frequency, at most 1 Hz")};

const Table<MudPumpSpec> mud_pump_keys = {"rig.mud_pump", "Pump and stand pipe.", {
  {"max_flow",              "m3/s",   &MudPumpSpec::max_flow,              above(0.0, 1.0),      "largest flow of the pump"},
  {"flow_ramp",             "m3/s2",  &MudPumpSpec::flow_ramp,             above(0.0, 1000.0),
      "largest rate of change of the pump's flow"},
  {"stroke_volume",         "m3",     &MudPumpSpec::stroke_volume,         between(1e-4, 0.1),
      "volume of a stroke; default: two triplex pumps side by side, 6 in liners and 12 in strokes, 95 % full"},
  {"relief_pressure",       "Pa",     &MudPumpSpec::relief_pressure,       between(1e5, 2e8),
      "pressure at which the relief valve at the pump opens; the flow that it takes returns to the tanks"},
  {"trip_pressure",         "Pa",     &MudPumpSpec::trip_pressure,         between(0.0, 2e8),
      "when `stand_pipe_pressure` of `rig_state` reaches this pressure the pump stops until a flow of 0 is commanded; 0: never"},
  {"surface_lines",         "m",      Nested{},                            none,
      "pipes between pump and string, rows [length, diameter]: standpipe, hose, swivel or wash pipe, kelly; needs `mud.rheology`",
      no_kind, every_kind, "none"},
  {"pressure_coefficient",  "Pa s2/m6", &MudPumpSpec::pressure_coefficient, between(0.0, 1e12),
      "pressure loss of string, bit and annulus at max_flow, divided by max_flow^2"},
  {"loss_exponent",         "-",      &MudPumpSpec::loss_exponent,         between(1.0, 2.0),
      "exponent m: losses at other flows are proportional to Q^m; 2 rough turbulence, 1.86 smooth, a field record 1.56"},
}};

const Table<HeaveSpec> heave_keys = {"rig.heave", "Waves under a floating rig without a heave compensator. Floor, winch, rail "
    "and slips move together on regular waves, which grow from rest within five periods. Heights of the block are above the "
    "floor; `floor_height` and `floor_velocity` of `rig_state` are the floor's. A block at its lowest or highest position moves "
    "against its stop (`stop_reached`). `tare` and operations use the average hook load over a period; topics carry the "
    "momentary one, which `instruments.surface.hook_load.filter_time` smooths. Surge and swab pressures are those of friction; "
    "the mud's inertia, as large again in a deep well, is added by `mud.pressure_waves`. For a rig with a "
    "compensator give the remaining amplitude; pipe in the slips then heaves too little.", {
  {"amplitude",             "m",      &HeaveSpec::amplitude,               between(0.0, 10.0),
      "amplitude about the mean height of the rotary table, where depths begin; acceleration at most 3 m/s2; 0: a rig on land"},
  {"period",                "s",      &HeaveSpec::period,                  between(2.0, 60.0),   "period of the waves"},
}};

// clang-format on

}  // namespace drill_rig_sim
