#include "scene_keys.h"

namespace drill_rig_sim
{
const std::vector<const char*> part_type_words = {"bit", "mud_motor", "collar", "stabilizer", "mwd", "pipe", "rotary_steerable"};
const std::vector<const char*> stribeck_curve_words = {"gaussian", "exponential"};
const std::vector<const char*> need_words = {"hook_load", "torque", "wob", "rop", "bit_speed", "pressure", "direction", "contact", "buckling"};
const std::vector<const char*> rheology_words = {"newtonian", "bingham", "power_law", "herschel_bulkley"};
const std::vector<const char*> level_words = {"rigid", "axial_torsional", "hybrid", "beam3d", "auto"};
const std::vector<const char*> integrator_words = {"auto",   "bdf2",              "implicit_euler", "linearly_implicit_euler",
                                                   "trbdf2", "generalised_alpha", "explicit",       "arkode_dirk",
                                                   "ida"};
const std::vector<const char*> companion_words = {"auto", "none", "coarser", "finer"};
const std::vector<const char*> judge_words = {"truth", "readings"};
const std::vector<const char*> kernel_words = {"auto", "scalar", "sse4", "avx2", "avx512", "neon"};
const std::vector<const char*> element_words = {"auto", "corotational", "geometrically_exact", "rotation_vector"};

namespace
{
const std::vector<const char*> projection_words = {"none", "straight", "curvature"};
const std::vector<const char*> connections_words = {"off", "auto"};
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
constexpr unsigned jointed = pipe | kind(PartType::collar);
constexpr unsigned bingham = kind(RheologyLaw::bingham), yields = kind(RheologyLaw::herschel_bulkley), thins = kind(RheologyLaw::power_law) | yields;
constexpr Range turn = between(-360.0, 360.0);

}  // namespace

// clang-format off
const Table<Scene> scene_keys = {"", "The scene file's top level.", {
  // key                    unit      field                                allowed               meaning
  {"name",                  "",       &Scene::name,                        none,                 "name of the scene: letters, digits and _", must},
  {"well",                  "",       Nested{},                            none,                 "the hole", must},
  {"formation",             "",       Nested{},                            none,                 "list of rock layers, top down by true vertical depth", must},
  {"mud",                   "",       Nested{},                            none,                 "the drilling fluid"},
  {"string",                "",       Nested{},                            none,                 "list of drillstring parts, from the bit up", must},
  {"rig",                   "",       Nested{},                            none,                 "hoisting, top drive and mud pump"},
  {"contact",               "",       Nested{},                            none,                 "contact of the string with the wall"},
  {"trajectory",            "",       Nested{},                            none,                 "correction of the drilled path"},
  {"start",                 "",       Nested{},                            none,                 "state at time 0", must},
  {"numerics",              "",       Nested{},                            none,                 "how the equations are solved"},
  {"instruments",           "",       Nested{},                            none,                 "sensors: rates, filters, noise, bias, resolution"},
  {"needs",                 "",       WordSet<Scene>{need_words, &Scene::needs}, none,           "outputs that matter to you; `accuracy_warning` is set where the level does not model one of them"},
  {"connections",           "",       Choice<Scene>{connections_words, [](Scene& s, int word) { s.connections = static_cast<Connections>(word); },
                                                    [](const Scene& s) { return static_cast<int>(s.connections); }},
                                                                           none,                 "auto: the crew adds a stand when the block is down and removes one when the block is up; off: slips and connections are commanded"},
  {"program",               "",       Nested{},                            none,                 "list of commands at simulated times, for the offline runner and demos"},
  {"operations",            "",       Nested{},                            none,                 "list of tasks, each ends on a condition; `program` is a time schedule"},
}};

const Table<WellSpec> well_keys = {"well", "The hole before drilling starts. Give `survey` or `stations`.", {
  {"survey",                "",       Nested{},                            none,                 "the survey's file, a table (CSV) or a WITSML trajectory, or a block `well.survey`; a relative path starts at the scene file's folder"},
  {"stations",              "m, deg", Nested{},                            none,                 "list of [measured depth, inclination, azimuth], the first at depth 0 or tied in"},
  {"tie_in",                "",       Nested{},                            none,                 "position of the first station, where that is below depth 0; a smooth hole leads there. Replaces the columns of the CSV file"},
  {"hole_depth",            "m",      &WellSpec::hole_depth,               between(0.1, 20000.0), "measured depth of the hole's bottom; below the last station only with `project`", no_kind, every_kind, "the last station"},
  {"project",               "",       Choice<WellSpec>{projection_words, [](WellSpec& w, int i) { w.project = static_cast<Projection>(i); }, [](const WellSpec& w) { return static_cast<int>(w.project); }}, none, "direction of the hole between the last station and hole_depth, at most 30.5 m: straight on, or with the curvature of the last interval"},
  {"sections",              "",       Nested{},                            none,                 "list of hole sections, top down; the last reaches hole_depth", must},
  {"pilot_depth",           "m",      &WellSpec::pilot_depth,              between(0.0, 20000.0), "measured depth to which a narrower pilot hole exists; the bit reams it from hole_depth on; 0: none"},
  {"pilot_diameter",        "m",      &WellSpec::pilot_diameter,           between(0.0, 1.0),    "diameter of the pilot hole, at most 0.95 of the bit's"},
}};

const Table<SurveyFormat> survey_keys = {"well.survey", "The survey's file and how to read it, where its header does not say. `--columns MAP.yaml` of `drill survey`, `score` and `plot` takes the same keys except `file`.", {
  {"file",                  "",       Nested{},                            none,                 "the survey's file", survey_of_scene, survey_of_scene},
  {"columns",               "",       Nested{},                            none,                 "names and units of the columns"},
  {"delimiter",             "",       &SurveyFormat::delimiter,            none,                 "between cells: `\",\"`, `\";\"`, bar, tab or space. Decimal commas are read where the delimiter is not a comma, grouped digits where the decimal sign is certain (`1,234.5`, `1.234,5`, `1 234`)", no_kind, every_kind, "by the header"},
  {"pass_over",             "",       Flag<SurveyFormat>{&SurveyFormat::pass_over}, none,        "true: stations without a value (empty or -999.25) and repeated stations are left out; a vertical station then needs no azimuth", no_kind, every_kind, "false"},
}};

const Table<SurveyFormat> survey_columns_keys = {"well.survey.columns", "Columns of a survey's table, where their names are not the usual ones. Give only what is unclear.", {
  {"md",                    "",       Nested{},                            none,                 "measured depth"},
  {"inclination",           "",       Nested{},                            none,                 "inclination from vertical down"},
  {"azimuth",               "",       Nested{},                            none,                 "azimuth, clockwise from north"},
  {"north",                 "",       Nested{},                            none,                 "north of the rotary table; north, east and tvd are used where the first station is below the table"},
  {"east",                  "",       Nested{},                            none,                 "east of the rotary table"},
  {"tvd",                   "",       Nested{},                            none,                 "true vertical depth"},
}};

const Table<SurveyColumn> survey_column_keys = {"well.survey.columns.*", "A column.", {
  {"column",                "",       &SurveyColumn::column,               none,                 "name in the header", no_kind, every_kind, "by the usual names"},
  {"unit",                  "",       &SurveyColumn::unit,                 none,                 "length: such as m, ft or ftUS (US survey foot); angle: such as deg, rad or gon", no_kind, every_kind, "as the header says"},
}};

const Table<TieIn> tie_in_keys = {"well.tie_in", "Position of a survey's first station below the rotary table. The hole above it leaves the table vertically and consists of straight pieces and arcs of at most 15 deg/30 m.", {
  {"north",                 "m",      &TieIn::north,                       between(-20000.0, 20000.0), "north of the rotary table"},
  {"east",                  "m",      &TieIn::east,                        between(-20000.0, 20000.0), "east of the rotary table"},
  {"tvd",                   "m",      &TieIn::tvd,                         above(0.0, 20000.0),  "true vertical depth", must},
}};

const Table<HoleSection> section_keys = {"well.sections[]", "A section of the hole; it begins where the section above it ends.", {
  {"to",                    "m",      &HoleSection::to,                    between(0.01, 20000.0), "measured depth of its lower end", must},
  {"diameter",              "m",      &HoleSection::diameter,              between(0.03, 2.0),   "hole diameter", must},
  {"friction",              "-",      &HoleSection::friction,              between(0.0, 5.0),    "kinetic friction coefficient of string on wall", must},
  {"static_ratio",          "-",      &HoleSection::static_ratio,          between(1.0, 5.0),    "static over kinetic friction", no_kind, every_kind, "of `contact`"},
  {"stribeck_speed",        "m/s",    &HoleSection::stribeck_speed,        between(1e-4, 10.0),  "slip speed over which friction falls from static to kinetic", no_kind, every_kind, "of `contact`"},
}};

const Table<FormationLayer> layer_keys = {"formation[]", "A layer of rock. ROP = drillability (weight - threshold)^weight_exponent bit_speed^speed_exponent.", {
  {"to_tvd",                "m",      &FormationLayer::to_tvd,             above(0.0, 1e6),      "true vertical depth of its base; the last layer continues below it", must},
  {"drillability",          "m/s; N; rad/s", &FormationLayer::drillability, above(0.0, 1.0),     "factor K of the rate of penetration", must},
  {"weight_exponent",       "-",      &FormationLayer::weight_exponent,    between(0.5, 3.0),    "exponent of the weight"},
  {"speed_exponent",        "-",      &FormationLayer::speed_exponent,     between(0.0, 2.0),    "exponent of the bit's speed"},
  {"threshold",             "N",      &FormationLayer::threshold,          between(0.0, 1e6),    "weight below which the rock does not break"},
  {"dip_deg",               "deg",    &FormationLayer::dip,                between(0.0, 90.0),   "dip of the beds below the horizontal"},
  {"strike_deg",            "deg",    &FormationLayer::strike,             turn,                 "azimuth of the strike; the beds dip to the right of it"},
  {"anisotropy",            "-",      &FormationLayer::anisotropy,         below(0.0, 1.0),      "0: the rock drills alike in all directions"},
  {"friction",              "-",      &FormationLayer::friction,           between(0.0, 5.0),    "kinetic friction coefficient of string on wall in new hole of this layer, instead of the section's", no_kind, every_kind, "of the section"},
}};

const Table<MudSpec> mud_keys = {"mud", "The drilling fluid around and inside the string.", {
  {"density",               "kg/m3",  &MudSpec::density,                   between(0.0, 3000.0), "density; 0: air, no buoyancy"},
  {"viscosity",             "Pa s",   &MudSpec::viscosity,                 between(0.0, 1.0),    "dynamic viscosity. It damps the string's waves (see the next keys); 0: no damping. 0.02 Pa s is 20 cP, an assumption; plastic viscosities of muds are 5 to 60 cP. With `rheology` only for a Newtonian mud; other muds damp by their plastic viscosity"},
  {"axial_damping",         "N s/m per m", &MudSpec::axial_damping,        between(0.0, 1e4),    "viscous drag for motion along the string", no_kind, every_kind, "by the viscosity, for a wave of 1 Hz: 6.3 for 5 in pipe"},
  {"lateral_damping",       "N s/m per m", &MudSpec::lateral_damping,      between(0.0, 1e5),    "viscous drag for motion across the string, the part proportional to speed", no_kind, every_kind, "by the viscosity, for a wave of 1 Hz: 19 for 5 in pipe in an 8 1/2 in hole"},
  {"drag_coefficient",      "-",      &MudSpec::drag_coefficient,          between(0.0, 10.0),   "drag coefficient C_d for motion across the string, the part proportional to the square of the speed"},
  {"torsional_damping",     "N m s/rad per m", &MudSpec::torsional_damping, between(0.0, 100.0), "viscous drag for rotation of the string", no_kind, every_kind, "by the viscosity, for a wave of 1 Hz: 0.02 for 5 in pipe"},
  {"bulk_modulus",          "Pa",     &MudSpec::bulk_modulus,              between(1e7, 1e11),   "bulk modulus of the mud, with the elasticity of pipe and hole in it; pressure follows the pump with the time constant of volume / bulk_modulus"},
  {"gel_strength",          "Pa",     &MudSpec::gel_strength,              between(0.0, 100.0),  "shear stress that starts mud which has rested for ten minutes; 1 lb/100 ft2 is 0.479 Pa, muds have 2 to 15 Pa"},
  {"added_mass",            "-",      &MudSpec::added_mass,                between(0.0, 5.0),    "factor on the mass of the mud that moves sideways with the string, inside it and around it"},
  {"rheology",              "",       Nested{},                            none,                 "flow curve of the mud: pressure losses by section, ECD, surge and swab follow from it instead of `rig.mud_pump.pressure_coefficient`. Needs `nozzles` or `nozzle_area` of the bit", no_kind, every_kind, "none"},
  {"fill",                  "m",      Nested{},                            none,                 "mud level in a string that is run in with a float and not filled: distance along the string from the rotary table down. One number, or by bit depth `[[bit_depth, level], ...]`, linear between rows. A level at the bit or deeper: the string is empty. The pump fills the string before mud reaches the bit", no_kind, every_kind, "0, full"},
}};

const Table<RheologySpec> rheology_keys = {"mud.rheology", "Flow curve of the mud: stress = yield stress + consistency rate^index. Give the numbers of the law, or `readings`.", {
  {"law",                   "",       Choice<RheologySpec>{rheology_words, [](RheologySpec& r, int word) { r.law = static_cast<RheologyLaw>(word); },
                                                           [](const RheologySpec& r) { return static_cast<int>(r.law); }},
                                                                           none,                 "flow law; newtonian uses `mud.viscosity`", must},
  {"readings",              "rpm, deg", Nested{},                          none,                 "viscometer readings (rotor R1, bob B1, spring F1), rows [speed, dial], such as `[[600, 65], [300, 39]]`: at least 1 for newtonian, 2 for bingham and power_law, 3 for herschel_bulkley. 600, 300, 6 and 3 rpm of a Herschel-Bulkley mud as in API RP 13D, others by least squares", no_kind, every_kind, "none"},
  {"plastic_viscosity",     "Pa s",   &RheologySpec::plastic_viscosity,    between(1e-4, 1.0),   "plastic viscosity PV", no_kind, bingham, "of the readings"},
  {"yield_point",           "Pa",     &RheologySpec::yield_point,          between(0.0, 200.0),  "yield point YP; 1 lb/100 ft2 is 0.479 Pa", no_kind, bingham, "of the readings"},
  {"yield_stress",          "Pa",     &RheologySpec::yield_stress,         between(0.0, 200.0),  "shear stress below which the mud does not flow", no_kind, yields, "of the readings"},
  {"consistency",           "Pa s^n", &RheologySpec::consistency,          between(1e-4, 100.0), "consistency K", no_kind, thins, "of the readings"},
  {"index",                 "-",      &RheologySpec::index,                between(0.1, 1.0),    "flow index n; 1: no shear thinning", no_kind, thins, "of the readings"},
  {"eccentricity",          "-",      &RheologySpec::eccentricity,         between(0.0, 0.95),   "offset of the string in its hole over the clearance; it lowers the annulus's pressure loss, at 0.95 to half"},
}};

const Table<PartSpec> part_keys = {"string[]", "One part of the drillstring; the first is the bit. Masses are in air.", {
  {"name",                  "",       &PartSpec::name,                     none,                 "unique; letters, digits and _", must},
  {"type",                  "",       Choice<PartSpec>{part_type_words, [](PartSpec& p, int word) { p.type = static_cast<PartType>(word); },
                                                       [](const PartSpec& p) { return static_cast<int>(p.type); }},
                                                                           none,                 "type of the part", must},
  {"length",                "m",      &PartSpec::length,                   between(0.02, 2000.0), "length of a part that has no `joints`", bit | motor | stabilizer | mwd | steerable, every_kind, "joints * joint_length"},
  {"joints",                "",       CountOrFill<PartSpec>{&PartSpec::joints}, between(1, 10000), "number of joints; `fill` (last part only): as many as reach the surface", no_kind, jointed},
  {"joint_length",          "m",      &PartSpec::joint_length,             between(0.5, 30.0),   "length of one joint", no_kind, jointed, "length"},
  {"outer_diameter",        "m",      &PartSpec::outer_diameter,           between(0.01, 1.0),   "of the body", tube, tube},
  {"inner_diameter",        "m",      &PartSpec::inner_diameter,           between(0.0, 1.0),    "of the bore", tube, tube},
  {"linear_mass",           "kg/m",   &PartSpec::linear_mass,              between(0.1, 5000.0), "mass per length in air, tool joints included", tube, tube},
  {"young_modulus",         "Pa",     &PartSpec::young_modulus,            between(1e9, 1e12),   "Young's modulus; steel 206e9"},
  {"poisson_ratio",         "-",      &PartSpec::poisson_ratio,            between(0.0, 0.49),   "Poisson's ratio; steel 0.3"},
  {"axial_stiffness",       "N",      Inside<PartSpec>{[](PartSpec& p) -> double& { return p.stiffness.axial; }}, between(1e3, 1e13), "axial stiffness E A. The diameters then define only contact and mud", no_kind, tube, "of the tube"},
  {"bending_stiffness",     "N m2",   Inside<PartSpec>{[](PartSpec& p) -> double& { return p.stiffness.bending; }}, between(1e-3, 1e12), "bending stiffness E I", no_kind, tube, "of the tube"},
  {"torsional_stiffness",   "N m2",   Inside<PartSpec>{[](PartSpec& p) -> double& { return p.stiffness.torsional; }}, between(1e-3, 1e12), "torsional stiffness G J", no_kind, tube, "of the tube"},
  {"polar_inertia",         "kg m2/m", &PartSpec::polar_inertia,           above(0.0, 1e4),      "polar moment of inertia about the axis, in air", no_kind, tube, "of the tube with this linear_mass"},
  {"yield_strength",        "Pa",     &PartSpec::yield_strength,           between(1e6, 1e10),   "yield strength; stress above it is reported as over_stress. Default: drill pipe of grade G-105"},
  {"make_up_torque",        "N m",    &PartSpec::make_up_torque,           between(0.0, 1e7),    "make-up torque of the connections; torque above it is reported as over_torque; 0: unknown"},
  {"density",               "kg/m3",  &PartSpec::density,                  between(500.0, 20000.0), "density of the material; displaced volume = mass / density"},
  {"friction_radius",       "m",      &PartSpec::friction_radius,            above(0.0, 0.5),      "radius at which the wall's friction acts about the axis; smaller than the contact radius for pipe with non-rotating protectors", no_kind, tube, "where it touches"},
  {"contact",               "",       Nested{},                            none,                 "wall contact law of this part, instead of the scene's"},
  {"tool_joint_diameter",   "m",      Inside<PartSpec>{of_tool_joint},     between(0.01, 1.0),   "outer diameter of the tool joints", no_kind, pipe, "outer_diameter"},
  {"blade_diameter",        "m",      Inside<PartSpec>{of_blades},         between(0.01, 1.0),   "outer diameter over the blades", stabilizer, stabilizer},
  {"nozzles",               "1/32 in", Nested{},                           none,                 "nozzle diameters, such as `[12, 12, 12]`; another unit must be written; needs `mud.rheology`", no_kind, bit, "none"},
  {"nozzle_area",           "m2",     Inside<PartSpec>{of_bit<&BitSpec::nozzle_area>}, between(1e-6, 0.1), "total flow area, instead of `nozzles`", no_kind, bit, "of the nozzles"},
  {"speed_lag",             "s",      Inside<PartSpec>{of_bit<&BitSpec::speed_lag>}, between(1e-3, 10.0),   "time constant of the bit speed that the rate of penetration uses: the drilling law holds for averages over turns", no_kind, bit},
  {"squeeze_film_damping",  "N s/m",  Inside<PartSpec>{of_film},           between(0.0, 1e8),    "damping of sideways motion by the mud squeezed between the wall and the gauge or blades (50000 by default)", no_kind, bit | stabilizer},
  {"sensor_offset",         "m",      Inside<PartSpec>{of_sensor},         between(0.0, 2000.0), "distance from the part's lower end up to the sensor", no_kind, mwd},
  {"mass",                  "kg",     Inside<PartSpec>{of_bit<&BitSpec::mass>}, between(0.1, 1e5),    "mass of the bit", bit, bit},
  {"diameter",              "m",      Inside<PartSpec>{of_bit<&BitSpec::diameter>}, between(0.03, 1.0),   "gauge diameter of the bit and of the hole it drills", bit, bit},
  {"side_cutting",          "-",      Inside<PartSpec>{of_bit<&BitSpec::side_cutting>}, between(0.0, 1.0),    "lateral over axial drillability: PDC bits 0.001 to 0.1, less with a longer gauge", no_kind, bit},
  {"gauge_length",          "m",      Inside<PartSpec>{of_bit<&BitSpec::gauge_length>}, between(0.0, 2.0),    "length of the gauge pads, from half a diameter above the face upwards, inside the bit's length. They resist tilt of the bit and cut nothing; 0: contact of a ball, which tilts freely", no_kind, bit},
  {"gauge_clearance",       "m",      Inside<PartSpec>{of_bit<&BitSpec::gauge_clearance>}, between(0.0, 0.02),   "radial clearance of the pads' upper end in the hole that the bit cuts; the bit tilts freely by gauge_clearance / gauge_length", no_kind, bit},
  {"torque",                "",       Nested{},                            none,                 "law of the torque on bit", no_kind, bit},
  {"bottom",                "",       Nested{},                            none,                 "law of the bit's contact with the hole's bottom; not with `torque: {model: regenerative}`", no_kind, bit},
  {"bend_deg",              "deg",    Inside<PartSpec>{of_motor<&MotorSpec::bend>}, between(0.0, 5.0),    "angle of the bent housing", no_kind, motor},
  {"bit_to_bend",           "m",      Inside<PartSpec>{of_motor<&MotorSpec::bit_to_bend>}, between(0.01, 100.0), "distance from the bit's face to the bend; the bend is inside the motor", motor, motor},
  {"sleeve_diameter",       "m",      Inside<PartSpec>{of_motor<&MotorSpec::sleeve_diameter>}, between(0.0, 1.0), "diameter over the blades on the bearing housing, which turn with the string; 0: none", no_kind, motor},
  {"bit_to_sleeve",         "m",      Inside<PartSpec>{of_motor<&MotorSpec::bit_to_sleeve>}, between(0.0, 100.0), "distance from the bit's face to the middle of these blades, which is inside the motor", no_kind, motor},
  {"displacement_per_rev",  "m3/rev", Inside<PartSpec>{of_motor<&MotorSpec::displacement_per_rev>}, between(1e-4, 1.0),   "mud volume that turns the motor once", motor, motor},
  {"stall_torque",          "N m",    Inside<PartSpec>{of_motor<&MotorSpec::stall_torque>}, between(1.0, 1e6),    "torque at which the motor stalls", motor, motor},
  {"curve_exponent",        "-",      Inside<PartSpec>{of_motor<&MotorSpec::curve_exponent>}, between(1.0, 20.0),   "exponent b of the motor's speed, N_0 (1 - (T/T_stall)^b); 1: a straight line, power sections 3 to 5", no_kind, motor},
  {"efficiency",            "-",      Inside<PartSpec>{of_motor<&MotorSpec::efficiency>}, between(0.3, 1.0),    "mechanical efficiency: the share of the pressure's torque at the shaft; the rest is friction in rotor and bearings. Charts of power sections: 0.7 to 0.9", no_kind, motor},
  {"bit_to_pads",           "m",      Inside<PartSpec>{of_steerable<&SteerableSpec::bit_to_pads>}, between(0.01, 100.0), "distance from the bit's face to the pads, which are inside the tool", no_kind, steerable, "required with pad_force"},
  {"pad_force",             "N",      Inside<PartSpec>{of_steerable<&SteerableSpec::pad_force>}, above(0.0, 2e5), "side force on the tool at full steering (push the bit)", no_kind, steerable, "this or tilt_deg"},
  {"bit_to_pivot",          "m",      Inside<PartSpec>{of_steerable<&SteerableSpec::bit_to_pivot>}, between(0.01, 100.0), "distance from the bit's face to the pivot of the shaft, which is inside the tool", no_kind, steerable, "required with tilt_deg"},
  {"tilt_deg",              "deg",    Inside<PartSpec>{of_steerable<&SteerableSpec::tilt>}, above(0.0, 5.0), "tilt of the shaft against the collar at full steering, reached in 5 s (point the bit)", no_kind, steerable, "this or pad_force"},
  {"downlink_bit_time",     "s",      Inside<PartSpec>{of_steerable<&SteerableSpec::downlink_bit_time>}, between(1.0, 120.0), "length of a bit of a downlink by the pump's flow", no_kind, steerable},
}};

namespace
{
// the same keys for the three places that take a contact law; each place has its own defaults
std::vector<Key<ContactLaw>> contact_law_keys()
{
  return {
  {"stiffness",             "N/m^e",  &ContactLaw::stiffness,              between(1e3, 1e13),   "stiffness k of F = k d^e (1 + c d')"},
  {"exponent",              "-",      &ContactLaw::exponent,               between(1.0, 3.0),    "exponent e; Hertz 1.5"},
  {"damping",               "s/m",    &ContactLaw::damping,                between(0.0, 100.0),  "damping c"},
  };
}
}  // namespace

const Table<ContactLaw> part_contact_keys = {"string[].contact", "Wall contact of one part.", contact_law_keys()};
const Table<ContactLaw> bit_bottom_keys = {"string[].bottom", "Contact of the bit with the hole's bottom.", contact_law_keys()};

const Table<RigSpec> rig_keys = {"rig", "The rig above the rotary table.", {
  {"hoisting",              "",       Nested{},                            none,                 "drill line, block and winch"},
  {"top_drive",             "",       Nested{},                            none,                 "rotary drive and torque meter"},
  {"mud_pump",              "",       Nested{},                            none,                 "pump and stand pipe"},
  {"heave",                 "",       Nested{},                            none,                 "waves under a floating rig"},
  {"plc_latency",           "s",      &RigSpec::plc_latency,               between(0.0, 2.0),    "dead time of the rig's controller: set points of winch, top drive, pump and steering act so much later; `rig_state` shows those that act. Interlocks and faults act at once"},
}};

const Table<HoistingSpec> hoisting_keys = {"rig.hoisting", "Drill line, travelling block and winch.", {
  {"sheaves",               "",       &HoistingSpec::sheaves,              between(1, 12),       "number of sheaves in the travelling block; the number of lines is twice as large"},
  {"line_ea",               "N",      &HoistingSpec::line_ea,              between(1e5, 1e10),   "axial stiffness E A of the drill line"},
  {"crown_height",          "m",      &HoistingSpec::crown_height,         between(5.0, 200.0),  "height of the crown block above the rotary table"},
  {"fixed_length",          "m",      &HoistingSpec::fixed_length,         between(0.0, 1000.0), "length of line outside the block: fast and dead line"},
  {"block_mass",            "kg",     &HoistingSpec::block_mass,           between(1.0, 3e5),    "mass of travelling block and top drive"},
  {"sheave_efficiency",     "-",      &HoistingSpec::sheave_efficiency,    between(0.8, 1.0),    "efficiency of one sheave"},
  {"rail_friction",         "-",      &HoistingSpec::rail_friction,        between(0.0, 0.5),    "friction of the block on its guide rail, relative to its weight"},
  {"line_damping",          "-",      &HoistingSpec::line_damping,         between(0.0, 1.0),    "damping of the empty block on its lines, relative to critical"},
  {"latency",               "s",      &HoistingSpec::latency,              between(0.0, 2.0),    "dead time of the drawworks' drive: the winch's set point acts so much later, beyond rig.plc_latency"},
  {"max_speed",             "m/s",    &HoistingSpec::max_speed,            between(0.001, 20.0), "largest speed of the block"},
  {"max_acceleration",      "m/s2",   &HoistingSpec::max_acceleration,     between(0.001, 50.0), "largest acceleration of the block"},
  {"max_hook_load",         "N",      &HoistingSpec::max_hook_load,        between(1e3, 5e7),    "largest pull of the winch, as hook load"},
  {"min_hook_load",         "N",      &HoistingSpec::min_hook_load,        between(0.0, 5e7),    "the winch stops lowering below this hook load (slack line); 0: never"},
  {"trip_hook_load",        "N",      &HoistingSpec::trip_hook_load,       between(0.0, 5e7),    "over-pull limit: when `hook_load` of `rig_state` reaches it while raising, the brake is set until a command that does not raise; 0: never"},
  {"lowest_block_height",   "m",      &HoistingSpec::lowest_block_height,  between(0.0, 200.0),  "lowest height of the top-drive shaft above the rotary table"},
  {"highest_block_height",  "m",      &HoistingSpec::highest_block_height, between(0.0, 200.0),  "largest height of the top-drive shaft above the rotary table, below crown_height"},
  {"connection_time",       "s",      &HoistingSpec::connection_time,      between(1.0, 3600.0), "time for which the string is in the slips and broken out while pipe is added or removed. The block travels for half of it, longer where its limits require it"},
  {"stand_joints",          "",       &HoistingSpec::stand_joints,         between(1, 4),        "number of joints of the last part in a stand"},
}};

const Table<TopDriveSpec> top_drive_keys = {"rig.top_drive", "Rotary drive with a PI speed loop, and the spring of the torque meter.", {
  {"inertia",               "kg m2",  &TopDriveSpec::inertia,              between(1.0, 1e6),    "moment of inertia of the rotor, at the shaft"},
  {"proportional_gain",     "N m s/rad", &TopDriveSpec::proportional_gain, between(0.0, 1e7),    "proportional gain of the speed loop"},
  {"integral_gain",         "N m/rad", &TopDriveSpec::integral_gain,       between(0.0, 1e7),    "integral gain of the speed loop"},
  {"max_torque",            "N m",    &TopDriveSpec::max_torque,           between(1.0, 1e6),    "largest torque of the drive"},
  {"max_speed_rpm",         "rpm",    &TopDriveSpec::max_speed,            between(1.0, 1000.0), "largest speed of the drive"},
  {"max_acceleration_rpm",  "rpm/s",  &TopDriveSpec::max_acceleration,     between(0.0, 1e4),    "largest acceleration of the speed set point; 0: no limit (ANGLE and OSCILLATE: 2 rad/s2)"},
  {"max_power",             "W",      &TopDriveSpec::max_power,            between(1e3, 1e8),    "largest power of the drive"},
  {"meter_stiffness",       "N m/rad", &TopDriveSpec::meter_stiffness,     between(1e3, 1e9),    "stiffness of the torque meter's spring"},
  {"gearbox_friction",      "N m",    &TopDriveSpec::gearbox_friction,     between(0.0, 1e5),    "friction torque of the gearbox"},
  {"brake_torque",          "N m",    &TopDriveSpec::brake_torque,         between(0.0, 1e6),    "torque of the brake, which is set at a set point of 0 when the rotor stands; 0: no brake"},
  {"soft_torque",           "",       Nested{},                            none,                 "settings of mode SOFT_TORQUE"},
  {"z_torque",              "",       Nested{},                            none,                 "settings of mode Z_TORQUE"},
}};

namespace
{
std::vector<Key<DriveImpedance>> impedance_rows(const char* damping, const char* stiffness)
{
  return {
  {"damping",               "N m s/rad", &DriveImpedance::damping,         between(0.0, 1e6),    "damping P; 0: the default", no_kind, every_kind, damping},
  {"stiffness",             "N m/rad", &DriveImpedance::stiffness,         between(0.0, 1e6),    "stiffness I; 0: the default", no_kind, every_kind, stiffness},
  {"inertia_compensation",  "-",      &DriveImpedance::inertia_compensation, between(0.0, 0.99), "c: share of the rotor's inertia that the drive compensates by feedback of the torque meter"},
  };
}
}  // namespace

const Table<DriveImpedance> soft_torque_keys = {"rig.top_drive.soft_torque", "In mode SOFT_TORQUE the drive acts on the string as the impedance P + s (1 - c) inertia + I/s.", impedance_rows("twice the pipe's impedance", "what cancels the inertia left at the string's slowest torsion, at 1 Hz where that is faster")};

const Table<DriveImpedance> z_torque_keys = {"rig.top_drive.z_torque", "As SOFT_TORQUE, with most of the rotor's inertia compensated, so that it damps over a wide band of frequencies.", impedance_rows("the pipe's impedance", "P w / 8, w the string's slowest torsion, at most that of 1 Hz")};

const Table<MudPumpSpec> mud_pump_keys = {"rig.mud_pump", "Pump and stand pipe.", {
  {"max_flow",              "m3/s",   &MudPumpSpec::max_flow,              above(0.0, 1.0),      "largest flow of the pump"},
  {"flow_ramp",             "m3/s2",  &MudPumpSpec::flow_ramp,             above(0.0, 1000.0),   "largest rate of change of the pump's flow"},
  {"stroke_volume",         "m3",     &MudPumpSpec::stroke_volume,         between(1e-4, 0.1),   "volume of a stroke; default: two triplex pumps side by side, 6 in liners and 12 in strokes, 95 % full"},
  {"relief_pressure",       "Pa",     &MudPumpSpec::relief_pressure,       between(1e5, 2e8),    "pressure at which the relief valve at the pump opens; the flow that it takes returns to the tanks"},
  {"trip_pressure",         "Pa",     &MudPumpSpec::trip_pressure,         between(0.0, 2e8),    "when `stand_pipe_pressure` of `rig_state` reaches this pressure the pump stops until a flow of 0 is commanded; 0: never"},
  {"surface_lines",         "m",      Nested{},                            none,                 "pipes between pump and string, rows [length, diameter]: standpipe, hose, swivel or wash pipe, kelly; needs `mud.rheology`", no_kind, every_kind, "none"},
  {"pressure_coefficient",  "Pa s2/m6", &MudPumpSpec::pressure_coefficient, between(0.0, 1e12),  "pressure loss of string, bit and annulus at max_flow, divided by max_flow^2"},
  {"loss_exponent",         "-",      &MudPumpSpec::loss_exponent,         between(1.0, 2.0),    "exponent m: losses at other flows are proportional to Q^m; 2 rough turbulence, 1.86 smooth, a field record 1.56"},
}};

const Table<HeaveSpec> heave_keys = {"rig.heave", "Waves under a floating rig without a heave compensator. Floor, winch, rail and slips move together on regular waves, which grow from rest within five periods. Heights of the block are above the floor; `floor_height` and `floor_velocity` of `rig_state` are the floor's. A block at its lowest or highest place moves against its stop (`stop_reached`). `tare` and operations use the average hook load over a period; topics carry the momentary one, which `instruments.surface.hook_load.filter_time` smooths. Surge and swab pressures are those of friction; the mud's inertia, as large again in a deep well, is not modelled. For a rig with a compensator give the remaining amplitude; pipe in the slips then heaves too little.", {
  {"amplitude",             "m",      &HeaveSpec::amplitude,               between(0.0, 10.0),   "amplitude about the mean height of the rotary table, where depths begin; acceleration at most 3 m/s2; 0: a rig on land"},
  {"period",                "s",      &HeaveSpec::period,                  between(2.0, 60.0),   "period of the waves"},
}};

const Table<ContactSpec> contact_keys = {"contact", "Contact of string and wall, F = k d^e (1 + c d'), and the shape of the friction law; `friction` of the hole sections is the kinetic coefficient.", {
  {"stiffness",             "N/m^e",  Inside<ContactSpec>{[](ContactSpec& c) -> double& { return c.law.stiffness; }}, between(1e3, 1e13), "stiffness k"},
  {"assembly_stiffness",    "N/m^e",  &ContactSpec::assembly_stiffness,    between(1e3, 1e13),   "least stiffness k under the bit's gauge, blades and a motor's sleeve; what they sink into the wall is lost for the bit's side force"},
  {"exponent",              "-",      Inside<ContactSpec>{[](ContactSpec& c) -> double& { return c.law.exponent; }},  between(1.0, 3.0),  "exponent e; Hertz 1.5"},
  {"damping",               "s/m",    Inside<ContactSpec>{[](ContactSpec& c) -> double& { return c.law.damping; }},   between(0.0, 100.0), "damping c"},
  {"stribeck_speed",        "m/s",    &ContactSpec::stribeck_speed,        between(1e-4, 10.0),  "slip speed over which friction falls from static to kinetic"},
  {"static_ratio",          "-",      &ContactSpec::static_ratio,          between(1.0, 5.0),    "static over kinetic friction"},
  {"stribeck_curve",        "",       Choice<ContactSpec>{stribeck_curve_words, [](ContactSpec& c, int word) { c.stribeck_curve = static_cast<StribeckCurve>(word); },
                                               [](const ContactSpec& c) { return static_cast<int>(c.stribeck_curve); }},
                                                                           none,                 "fall of friction with slip speed v: exp(-(v/stribeck_speed)^2) or exp(-v/stribeck_speed)"},
  {"growth_at_rest",        "-",      Inside<ContactSpec>{[](ContactSpec& c) -> double& { return c.growth.per_fold; }}, between(0.0, 5.0), "growth of static_ratio while a contact rests, for each e-fold of 1 + time/growth_time; 0: none"},
  {"growth_time",           "s",      Inside<ContactSpec>{[](ContactSpec& c) -> double& { return c.growth.time; }}, between(1e-3, 1e6), "time at rest after which the growth is logarithmic"},
  {"growth_limit",          "-",      Inside<ContactSpec>{[](ContactSpec& c) -> double& { return c.growth.limit; }}, between(0.0, 10.0), "largest growth of static_ratio"},
  {"tangential_stiffness",  "N/m",    &ContactSpec::tangential_stiffness,  between(1e3, 1e12),   "stiffness of the bristle that carries sticking friction"},
  {"tangential_damping",    "-",      &ContactSpec::tangential_damping,    between(0.0, 10.0),   "damping of that bristle, relative to critical for the mass at the contact"},
}};

const Table<TrajectorySpec> trajectory_keys = {"trajectory", "Second stage of the correction of the drilled path. Give one of the two keys.", {
  {"stage_two_length",      "m",      &TrajectorySpec::stage_two_length,   between(0.001, 10.0), "drilled length between corrections"},
  {"stage_two_steps",       "",       &TrajectorySpec::stage_two_steps,    between(1, 1000000),  "physics steps between corrections", no_kind, every_kind, "by length"},
}};

const Table<StartSpec> start_keys = {"start", "The string starts at rest, in static equilibrium without friction, with the brake of the winch set. The toolface counts from the high side, or from north where the inclination at the bend is below 5 deg.", {
  {"bit_depth",             "m",      &StartSpec::bit_depth,               between(0.01, 20000.0), "measured depth of the bit's face", no_kind, every_kind, "hole_depth"},
  {"block_height",          "m",      &StartSpec::block_height,            between(0.0, 200.0),  "height of the top-drive shaft above the rotary table"},
  {"weight_on_bit",         "N",      &StartSpec::weight_on_bit,           between(0.0, 1e6),    "on bottom only: the weight that the bit carries at the start"},
  {"torque_on_bit",         "N m",    &StartSpec::torque_on_bit,           between(0.0, 1e5),    "on bottom only"},
  {"toolface_deg",          "deg",    &StartSpec::toolface,                turn,                 "toolface of the bend in that equilibrium"},
}};

const Table<NumericsSpec> numerics_keys = {"numerics", "How the equations are solved.", {
  {"level",                 "",       Choice<NumericsSpec>{level_words, [](NumericsSpec& n, int word) { n.level = static_cast<Level>(word); },
                                               [](const NumericsSpec& n) { return static_cast<int>(n.level); }},
                                                                           none,                 "motions that are modelled. beam3d: all. axial_torsional: along the hole and about it; the string lies on the hole's axis with the friction of a soft string. hybrid: all motions near the bit, along and about the hole above. auto: the cheapest of these that meets the tolerance for the needs, with its steps and elements. rigid: as axial_torsional with a hundred times the stiffness, for steady loads"},
  {"free_length",           "m",      &NumericsSpec::free_length,          between(0.0, 20000.0), "level hybrid: all motions are modelled up to this distance above the bit's face; 0: bottom-hole assembly and two stands (the assembly ends at the first drill pipe: longer than two stands, bore over 0.7 of the outer diameter)", no_kind, every_kind, "the assembly and two stands"},
  {"integrator",            "",       Choice<NumericsSpec>{integrator_words, [](NumericsSpec& n, int word) { n.integrator = static_cast<IntegratorKind>(word); },
                                               [](const NumericsSpec& n) { return static_cast<int>(n.integrator); }},
                                                                           none,                 "method of time integration"},
  {"element",               "",       Choice<NumericsSpec>{element_words, [](NumericsSpec& n, int word) { n.element = static_cast<ElementKind>(word); },
                                               [](const NumericsSpec& n) { return static_cast<int>(n.element); }},
                                                                           none,                 "beam element; rotation_vector fails after a full turn of the string's top"},
  {"kernel",                "",       Choice<NumericsSpec>{kernel_words, [](NumericsSpec& n, int word) { n.kernel = static_cast<Kernel>(word); },
                                               [](const NumericsSpec& n) { return static_cast<int>(n.kernel); }},
                                                                           none,                 "instruction set for the arithmetic; auto: the widest of this processor. Runs repeat bit for bit with the same kernel; kernels differ in rounding"},
  {"step",                  "s",      &NumericsSpec::step,                 between(0.0, 0.05),   "time step of the physics, 1e-5 or more; 0: variable, as long as the tolerance allows", no_kind, every_kind, "0; 0.01 at a level by hand or by a method without variable steps"},
  {"element_length",        "m",      &NumericsSpec::element_length,       between(0.0, 50.0),   "longest element, 0.1 or more; 0: by the hole. It is 4.75 m where the hole inclines or friction below pushes the pipe, and a stand and a half above; 9.5 m higher up. Instead of 4.75 m: 9.5 m for a tolerance of 0.05 or more, 3.17 m below 0.02, 2.38 m below 0.005", no_kind, every_kind, "by the hole"},
  {"pushed_element_length", "m",      &NumericsSpec::pushed_element_length, between(0.0, 50.0),  "longest element where friction pushes pipe that slides down, 0.1 or more, if shorter than element_length; 0: as elsewhere"},
  {"guided_element_length", "m",      &NumericsSpec::guided_element_length, between(0.0, 50.0),  "longest element of guided pipe that friction does not push, if longer than element_length. Two joints form one element, in the last part up to a stand; 0: as elsewhere"},
  {"tolerance",             "-",      &NumericsSpec::tolerance,            between(1e-6, 0.5),   "allowed error of the outputs in `needs`, relative to their range; for variable steps, level auto and the mesh by the hole"},
  {"refinement",            "-",      &NumericsSpec::refinement,           between(1.0, 64.0),   "factor by which elements and steps are shorter; the difference that it makes is the numerical error, as `drill verify` shows"},
  {"companion",             "",       Choice<NumericsSpec>{companion_words, [](NumericsSpec& n, int word) { n.companion = static_cast<CompanionKind>(word); },
                                               [](const NumericsSpec& n) { return static_cast<int>(n.companion); }},
                                                                           none,                 "second model of the rig with the same commands. The difference of the two is the measured error of each output, on which `accuracy_warning` depends. finer: elements and steps half as long, three times the computing time of the run. coarser: twice as long, half the time, but many false warnings. none: no error is measured. auto: finer where level is auto, else none"},
  {"judge",                 "",       Choice<NumericsSpec>{judge_words, [](NumericsSpec& n, int word) { n.judge = static_cast<Judge>(word); },
                                               [](const NumericsSpec& n) { return static_cast<int>(n.judge); }},
                                                                           none,                 "values whose error is measured. truth: the true ones. readings: those of the instruments with their filter, delay, rate and resolution, so that only errors count which a controller can see"},
  {"reference_tolerance",   "-",      &NumericsSpec::reference_tolerance,  between(1e-10, 1e-2), "integrator ida: local error of velocities (m/s, rad/s, and relative); of positions (m, rad) a hundredth of it"},
  {"reference_order",       "",       &NumericsSpec::reference_order,      between(1, 5),        "integrator ida: highest order of its BDF; orders above 2 need shorter steps for waves with little damping"},
  {"reference_index",       "",       &NumericsSpec::reference_index,      between(2, 3),        "integrator ida: index of the DAE; 2: stabilised; 3 is there to show how it fails"},
  {"newton_tolerance",      "m, rad", &NumericsSpec::newton_tolerance,     between(1e-12, 1e-3), "error that Newton's iteration may leave in the changes of a step"},
  {"structural_damping",    "s",      &NumericsSpec::structural_damping,   between(0.0, 0.1),    "c of stress = E (strain + c strain rate), for axial strain, twist and bending"},
}};

// clang-format on

}  // namespace drill_rig_sim
