// SPDX-License-Identifier: BSD-3-Clause
#include "scene_keys.h"

// Keys of the start, of the correction of the path and of the solver.
namespace drill_rig_sim
{
const std::vector<const char*> level_words = {"rigid", "axial_torsional", "hybrid", "beam3d", "auto"};
const std::vector<const char*> integrator_words = {
    "auto", "bdf2", "implicit_euler", "linearly_implicit_euler", "trbdf2", "generalised_alpha", "explicit", "arkode_dirk", "ida"};
const std::vector<const char*> companion_words = {"auto", "none", "coarser", "finer"};
const std::vector<const char*> judge_words = {"truth", "readings"};
const std::vector<const char*> kernel_words = {"auto", "scalar", "sse4", "avx2", "avx512", "neon"};
const std::vector<const char*> element_words = {"auto", "corotational", "geometrically_exact", "rotation_vector"};

// clang-format off
const Table<TrajectorySpec> trajectory_keys = {"trajectory",
    "Second stage of the correction of the drilled path. Give one of the two keys.", {
  {"stage_two_length",      "m",      &TrajectorySpec::stage_two_length,   between(0.001, 10.0),
      "drilled length between corrections"},
  {"stage_two_steps",       "",       &TrajectorySpec::stage_two_steps,    between(1, 1000000),
      "physics steps between corrections", no_kind, every_kind, "by length"},
}};

const Table<StartSpec> start_keys = {"start", "The string starts at rest, in static equilibrium without friction, with the "
    "brake of the winch set. The toolface counts from the high side, or from north where the inclination at the bend is below 5 "
    "deg.", {
  {"bit_depth",             "m",      &StartSpec::bit_depth,               between(0.01, 20000.0),
      "measured depth of the bit's face", no_kind, every_kind, "hole_depth"},
  {"block_height",          "m",      &StartSpec::block_height,            between(0.0, 200.0),
      "height of the top-drive shaft above the rotary table"},
  {"weight_on_bit",         "N",      &StartSpec::weight_on_bit,           between(0.0, 1e6),
      "on bottom only: the weight that the bit carries at the start"},
  {"torque_on_bit",         "N m",    &StartSpec::torque_on_bit,           between(0.0, 1e5),    "on bottom only"},
  {"toolface_deg",          "deg",    &StartSpec::toolface,                between(-360.0, 360.0),
      "toolface of the bend in that equilibrium"},
}};

const Table<NumericsSpec> numerics_keys = {"numerics", "How the equations are solved.", {
  {"level",                 "",       Choice<NumericsSpec>{level_words,
      [](NumericsSpec& n, int word) { n.level = static_cast<Level>(word); },
      [](const NumericsSpec& n) { return static_cast<int>(n.level); }},
      none, "motions that are modelled. beam3d: all. axial_torsional: along the hole and about it; the string lies on the "
          "hole's axis with the friction of a soft string. hybrid: all motions near the bit, along and about the hole above. "
          "auto: the cheapest of these that meets the tolerance for the needs, with its steps and elements. rigid: as "
          "axial_torsional with a hundred times the stiffness, for steady loads"},
  {"free_length",           "m",      &NumericsSpec::free_length,          between(0.0, 20000.0),
      "level hybrid: all motions are modelled up to this distance above the bit's face; 0: bottom-hole assembly and two stands "
      "(the assembly ends at the first drill pipe: longer than two stands, bore over 0.7 of the outer diameter)", no_kind,
      every_kind, "the assembly and two stands"},
  {"integrator",            "",       Choice<NumericsSpec>{integrator_words,
      [](NumericsSpec& n, int word) { n.integrator = static_cast<IntegratorKind>(word); },
      [](const NumericsSpec& n) { return static_cast<int>(n.integrator); }},
      none, "method of time integration"},
  {"element",               "",       Choice<NumericsSpec>{element_words,
      [](NumericsSpec& n, int word) { n.element = static_cast<ElementKind>(word); },
      [](const NumericsSpec& n) { return static_cast<int>(n.element); }},
      none, "beam element; rotation_vector fails after a full turn of the string's top"},
  {"kernel",                "",       Choice<NumericsSpec>{kernel_words,
      [](NumericsSpec& n, int word) { n.kernel = static_cast<Kernel>(word); },
      [](const NumericsSpec& n) { return static_cast<int>(n.kernel); }},
      none, "instruction set for the arithmetic; auto: the widest of this processor. Runs repeat bit for bit with the same "
          "kernel; kernels differ in rounding"},
  {"step",                  "s",      &NumericsSpec::step,                 between(0.0, 0.05),
      "time step of the physics, 1e-5 or more; 0: variable, as long as the tolerance allows", no_kind, every_kind,
      "0; 0.01 at a level by hand or by a method without variable steps"},
  {"element_length",        "m",      &NumericsSpec::element_length,       between(0.0, 50.0),
      "longest element, 0.1 or more; 0: by the hole. It is 4.75 m where the hole inclines or friction below pushes the pipe, "
      "and a stand and a half above; 9.5 m higher up. Instead of 4.75 m: 9.5 m for a tolerance of 0.05 or more, 3.17 m below "
      "0.02, 2.38 m below 0.005", no_kind, every_kind, "by the hole"},
  {"pushed_element_length", "m",      &NumericsSpec::pushed_element_length, between(0.0, 50.0),
      "longest element where friction pushes pipe that slides down, 0.1 or more, if shorter than element_length; 0: as "
      "elsewhere"},
  {"guided_element_length", "m",      &NumericsSpec::guided_element_length, between(0.0, 50.0),
      "longest element of guided pipe that friction does not push, if longer than element_length. Two joints form one element, "
      "in the last part up to a stand; 0: as elsewhere"},
  {"tolerance",             "-",      &NumericsSpec::tolerance,            between(1e-6, 0.5),
      "allowed error of the outputs in `needs`, relative to their range; for variable steps, level auto and the mesh by the "
      "hole"},
  {"refinement",            "-",      &NumericsSpec::refinement,           between(1.0, 64.0),
      "factor by which elements and steps are shorter; the difference that it makes is the numerical error, as `drill verify` "
      "shows"},
  {"companion",             "",       Choice<NumericsSpec>{companion_words,
      [](NumericsSpec& n, int word) { n.companion = static_cast<CompanionKind>(word); },
      [](const NumericsSpec& n) { return static_cast<int>(n.companion); }},
      none, "second model of the rig with the same commands. The difference of the two is the measured error of each output, on "
          "which `accuracy_warning` depends. coarser: elements and steps twice as long, half the computing time of the run. "
          "finer: half as long, four times its computing time; the measured error is closer to the true one. none: no error "
          "is measured. auto: coarser where level is auto, else none"},
  {"judge",                 "",       Choice<NumericsSpec>{judge_words,
      [](NumericsSpec& n, int word) { n.judge = static_cast<Judge>(word); },
      [](const NumericsSpec& n) { return static_cast<int>(n.judge); }},
      none, "values whose error is measured. truth: the true ones. readings: those of the instruments with their filter, delay, "
          "rate and resolution, so that only errors count which a controller can see"},
  {"reference_tolerance",   "-",      &NumericsSpec::reference_tolerance,  between(1e-10, 1e-2),
      "integrator ida: local error of velocities (m/s, rad/s, and relative); of positions (m, rad) a hundredth of it"},
  {"reference_order",       "",       &NumericsSpec::reference_order,      between(1, 5),
      "integrator ida: highest order of its BDF; orders above 2 need shorter steps for waves with little damping"},
  {"reference_index",       "",       &NumericsSpec::reference_index,      between(2, 3),
      "integrator ida: index of the DAE; 2: stabilised; 3 is there to show how it fails"},
  {"newton_tolerance",      "m, rad", &NumericsSpec::newton_tolerance,     between(1e-12, 1e-3),
      "error that Newton's iteration may leave in the changes of a step"},
  {"structural_damping",    "s",      &NumericsSpec::structural_damping,   between(0.0, 0.1),
      "c of stress = E (strain + c strain rate), for axial strain, twist and bending"},
}};

// clang-format on

}  // namespace drill_rig_sim
