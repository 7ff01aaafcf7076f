// SPDX-License-Identifier: BSD-3-Clause
#include "scene_keys.h"

// Keys of the parts of the string and of their contact with hole and bottom.
namespace drill_rig_sim
{
const std::vector<const char*> part_type_words = {"bit", "mud_motor", "collar", "stabilizer", "mwd", "pipe", "rotary_steerable"};
const std::vector<const char*> stribeck_curve_words = {"gaussian", "exponential"};

namespace
{
// fields that a type of part alone has; the reader makes them when it has read the type
template <double BitSpec::*field>
double& of_bit(PartSpec& part)
{
  return (*part.bit).*field;
}
template <double MotorSpec::*field>
double& of_motor(PartSpec& part)
{
  return (*part.motor).*field;
}
double& of_blades(PartSpec& part)
{
  return part.stabilizer->blade_diameter;
}
double& of_film(PartSpec& part)
{
  return part.bit ? part.bit->squeeze_film_damping : part.stabilizer->squeeze_film_damping;
}
double& of_sensor(PartSpec& part)
{
  return part.mwd->sensor_offset;
}
template <double SteerableSpec::*field>
double& of_steerable(PartSpec& part)
{
  return (*part.steerable).*field;
}
double& of_tool_joint(PartSpec& part)
{
  return part.pipe->tool_joint_diameter;
}

constexpr unsigned bit = kind(PartType::bit), motor = kind(PartType::mud_motor), stabilizer = kind(PartType::stabilizer),
                   mwd = kind(PartType::mwd), pipe = kind(PartType::pipe), steerable = kind(PartType::rotary_steerable);
constexpr unsigned tube = every_kind & ~bit;
constexpr unsigned collar = kind(PartType::collar), jointed = pipe | collar;
}  // namespace

// clang-format off
const Table<PartSpec> part_keys = {"string[]", "One part of the drillstring; the first is the bit. Masses are in air.", {
  {"name",                  "",       &PartSpec::name,                     none,                 "unique; letters, digits and _",
      must},
  {"type",                  "",       Choice<PartSpec>{part_type_words,
      [](PartSpec& p, int word) { p.type = static_cast<PartType>(word); },
      [](const PartSpec& p) { return static_cast<int>(p.type); }},
      none, "type of the part", must},
  {"length",                "m",      &PartSpec::length,                   between(0.02, 2000.0),
      "length of a part that has no `joints`", bit | motor | stabilizer | mwd | steerable, every_kind, "joints * joint_length"},
  {"joints",                "",       CountOrFill<PartSpec>{&PartSpec::joints}, between(1, 10000),
      "number of joints; `fill` (last part only): as many as reach the surface", no_kind, jointed},
  {"joint_length",          "m",      &PartSpec::joint_length,             between(0.5, 30.0),   "length of one joint", no_kind,
      jointed, "length"},
  {"outer_diameter",        "m",      &PartSpec::outer_diameter,           between(0.01, 1.0),   "of the body", tube, tube},
  {"inner_diameter",        "m",      &PartSpec::inner_diameter,           between(0.0, 1.0),    "of the bore", tube, tube},
  {"linear_mass",           "kg/m",   &PartSpec::linear_mass,              between(0.1, 5000.0),
      "mass per length in air, tool joints included", tube, tube},
  {"young_modulus",         "Pa",     &PartSpec::young_modulus,            between(1e9, 1e12),   "Young's modulus; steel 206e9"},
  {"poisson_ratio",         "-",      &PartSpec::poisson_ratio,            between(0.0, 0.49),   "Poisson's ratio; steel 0.3"},
  {"axial_stiffness",       "N",      Inside<PartSpec>{[](PartSpec& p) -> double& { return p.stiffness.axial; }},
      between(1e3, 1e13), "axial stiffness E A. The diameters then define only contact and mud", no_kind, tube, "of the tube"},
  {"bending_stiffness",     "N m2",   Inside<PartSpec>{[](PartSpec& p) -> double& { return p.stiffness.bending; }},
      between(1e-3, 1e12), "bending stiffness E I", no_kind, tube, "of the tube"},
  {"torsional_stiffness",   "N m2",   Inside<PartSpec>{[](PartSpec& p) -> double& { return p.stiffness.torsional; }},
      between(1e-3, 1e12), "torsional stiffness G J", no_kind, tube, "of the tube"},
  {"polar_inertia",         "kg m2/m", &PartSpec::polar_inertia,           above(0.0, 1e4),
      "polar moment of inertia about the axis, in air", no_kind, tube, "of the tube with this linear_mass"},
  {"yield_strength",        "Pa",     &PartSpec::yield_strength,           between(1e6, 1e10),
      "yield strength; stress above it is reported as over_stress. Default: drill pipe of grade G-105"},
  {"make_up_torque",        "N m",    &PartSpec::make_up_torque,           between(0.0, 1e7),
      "make-up torque of the connections; torque above it is reported as over_torque; 0: unknown"},
  {"density",               "kg/m3",  &PartSpec::density,                  between(500.0, 20000.0),
      "density of the material; displaced volume = mass / density"},
  {"friction_radius",       "m",      &PartSpec::friction_radius,            above(0.0, 0.5),
      "radius at which the wall's friction acts about the axis; smaller than the contact radius for pipe with non-rotating "
      "protectors", no_kind, tube, "where it touches"},
  {"contact",               "",       Nested{},                            none,
      "wall contact law of this part, instead of the scene's"},
  {"oscillation_force",     "N",      &PartSpec::oscillation_force,        between(0.0, 2e5),
      "amplitude of the axial force by which a tool against friction shakes the string while mud flows; at the part's middle",
      no_kind, collar},
  {"oscillation_frequency", "Hz",     &PartSpec::oscillation_frequency,    between(0.1, 100.0),
      "its frequency; needs a `numerics.step` of at most a twentieth of the period", no_kind, collar},
  {"tool_joint_diameter",   "m",      Inside<PartSpec>{of_tool_joint},     between(0.01, 1.0),
      "outer diameter of the tool joints", no_kind, pipe, "outer_diameter"},
  {"blade_diameter",        "m",      Inside<PartSpec>{of_blades},         between(0.01, 1.0),   "outer diameter over the blades",
      stabilizer, stabilizer},
  {"nozzles",               "1/32 in", Nested{},                           none,
      "nozzle diameters, such as `[12, 12, 12]`; another unit must be written; needs `mud.rheology`", no_kind, bit, "none"},
  {"nozzle_area",           "m2",     Inside<PartSpec>{of_bit<&BitSpec::nozzle_area>}, between(1e-6, 0.1),
      "total flow area, instead of `nozzles`", no_kind, bit, "of the nozzles"},
  {"speed_lag",             "s",      Inside<PartSpec>{of_bit<&BitSpec::speed_lag>}, between(1e-3, 10.0),
      "time constant of the bit speed that the rate of penetration uses: the drilling law holds for averages over turns", no_kind,
      bit},
  {"squeeze_film_damping",  "N s/m",  Inside<PartSpec>{of_film},           between(0.0, 1e8),
      "damping of sideways motion by the mud squeezed between the wall and the gauge or blades (50000 by default)", no_kind,
      bit | stabilizer},
  {"sensor_offset",         "m",      Inside<PartSpec>{of_sensor},         between(0.0, 2000.0),
      "distance from the part's lower end up to the sensor", no_kind, mwd},
  {"mass",                  "kg",     Inside<PartSpec>{of_bit<&BitSpec::mass>}, between(0.1, 1e5),    "mass of the bit", bit,
      bit},
  {"diameter",              "m",      Inside<PartSpec>{of_bit<&BitSpec::diameter>}, between(0.03, 1.0),
      "gauge diameter of the bit and of the hole it drills", bit, bit},
  {"side_cutting",          "-",      Inside<PartSpec>{of_bit<&BitSpec::side_cutting>}, between(0.0, 1.0),
      "lateral over axial drillability: PDC bits 0.001 to 0.1, less with a longer gauge", no_kind, bit},
  {"gauge_length",          "m",      Inside<PartSpec>{of_bit<&BitSpec::gauge_length>}, between(0.0, 2.0),
      "length of the gauge pads, from half a diameter above the face upwards, inside the bit's length. They resist tilt of the "
      "bit and cut nothing; 0: contact of a ball, which tilts freely", no_kind, bit},
  {"gauge_clearance",       "m",      Inside<PartSpec>{of_bit<&BitSpec::gauge_clearance>}, between(0.0, 0.02),
      "radial clearance of the pads' upper end in the hole that the bit cuts; the bit tilts freely by gauge_clearance / "
      "gauge_length", no_kind, bit},
  {"torque",                "",       Nested{},                            none,                 "law of the torque on bit",
      no_kind, bit},
  {"bottom",                "",       Nested{},                            none,
      "law of the bit's contact with the hole's bottom; not with `torque: {model: regenerative}`", no_kind, bit},
  {"bend_deg",              "deg",    Inside<PartSpec>{of_motor<&MotorSpec::bend>}, between(0.0, 5.0),
      "angle of the bent housing", no_kind, motor},
  {"bit_to_bend",           "m",      Inside<PartSpec>{of_motor<&MotorSpec::bit_to_bend>}, between(0.01, 100.0),
      "distance from the bit's face to the bend; the bend is inside the motor", motor, motor},
  {"sleeve_diameter",       "m",      Inside<PartSpec>{of_motor<&MotorSpec::sleeve_diameter>}, between(0.0, 1.0),
      "diameter over the blades on the bearing housing, which turn with the string; 0: none", no_kind, motor},
  {"bit_to_sleeve",         "m",      Inside<PartSpec>{of_motor<&MotorSpec::bit_to_sleeve>}, between(0.0, 100.0),
      "distance from the bit's face to the middle of these blades, which is inside the motor", no_kind, motor},
  {"displacement_per_rev",  "m3/rev", Inside<PartSpec>{of_motor<&MotorSpec::displacement_per_rev>}, between(1e-4, 1.0),
      "mud volume that turns the motor once", motor, motor},
  {"stall_torque",          "N m",    Inside<PartSpec>{of_motor<&MotorSpec::stall_torque>}, between(1.0, 1e6),
      "torque at which the motor stalls", motor, motor},
  {"curve_exponent",        "-",      Inside<PartSpec>{of_motor<&MotorSpec::curve_exponent>}, between(1.0, 20.0),
      "exponent b of the motor's speed, N_0 (1 - (T/T_stall)^b); 1: a straight line, power sections 3 to 5", no_kind, motor},
  {"efficiency",            "-",      Inside<PartSpec>{of_motor<&MotorSpec::efficiency>}, between(0.3, 1.0),
      "mechanical efficiency: the share of the pressure's torque at the shaft; the rest is friction in rotor and bearings. "
      "Charts of power sections: 0.7 to 0.9", no_kind, motor},
  {"bit_to_pads",           "m",      Inside<PartSpec>{of_steerable<&SteerableSpec::bit_to_pads>}, between(0.01, 100.0),
      "distance from the bit's face to the pads, which are inside the tool", no_kind, steerable, "required with pad_force"},
  {"pad_force",             "N",      Inside<PartSpec>{of_steerable<&SteerableSpec::pad_force>}, above(0.0, 2e5),
      "side force on the tool at full steering (push the bit)", no_kind, steerable, "this or tilt_deg"},
  {"bit_to_pivot",          "m",      Inside<PartSpec>{of_steerable<&SteerableSpec::bit_to_pivot>}, between(0.01, 100.0),
      "distance from the bit's face to the pivot of the shaft, which is inside the tool", no_kind, steerable,
      "required with tilt_deg"},
  {"tilt_deg",              "deg",    Inside<PartSpec>{of_steerable<&SteerableSpec::tilt>}, above(0.0, 5.0),
      "tilt of the shaft against the collar at full steering, reached in 5 s (point the bit)", no_kind, steerable,
      "this or pad_force"},
  {"downlink_bit_time",     "s",      Inside<PartSpec>{of_steerable<&SteerableSpec::downlink_bit_time>}, between(1.0, 120.0),
      "length of a bit of a downlink by the pump's flow", no_kind, steerable},
}};

namespace
{
// the same keys for the three places that take a contact law; each place has its own defaults
std::vector<Key<ContactLaw>> contact_law_keys()
{
  return {
  {"stiffness",             "N/m^e",  &ContactLaw::stiffness,              between(1e3, 1e13),
      "stiffness k of F = k d^e (1 + c d')"},
  {"exponent",              "-",      &ContactLaw::exponent,               between(1.0, 3.0),    "exponent e; Hertz 1.5"},
  {"damping",               "s/m",    &ContactLaw::damping,                between(0.0, 100.0),  "damping c"},
  };
}
}  // namespace

const Table<ContactLaw> part_contact_keys = {"string[].contact", "Wall contact of one part.", contact_law_keys()};
const Table<ContactLaw> bit_bottom_keys = {"string[].bottom", "Contact of the bit with the hole's bottom.", contact_law_keys()};

const Table<ContactSpec> contact_keys = {"contact", "Contact of string and wall, F = k d^e (1 + c d'), and the shape of the "
    "friction law; `friction` of the hole sections is the kinetic coefficient.", {
  {"stiffness",             "N/m^e",  Inside<ContactSpec>{[](ContactSpec& c) -> double& { return c.law.stiffness; }},
      between(1e3, 1e13), "stiffness k"},
  {"assembly_stiffness",    "N/m^e",  &ContactSpec::assembly_stiffness,    between(1e3, 1e13),
      "least stiffness k under the bit's gauge, blades and a motor's sleeve; what they sink into the wall is lost for the bit's "
      "side force"},
  {"exponent",              "-",      Inside<ContactSpec>{[](ContactSpec& c) -> double& { return c.law.exponent; }},
      between(1.0, 3.0),  "exponent e; Hertz 1.5"},
  {"damping",               "s/m",    Inside<ContactSpec>{[](ContactSpec& c) -> double& { return c.law.damping; }},
      between(0.0, 100.0), "damping c"},
  {"stribeck_speed",        "m/s",    &ContactSpec::stribeck_speed,        between(1e-4, 10.0),
      "slip speed over which friction falls from static to kinetic"},
  {"static_ratio",          "-",      &ContactSpec::static_ratio,          between(1.0, 5.0),    "static over kinetic friction"},
  {"stribeck_curve",        "",       Choice<ContactSpec>{stribeck_curve_words,
      [](ContactSpec& c, int word) { c.stribeck_curve = static_cast<StribeckCurve>(word); },
      [](const ContactSpec& c) { return static_cast<int>(c.stribeck_curve); }},
      none, "fall of friction with slip speed v: exp(-(v/stribeck_speed)^2) or exp(-v/stribeck_speed)"},
  {"growth_at_rest",        "-",      Inside<ContactSpec>{[](ContactSpec& c) -> double& { return c.growth.per_fold; }},
      between(0.0, 5.0), "growth of static_ratio while a contact rests, for each e-fold of 1 + time/growth_time; 0: none"},
  {"growth_time",           "s",      Inside<ContactSpec>{[](ContactSpec& c) -> double& { return c.growth.time; }},
      between(1e-3, 1e6), "time at rest after which the growth is logarithmic"},
  {"growth_limit",          "-",      Inside<ContactSpec>{[](ContactSpec& c) -> double& { return c.growth.limit; }},
      between(0.0, 10.0), "largest growth of static_ratio"},
  {"tangential_stiffness",  "N/m",    &ContactSpec::tangential_stiffness,  between(1e3, 1e12),
      "stiffness of the bristle that carries sticking friction"},
  {"tangential_damping",    "-",      &ContactSpec::tangential_damping,    between(0.0, 10.0),
      "damping of that bristle, relative to critical for the mass at the contact"},
}};

// clang-format on

}  // namespace drill_rig_sim
