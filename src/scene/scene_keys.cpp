#include "scene_keys.h"

namespace drill_rig_sim
{
const std::vector<const char*> part_type_words = {"bit", "mud_motor", "collar", "stabilizer", "mwd", "pipe", "rotary_steerable"};
const std::vector<const char*> bit_torque_words = {"stribeck", "detournay", "regenerative"};
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
constexpr unsigned stribeck = kind(BitTorqueModel::stribeck), regenerative = kind(BitTorqueModel::regenerative),
                   drag = kind(BitTorqueModel::detournay) | regenerative;
constexpr unsigned bingham = kind(RheologyLaw::bingham), yields = kind(RheologyLaw::herschel_bulkley), thins = kind(RheologyLaw::power_law) | yields;
constexpr Range turn = between(-360.0, 360.0);

}  // namespace

// clang-format off
const Table<Scene> scene_keys = {"", "The scene file's top level.", {
  // key                    unit      field                                allowed               meaning
  {"name",                  "",       &Scene::name,                        none,                 "what the scene is called; letters, digits and _", must},
  {"well",                  "",       Nested{},                            none,                 "the hole", must},
  {"formation",             "",       Nested{},                            none,                 "list of rock layers, top down by true vertical depth", must},
  {"mud",                   "",       Nested{},                            none,                 "the drilling fluid"},
  {"string",                "",       Nested{},                            none,                 "list of drillstring parts, from the bit up", must},
  {"rig",                   "",       Nested{},                            none,                 "hoisting, top drive and mud pump"},
  {"contact",               "",       Nested{},                            none,                 "contact of string and wall"},
  {"trajectory",            "",       Nested{},                            none,                 "correction of the drilled path"},
  {"start",                 "",       Nested{},                            none,                 "the state at time 0", must},
  {"numerics",              "",       Nested{},                            none,                 "how the equations are solved"},
  {"instruments",           "",       Nested{},                            none,                 "what the sensors make of the truth"},
  {"needs",                 "",       WordSet<Scene>{need_words, &Scene::needs}, none,           "outputs that matter; `accuracy_warning` where the level does not represent one"},
  {"connections",           "",       Choice<Scene>{connections_words, [](Scene& s, int word) { s.connections = static_cast<Connections>(word); },
                                                    [](const Scene& s) { return static_cast<int>(s.connections); }},
                                                                           none,                 "auto: the crew adds a stand where the block has come down, and takes one away where it has come up; off: slips and connections are commanded"},
  {"program",               "",       Nested{},                            none,                 "list of commands at simulated times, for the offline runner and demos"},
  {"operations",            "",       Nested{},                            none,                 "list of tasks, each ends on a condition; `program` is a time schedule"},
}};

const Table<WellSpec> well_keys = {"well", "The hole before drilling starts. Give `survey` or `stations`.", {
  {"survey",                "",       Nested{},                            none,                 "the survey's file, a table (CSV) or a WITSML trajectory, or a block `well.survey`; counts from the scene file's folder"},
  {"stations",              "m, deg", Nested{},                            none,                 "list of [measured depth, inclination, azimuth], the first at depth 0 or tied in"},
  {"tie_in",                "",       Nested{},                            none,                 "where the first station lies, if that is below depth 0: a smooth hole leads there; instead of the CSV file's columns"},
  {"hole_depth",            "m",      &WellSpec::hole_depth,               between(0.1, 20000.0), "measured depth of the hole's bottom; beyond the last station with `project`", no_kind, every_kind, "the last station"},
  {"project",               "",       Choice<WellSpec>{projection_words, [](WellSpec& w, int i) { w.project = static_cast<Projection>(i); }, [](const WellSpec& w) { return static_cast<int>(w.project); }}, none, "how the hole goes on to a hole_depth up to 30.5 m beyond the last station: in its direction, or on the last interval's arc"},
  {"sections",              "",       Nested{},                            none,                 "list of hole sections, top down; the last reaches hole_depth", must},
  {"pilot_depth",           "m",      &WellSpec::pilot_depth,              between(0.0, 20000.0), "measured depth down to which a narrower hole is there already, which the bit reams from hole_depth on; 0: none"},
  {"pilot_diameter",        "m",      &WellSpec::pilot_diameter,           between(0.0, 1.0),    "of that hole, at most 0.95 of the bit's"},
}};

const Table<SurveyFormat> survey_keys = {"well.survey", "A survey's file and how it is to be read, where its header does not define it. `--columns MAP.yaml` of `drill survey`, `score` and `plot` takes the same keys, but `file`.", {
  {"file",                  "",       Nested{},                            none,                 "the survey's file", survey_of_scene, survey_of_scene},
  {"columns",               "",       Nested{},                            none,                 "names and units of the columns"},
  {"delimiter",             "",       &SurveyFormat::delimiter,            none,                 "between cells: `\",\"`, `\";\"`, bar, tab or space; decimal commas are read where it is not a comma, digits in groups where the decimal sign is sure (`1,234.5`, `1.234,5`, `1 234`)", no_kind, every_kind, "by the header"},
  {"pass_over",             "",       Flag<SurveyFormat>{&SurveyFormat::pass_over}, none,        "passes over stations without a value (empty or -999.25) and those that equal the one before; a vertical station needs no azimuth then", no_kind, every_kind, "false"},
}};

const Table<SurveyFormat> survey_columns_keys = {"well.survey.columns", "Which columns of a survey's table are what, where the usual names are not enough. Only what is unclear needs to be given.", {
  {"md",                    "",       Nested{},                            none,                 "measured depth"},
  {"inclination",           "",       Nested{},                            none,                 "from vertical down"},
  {"azimuth",               "",       Nested{},                            none,                 "clockwise from north"},
  {"north",                 "",       Nested{},                            none,                 "of the rotary table; used where the first station lies below it, as east and tvd"},
  {"east",                  "",       Nested{},                            none,                 "of the rotary table"},
  {"tvd",                   "",       Nested{},                            none,                 "true vertical depth"},
}};

const Table<SurveyColumn> survey_column_keys = {"well.survey.columns.*", "A column.", {
  {"column",                "",       &SurveyColumn::column,               none,                 "its name in the header", no_kind, every_kind, "by the usual names"},
  {"unit",                  "",       &SurveyColumn::unit,                 none,                 "of a length such as m, ft or ftUS (US survey foot), of an angle such as deg, rad or gon", no_kind, every_kind, "as the header says"},
}};

const Table<TieIn> tie_in_keys = {"well.tie_in", "Where a survey's first station below the rotary table lies. The hole above it leaves the table vertically and is made of straight pieces and arcs of at most 15 deg/30 m.", {
  {"north",                 "m",      &TieIn::north,                       between(-20000.0, 20000.0), "of the rotary table"},
  {"east",                  "m",      &TieIn::east,                        between(-20000.0, 20000.0), "of the rotary table"},
  {"tvd",                   "m",      &TieIn::tvd,                         above(0.0, 20000.0),  "true vertical depth", must},
}};

const Table<HoleSection> section_keys = {"well.sections[]", "A stretch of hole, from the end of the section above it.", {
  {"to",                    "m",      &HoleSection::to,                    between(0.01, 20000.0), "measured depth of its lower end", must},
  {"diameter",              "m",      &HoleSection::diameter,              between(0.03, 2.0),   "hole diameter", must},
  {"friction",              "-",      &HoleSection::friction,              between(0.0, 5.0),    "kinetic friction coefficient of string on wall", must},
  {"static_ratio",          "-",      &HoleSection::static_ratio,          between(1.0, 5.0),    "static / kinetic friction there", no_kind, every_kind, "of `contact`"},
  {"stribeck_speed",        "m/s",    &HoleSection::stribeck_speed,        between(1e-4, 10.0),  "slip speed over which friction falls there", no_kind, every_kind, "of `contact`"},
}};

const Table<FormationLayer> layer_keys = {"formation[]", "A layer of rock; the last one goes on below its base. ROP = drillability (weight - threshold)^weight_exponent bit_speed^speed_exponent.", {
  {"to_tvd",                "m",      &FormationLayer::to_tvd,             above(0.0, 1e6),      "true vertical depth of its base; the last layer goes on below", must},
  {"drillability",          "m/s; N; rad/s", &FormationLayer::drillability, above(0.0, 1.0),     "factor K of the rate of penetration", must},
  {"weight_exponent",       "-",      &FormationLayer::weight_exponent,    between(0.5, 3.0),    "exponent of the weight"},
  {"speed_exponent",        "-",      &FormationLayer::speed_exponent,     between(0.0, 2.0),    "exponent of the bit's speed"},
  {"threshold",             "N",      &FormationLayer::threshold,          between(0.0, 1e6),    "weight below which the rock does not break"},
  {"dip_deg",               "deg",    &FormationLayer::dip,                between(0.0, 90.0),   "dip of the beds below the horizontal"},
  {"strike_deg",            "deg",    &FormationLayer::strike,             turn,                 "azimuth of the strike; the beds dip to its right"},
  {"anisotropy",            "-",      &FormationLayer::anisotropy,         below(0.0, 1.0),      "0: drills alike in all directions"},
  {"friction",              "-",      &FormationLayer::friction,           between(0.0, 5.0),    "kinetic friction coefficient of string on wall in hole that the run drills in it, instead of the section's", no_kind, every_kind, "of the section"},
}};

const Table<MudSpec> mud_keys = {"mud", "The drilling fluid around and inside the string.", {
  {"density",               "kg/m3",  &MudSpec::density,                   between(0.0, 3000.0), "0: air, no buoyancy"},
  {"viscosity",             "Pa s",   &MudSpec::viscosity,                 between(0.0, 1.0),    "dynamic viscosity (0.02 Pa s is 20 cP, an assumption; plastic viscosities of muds are 5 to 60 cP): it damps the string's waves, see the three keys below; 0: nothing does. With `rheology` of the Newtonian mud alone; of the others their plastic viscosity damps"},
  {"axial_damping",         "N s/m per m", &MudSpec::axial_damping,        between(0.0, 1e4),    "viscous drag along the string", no_kind, every_kind, "by the viscosity, for a wave of 1 Hz: 6.3 for 5 in pipe"},
  {"lateral_damping",       "N s/m per m", &MudSpec::lateral_damping,      between(0.0, 1e5),    "viscous drag across the string, the part that grows with its speed", no_kind, every_kind, "by the viscosity, for a wave of 1 Hz: 19 for 5 in pipe in an 8 1/2 in hole"},
  {"drag_coefficient",      "-",      &MudSpec::drag_coefficient,          between(0.0, 10.0),   "C_d of the drag across the string that grows with the square of its speed"},
  {"torsional_damping",     "N m s/rad per m", &MudSpec::torsional_damping, between(0.0, 100.0), "viscous drag against spin", no_kind, every_kind, "by the viscosity, for a wave of 1 Hz: 0.02 for 5 in pipe"},
  {"bulk_modulus",          "Pa",     &MudSpec::bulk_modulus,              between(1e7, 1e11),   "of the mud in pipe and hole, which give way with it: pressure follows the pump by volume / bulk_modulus"},
  {"gel_strength",          "Pa",     &MudSpec::gel_strength,              between(0.0, 100.0),  "after ten minutes' rest, to be broken before mud flows; 1 lb/100 ft2 is 0.479 Pa, muds have 2 to 15 Pa"},
  {"added_mass",            "-",      &MudSpec::added_mass,                between(0.0, 5.0),    "factor on the mass of the mud that moves sideways with the string: in its bore, and around it as the hole confines it"},
  {"rheology",              "",       Nested{},                            none,                 "the mud's flow curve: losses by section, ECD, surge and swab follow from it instead of from `rig.mud_pump.pressure_coefficient`; needs `nozzles` or `nozzle_area` of the bit", no_kind, every_kind, "none"},
  {"fill",                  "m",      Nested{},                            none,                 "level of the mud in a string that is run in on its float: so far it is empty, along it from the rotary table down. One number, or by the depth of the bit `[[bit_depth, level], ...]`, linear between and constant beyond; a level at the bit or deeper: the string is empty. The pump fills it before mud comes to the bit", no_kind, every_kind, "0, full"},
}};

const Table<RheologySpec> rheology_keys = {"mud.rheology", "The mud's flow curve: stress = yield stress + consistency rate^index. Give the numbers of its law, or `readings`.", {
  {"law",                   "",       Choice<RheologySpec>{rheology_words, [](RheologySpec& r, int word) { r.law = static_cast<RheologyLaw>(word); },
                                                           [](const RheologySpec& r) { return static_cast<int>(r.law); }},
                                                                           none,                 "newtonian has `mud.viscosity`", must},
  {"readings",              "rpm, deg", Nested{},                          none,                 "of a viscometer (rotor R1, bob B1, spring F1), rows [speed, dial], such as `[[600, 65], [300, 39]]`: at least 1 for newtonian, 2 for bingham and power_law, 3 for herschel_bulkley. 600, 300, 6 and 3 rpm of a Herschel-Bulkley mud as in API RP 13D, others by least squares", no_kind, every_kind, "none"},
  {"plastic_viscosity",     "Pa s",   &RheologySpec::plastic_viscosity,    between(1e-4, 1.0),   "PV", no_kind, bingham, "of the readings"},
  {"yield_point",           "Pa",     &RheologySpec::yield_point,          between(0.0, 200.0),  "YP; 1 lb/100 ft2 is 0.479 Pa", no_kind, bingham, "of the readings"},
  {"yield_stress",          "Pa",     &RheologySpec::yield_stress,         between(0.0, 200.0),  "below which the mud does not flow", no_kind, yields, "of the readings"},
  {"consistency",           "Pa s^n", &RheologySpec::consistency,          between(1e-4, 100.0), "K", no_kind, thins, "of the readings"},
  {"index",                 "-",      &RheologySpec::index,                between(0.1, 1.0),    "n, 1: no shear thinning", no_kind, thins, "of the readings"},
  {"eccentricity",          "-",      &RheologySpec::eccentricity,         between(0.0, 0.95),   "of the string in its hole, offset over clearance: it lowers the annulus's losses, at 0.95 to half"},
}};

const Table<PartSpec> part_keys = {"string[]", "One part of the drillstring; the first is the bit. Masses are in air.", {
  {"name",                  "",       &PartSpec::name,                     none,                 "unique; letters, digits and _", must},
  {"type",                  "",       Choice<PartSpec>{part_type_words, [](PartSpec& p, int word) { p.type = static_cast<PartType>(word); },
                                                       [](const PartSpec& p) { return static_cast<int>(p.type); }},
                                                                           none,                 "what it is", must},
  {"length",                "m",      &PartSpec::length,                   between(0.02, 2000.0), "length of a part that has no `joints`", bit | motor | stabilizer | mwd | steerable, every_kind, "joints * joint_length"},
  {"joints",                "",       CountOrFill<PartSpec>{&PartSpec::joints}, between(1, 10000), "number of joints; `fill`, the last part only: as many as reach the surface", no_kind, jointed},
  {"joint_length",          "m",      &PartSpec::joint_length,             between(0.5, 30.0),   "length of one joint", no_kind, jointed, "length"},
  {"outer_diameter",        "m",      &PartSpec::outer_diameter,           between(0.01, 1.0),   "of the body", tube, tube},
  {"inner_diameter",        "m",      &PartSpec::inner_diameter,           between(0.0, 1.0),    "of the bore", tube, tube},
  {"linear_mass",           "kg/m",   &PartSpec::linear_mass,              between(0.1, 5000.0), "in air, tool joints included", tube, tube},
  {"young_modulus",         "Pa",     &PartSpec::young_modulus,            between(1e9, 1e12),   "steel 206e9"},
  {"poisson_ratio",         "-",      &PartSpec::poisson_ratio,            between(0.0, 0.49),   "steel 0.3"},
  {"axial_stiffness",       "N",      Inside<PartSpec>{[](PartSpec& p) -> double& { return p.stiffness.axial; }}, between(1e3, 1e13), "E A, beside the two below; the diameters then say where it touches and where mud is", no_kind, tube, "of the tube"},
  {"bending_stiffness",     "N m2",   Inside<PartSpec>{[](PartSpec& p) -> double& { return p.stiffness.bending; }}, between(1e-3, 1e12), "E I", no_kind, tube, "of the tube"},
  {"torsional_stiffness",   "N m2",   Inside<PartSpec>{[](PartSpec& p) -> double& { return p.stiffness.torsional; }}, between(1e-3, 1e12), "G J", no_kind, tube, "of the tube"},
  {"polar_inertia",         "kg m2/m", &PartSpec::polar_inertia,           above(0.0, 1e4),      "about the axis, in air", no_kind, tube, "of the tube with this linear_mass"},
  {"yield_strength",        "Pa",     &PartSpec::yield_strength,           between(1e6, 1e10),   "over_stress is reported above it; drill pipe of grade G-105"},
  {"make_up_torque",        "N m",    &PartSpec::make_up_torque,           between(0.0, 1e7),    "of its connections; over_torque is reported above it; 0: not known"},
  {"density",               "kg/m3",  &PartSpec::density,                  between(500.0, 20000.0), "of its material; displaced volume = mass / density"},
  {"friction_radius",       "m",      &PartSpec::friction_radius,            above(0.0, 0.5),      "lever of the wall's friction about its axis; smaller than where it touches for pipe in non-rotating protectors", no_kind, tube, "where it touches"},
  {"contact",               "",       Nested{},                            none,                 "its own law of wall contact instead of the scene's"},
  {"tool_joint_diameter",   "m",      Inside<PartSpec>{of_tool_joint},     between(0.01, 1.0),   "outer diameter at the joints' ends", no_kind, pipe, "outer_diameter"},
  {"blade_diameter",        "m",      Inside<PartSpec>{of_blades},         between(0.01, 1.0),   "outer diameter over the blades", stabilizer, stabilizer},
  {"nozzles",               "1/32 in", Nested{},                           none,                 "diameters of its nozzles, such as `[12, 12, 12]`; with another unit that is written; with `mud.rheology`", no_kind, bit, "none"},
  {"nozzle_area",           "m2",     Inside<PartSpec>{of_bit<&BitSpec::nozzle_area>}, between(1e-6, 0.1), "all of its flow area, instead of `nozzles`", no_kind, bit, "of the nozzles"},
  {"speed_lag",             "s",      Inside<PartSpec>{of_bit<&BitSpec::speed_lag>}, between(1e-3, 10.0),   "lag of the speed that drills behind the bit's: the rate of penetration is a law of means over turns", no_kind, bit},
  {"squeeze_film_damping",  "N s/m",  Inside<PartSpec>{of_film},           between(0.0, 1e8),    "of sideways motion, by the mud squeezed between wall and gauge, or blades (50000 by default)", no_kind, bit | stabilizer},
  {"sensor_offset",         "m",      Inside<PartSpec>{of_sensor},         between(0.0, 2000.0), "from the part's lower end up to the sensor", no_kind, mwd},
  {"mass",                  "kg",     Inside<PartSpec>{of_bit<&BitSpec::mass>}, between(0.1, 1e5),    "of the bit", bit, bit},
  {"diameter",              "m",      Inside<PartSpec>{of_bit<&BitSpec::diameter>}, between(0.03, 1.0),   "gauge of the bit: it drills this hole", bit, bit},
  {"side_cutting",          "-",      Inside<PartSpec>{of_bit<&BitSpec::side_cutting>}, between(0.0, 1.0),    "lateral over axial drillability: PDC bits 0.001 to 0.1, less the longer their gauge", no_kind, bit},
  {"gauge_length",          "m",      Inside<PartSpec>{of_bit<&BitSpec::gauge_length>}, between(0.0, 2.0),    "of its gauge pads, up from half a diameter above its face, inside its length: they resist a tilt of the bit in its hole, and cut nothing; 0: a ball touches, which tilts freely", no_kind, bit},
  {"gauge_clearance",       "m",      Inside<PartSpec>{of_bit<&BitSpec::gauge_clearance>}, between(0.0, 0.02),   "of the pads' upper end, all round, in the hole that the bit cuts: what the bit tilts freely is this over gauge_length", no_kind, bit},
  {"torque",                "",       Nested{},                            none,                 "law of the torque on bit", no_kind, bit},
  {"bottom",                "",       Nested{},                            none,                 "law of the bit's contact with the hole's bottom; not with `torque: {model: regenerative}`", no_kind, bit},
  {"bend_deg",              "deg",    Inside<PartSpec>{of_motor<&MotorSpec::bend>}, between(0.0, 5.0),    "angle of the bent housing", no_kind, motor},
  {"bit_to_bend",           "m",      Inside<PartSpec>{of_motor<&MotorSpec::bit_to_bend>}, between(0.01, 100.0), "from the bit's face to the bend; lies inside the motor", motor, motor},
  {"sleeve_diameter",       "m",      Inside<PartSpec>{of_motor<&MotorSpec::sleeve_diameter>}, between(0.0, 1.0), "over the blades on its bearing housing, which turn with the string; 0: none", no_kind, motor},
  {"bit_to_sleeve",         "m",      Inside<PartSpec>{of_motor<&MotorSpec::bit_to_sleeve>}, between(0.0, 100.0), "from the bit's face to the middle of these blades; lies inside the motor", no_kind, motor},
  {"displacement_per_rev",  "m3/rev", Inside<PartSpec>{of_motor<&MotorSpec::displacement_per_rev>}, between(1e-4, 1.0),   "mud volume that turns the motor once", motor, motor},
  {"stall_torque",          "N m",    Inside<PartSpec>{of_motor<&MotorSpec::stall_torque>}, between(1.0, 1e6),    "torque at which the motor stalls", motor, motor},
  {"curve_exponent",        "-",      Inside<PartSpec>{of_motor<&MotorSpec::curve_exponent>}, between(1.0, 20.0),   "b of the motor's speed, N_0 (1 - (T/T_stall)^b); 1 a straight line, power sections 3 to 5", no_kind, motor},
  {"efficiency",            "-",      Inside<PartSpec>{of_motor<&MotorSpec::efficiency>}, between(0.3, 1.0),    "mechanical: share of the pressure's torque that comes out, the rest is friction in rotor and bearings; charts of real power sections: 0.7 to 0.9", no_kind, motor},
  {"bit_to_pads",           "m",      Inside<PartSpec>{of_steerable<&SteerableSpec::bit_to_pads>}, between(0.01, 100.0), "from the bit's face to the pads that push it; lies inside the tool", no_kind, steerable, "required with pad_force"},
  {"pad_force",             "N",      Inside<PartSpec>{of_steerable<&SteerableSpec::pad_force>}, above(0.0, 2e5), "on the tool at full steering: it pushes the bit", no_kind, steerable, "this or tilt_deg"},
  {"bit_to_pivot",          "m",      Inside<PartSpec>{of_steerable<&SteerableSpec::bit_to_pivot>}, between(0.01, 100.0), "from the bit's face to the pivot at which the shaft below leans; lies inside the tool", no_kind, steerable, "required with tilt_deg"},
  {"tilt_deg",              "deg",    Inside<PartSpec>{of_steerable<&SteerableSpec::tilt>}, above(0.0, 5.0), "of the shaft against the collar at full steering, reached in 5 s: it points the bit", no_kind, steerable, "this or pad_force"},
  {"downlink_bit_time",     "s",      Inside<PartSpec>{of_steerable<&SteerableSpec::downlink_bit_time>}, between(1.0, 120.0), "of a downlink by the pump's flow", no_kind, steerable},
}};

namespace
{
// the same keys for the three places that take a contact law; each place has its own defaults
std::vector<Key<ContactLaw>> contact_law_keys()
{
  return {
  {"stiffness",             "N/m^e",  &ContactLaw::stiffness,              between(1e3, 1e13),   "k of F = k d^e (1 + c d')"},
  {"exponent",              "-",      &ContactLaw::exponent,               between(1.0, 3.0),    "e; Hertz 1.5"},
  {"damping",               "s/m",    &ContactLaw::damping,                between(0.0, 100.0),  "c"},
  };
}
}  // namespace

const Table<ContactLaw> part_contact_keys = {"string[].contact", "Wall contact of one part.", contact_law_keys()};
const Table<ContactLaw> bit_bottom_keys = {"string[].bottom", "Contact of the bit with the hole's bottom.", contact_law_keys()};

const Table<BitTorqueSpec> bit_torque_keys = {"string[].torque", "Torque on bit. stribeck: mu(speed) weight diameter / 3, mu falling from static to kinetic; detournay: cutting plus wear-flat friction; regenerative: the same, weight and torque by the depth of cut that each blade finds in what the one before left, without `bottom` and without friction of the face across it.", {
  {"model",                 "",       Choice<BitTorqueSpec>{bit_torque_words, [](BitTorqueSpec& t, int word) { t.model = static_cast<BitTorqueModel>(word); },
                                                            [](const BitTorqueSpec& t) { return static_cast<int>(t.model); }},
                                                                           none,                 "which law"},
  {"static",                "-",      &BitTorqueSpec::static_friction,     between(0.0, 5.0),    "mu of the bit at rest, at least `kinetic`", no_kind, stribeck},
  {"kinetic",               "-",      &BitTorqueSpec::kinetic_friction,    between(0.0, 5.0),    "mu of the bit turning fast", no_kind, stribeck},
  {"speed_rpm",             "rpm",    &BitTorqueSpec::speed,               between(0.1, 1000.0), "bit speed over which mu falls", no_kind, stribeck},
  {"cutting_energy",        "J/m3",   &BitTorqueSpec::cutting_energy,      between(0.0, 1e10),   "intrinsic specific energy of the rock, if it must agree with the drillability; 0: what that says", no_kind, drag},
  {"wear_friction",         "-",      &BitTorqueSpec::wear_friction,       between(0.0, 5.0),    "friction coefficient times bit constant of the wear flats", no_kind, drag},
  {"wear_weight",           "N",      &BitTorqueSpec::wear_weight,         between(0.0, 1e6),    "weight that the wear flats carry, up to the rock's threshold", no_kind, drag},
  {"blades",                "",       &BitTorqueSpec::blades,              between(1, 12),       "alike and evenly set, each cuts what the one before left", no_kind, regenerative},
}};

const Table<RigSpec> rig_keys = {"rig", "The rig above the rotary table.", {
  {"hoisting",              "",       Nested{},                            none,                 "drill line, block and winch"},
  {"top_drive",             "",       Nested{},                            none,                 "rotary drive and torque meter"},
  {"mud_pump",              "",       Nested{},                            none,                 "pump and stand pipe"},
  {"heave",                 "",       Nested{},                            none,                 "of a floating rig"},
}};

const Table<HoistingSpec> hoisting_keys = {"rig.hoisting", "Drill line, travelling block and winch.", {
  {"sheaves",               "",       &HoistingSpec::sheaves,              between(1, 12),       "in the travelling block; twice as many lines"},
  {"line_ea",               "N",      &HoistingSpec::line_ea,              between(1e5, 1e10),   "E A of the drill line"},
  {"crown_height",          "m",      &HoistingSpec::crown_height,         between(5.0, 200.0),  "crown block above the rotary table"},
  {"fixed_length",          "m",      &HoistingSpec::fixed_length,         between(0.0, 1000.0), "strung length outside the block: fast and dead line"},
  {"block_mass",            "kg",     &HoistingSpec::block_mass,           between(1.0, 3e5),    "travelling block and top drive"},
  {"sheave_efficiency",     "-",      &HoistingSpec::sheave_efficiency,    between(0.8, 1.0),    "of one sheave"},
  {"rail_friction",         "-",      &HoistingSpec::rail_friction,        between(0.0, 0.5),    "of the block on its guide rail, over its weight"},
  {"line_damping",          "-",      &HoistingSpec::line_damping,         between(0.0, 1.0),    "of the block by itself on its lines, over critical"},
  {"max_speed",             "m/s",    &HoistingSpec::max_speed,            between(0.001, 20.0), "of the block"},
  {"max_acceleration",      "m/s2",   &HoistingSpec::max_acceleration,     between(0.001, 50.0), "of the block"},
  {"max_hook_load",         "N",      &HoistingSpec::max_hook_load,        between(1e3, 5e7),    "the winch does not pull more"},
  {"min_hook_load",         "N",      &HoistingSpec::min_hook_load,        between(0.0, 5e7),    "below it the winch does not lower: slack line; 0: it does"},
  {"trip_hook_load",        "N",      &HoistingSpec::trip_hook_load,       between(0.0, 5e7),    "over-pull: where `hook_load` of `rig_state` reaches it while raising, the brake is set until a command that does not raise; 0: never"},
  {"lowest_block_height",   "m",      &HoistingSpec::lowest_block_height,  between(0.0, 200.0),  "top-drive shaft above the rotary table"},
  {"highest_block_height",  "m",      &HoistingSpec::highest_block_height, between(0.0, 200.0),  "below crown_height"},
  {"connection_time",       "s",      &HoistingSpec::connection_time,      between(1.0, 3600.0), "that the string rests in the slips, broken out, while pipe is added or taken away; half of it the block runs, longer where its limits require it"},
  {"stand_joints",          "",       &HoistingSpec::stand_joints,         between(1, 4),        "joints of the last part in a stand"},
}};

const Table<TopDriveSpec> top_drive_keys = {"rig.top_drive", "Rotary drive with a PI speed loop, and the spring of the torque meter.", {
  {"inertia",               "kg m2",  &TopDriveSpec::inertia,              between(1.0, 1e6),    "of the rotor, at the shaft"},
  {"proportional_gain",     "N m s/rad", &TopDriveSpec::proportional_gain, between(0.0, 1e7),    "of the speed loop"},
  {"integral_gain",         "N m/rad", &TopDriveSpec::integral_gain,       between(0.0, 1e7),    "of the speed loop"},
  {"max_torque",            "N m",    &TopDriveSpec::max_torque,           between(1.0, 1e6),    "of the drive"},
  {"max_speed_rpm",         "rpm",    &TopDriveSpec::max_speed,            between(1.0, 1000.0), "of the drive"},
  {"max_acceleration_rpm",  "rpm/s",  &TopDriveSpec::max_acceleration,     between(0.0, 1e4),    "so fast the speed that the loop follows changes; 0: at once (ANGLE and OSCILLATE: 2 rad/s2)"},
  {"max_power",             "W",      &TopDriveSpec::max_power,            between(1e3, 1e8),    "of the drive"},
  {"meter_stiffness",       "N m/rad", &TopDriveSpec::meter_stiffness,     between(1e3, 1e9),    "of the torque meter's spring"},
  {"gearbox_friction",      "N m",    &TopDriveSpec::gearbox_friction,     between(0.0, 1e5),    "against the rotor's turning"},
  {"brake_torque",          "N m",    &TopDriveSpec::brake_torque,         between(0.0, 1e6),    "of the brake, which comes on at a set point of 0 once the rotor stands; 0: none"},
  {"soft_torque",           "",       Nested{},                            none,                 "mode SOFT_TORQUE"},
  {"z_torque",              "",       Nested{},                            none,                 "mode Z_TORQUE"},
}};

namespace
{
std::vector<Key<DriveImpedance>> impedance_rows(const char* damping, const char* stiffness)
{
  return {
  {"damping",               "N m s/rad", &DriveImpedance::damping,         between(0.0, 1e6),    "P; 0: as by default", no_kind, every_kind, damping},
  {"stiffness",             "N m/rad", &DriveImpedance::stiffness,         between(0.0, 1e6),    "I; 0: as by default", no_kind, every_kind, stiffness},
  {"inertia_compensation",  "-",      &DriveImpedance::inertia_compensation, between(0.0, 0.99), "c: the share of the rotor's inertia that the drive hides, by feeding the torque meter back"},
  };
}
}  // namespace

const Table<DriveImpedance> soft_torque_keys = {"rig.top_drive.soft_torque", "SOFT_TORQUE makes the drive an impedance P + s (1 - c) inertia + I/s in front of the string.", impedance_rows("twice the pipe's impedance", "what cancels the inertia left at the string's slowest torsion, at 1 Hz where that is faster")};

const Table<DriveImpedance> z_torque_keys = {"rig.top_drive.z_torque", "Z_TORQUE does too, with little of its inertia left: over a band of frequencies.", impedance_rows("the pipe's impedance", "P w / 8, w the string's slowest torsion, at most that of 1 Hz")};

const Table<MudPumpSpec> mud_pump_keys = {"rig.mud_pump", "Pump and stand pipe.", {
  {"max_flow",              "m3/s",   &MudPumpSpec::max_flow,              above(0.0, 1.0),      "of the pump"},
  {"flow_ramp",             "m3/s2",  &MudPumpSpec::flow_ramp,             above(0.0, 1000.0),   "rate at which the pump's flow changes"},
  {"stroke_volume",         "m3",     &MudPumpSpec::stroke_volume,         between(1e-4, 0.1),   "that a stroke delivers; two triplexes side by side, 6 in liners and 12 in strokes, 95 % full"},
  {"relief_pressure",       "Pa",     &MudPumpSpec::relief_pressure,       between(1e5, 2e8),    "at which the relief valve by the pump opens; what the string does not take at it goes back to the tanks"},
  {"trip_pressure",         "Pa",     &MudPumpSpec::trip_pressure,         between(0.0, 2e8),    "where `stand_pipe_pressure` of `rig_state` reaches it the pump stops until a flow of 0 is commanded; 0: never"},
  {"surface_lines",         "m",      Nested{},                            none,                 "pipes between pump and string, rows [length, diameter]: standpipe, hose, swivel or wash pipe, kelly; with `mud.rheology`", no_kind, every_kind, "none"},
  {"pressure_coefficient",  "Pa s2/m6", &MudPumpSpec::pressure_coefficient, between(0.0, 1e12),  "losses of string, bit and annulus at max_flow / max_flow^2"},
  {"loss_exponent",         "-",      &MudPumpSpec::loss_exponent,         between(1.0, 2.0),    "m: at other flows losses go with Q^m; 2 rough turbulence, 1.86 smooth, a record of the field 1.56"},
}};

const Table<HeaveSpec> heave_keys = {"rig.heave", "A floating rig goes up and down on regular waves, from rest within five periods: floor, winch, rail and slips together, without a compensator; one that moves the winch has `floor_height` and `floor_velocity` of `rig_state` to go by. Heights of the block are above the floor; a block that stands at its lowest or highest place swings against its stop (`stop_reached`). `tare` and operations go by the mean of the hook load over a period; topics carry it as it is, and `instruments.surface.hook_load.filter_time` calms it. Surge and swab are of friction only: the mud's inertia, as much again in a deep well, is left out. Of a rig with a compensator the amplitude is what that leaves; pipe in the slips, which then heaves by all, heaves by that too here.", {
  {"amplitude",             "m",      &HeaveSpec::amplitude,               between(0.0, 10.0),   "about the mean place of the rotary table, where depths begin, at most 3 m/s2 of acceleration; 0: the rig stands on the ground"},
  {"period",                "s",      &HeaveSpec::period,                  between(2.0, 60.0),   "of the waves"},
}};

const Table<ContactSpec> contact_keys = {"contact", "Contact of string and wall, F = k d^e (1 + c d'), and the shape of the friction law; `friction` of the hole sections is kinetic.", {
  {"stiffness",             "N/m^e",  Inside<ContactSpec>{[](ContactSpec& c) -> double& { return c.law.stiffness; }}, between(1e3, 1e13), "k"},
  {"assembly_stiffness",    "N/m^e",  &ContactSpec::assembly_stiffness,    between(1e3, 1e13),   "least k under the bit's gauge, blades and a motor's sleeve: what they embed themselves is missing from the bit's side force"},
  {"exponent",              "-",      Inside<ContactSpec>{[](ContactSpec& c) -> double& { return c.law.exponent; }},  between(1.0, 3.0),  "e; Hertz 1.5"},
  {"damping",               "s/m",    Inside<ContactSpec>{[](ContactSpec& c) -> double& { return c.law.damping; }},   between(0.0, 100.0), "c"},
  {"stribeck_speed",        "m/s",    &ContactSpec::stribeck_speed,        between(1e-4, 10.0),  "slip speed over which friction falls from static to kinetic"},
  {"static_ratio",          "-",      &ContactSpec::static_ratio,          between(1.0, 5.0),    "static / kinetic friction"},
  {"stribeck_curve",        "",       Choice<ContactSpec>{stribeck_curve_words, [](ContactSpec& c, int word) { c.stribeck_curve = static_cast<StribeckCurve>(word); },
                                               [](const ContactSpec& c) { return static_cast<int>(c.stribeck_curve); }},
                                                                           none,                 "how it falls: exp(-(v/stribeck_speed)^2) or exp(-v/stribeck_speed)"},
  {"growth_at_rest",        "-",      Inside<ContactSpec>{[](ContactSpec& c) -> double& { return c.growth.per_fold; }}, between(0.0, 5.0), "what static_ratio grows by while a contact rests, for each e-fold of 1 + time/growth_time; 0: it does not"},
  {"growth_time",           "s",      Inside<ContactSpec>{[](ContactSpec& c) -> double& { return c.growth.time; }}, between(1e-3, 1e6), "time at rest from which that growth is logarithmic"},
  {"growth_limit",          "-",      Inside<ContactSpec>{[](ContactSpec& c) -> double& { return c.growth.limit; }}, between(0.0, 10.0), "most that static_ratio grows by"},
  {"tangential_stiffness",  "N/m",    &ContactSpec::tangential_stiffness,  between(1e3, 1e12),   "of the bristle that carries sticking friction"},
  {"tangential_damping",    "-",      &ContactSpec::tangential_damping,    between(0.0, 10.0),   "of that bristle, of critical for the mass at the contact"},
}};

const Table<TrajectorySpec> trajectory_keys = {"trajectory", "Second stage of the correction of the drilled path. Give one of the two.", {
  {"stage_two_length",      "m",      &TrajectorySpec::stage_two_length,   between(0.001, 10.0), "drilled length between corrections"},
  {"stage_two_steps",       "",       &TrajectorySpec::stage_two_steps,    between(1, 1000000),  "physics steps between corrections", no_kind, every_kind, "by length"},
}};

const Table<StartSpec> start_keys = {"start", "At rest, in static equilibrium without friction, winch braked. The toolface is measured from the high side, from north where the hole at the bend inclines by less than 5 deg.", {
  {"bit_depth",             "m",      &StartSpec::bit_depth,               between(0.01, 20000.0), "measured depth of the bit's face", no_kind, every_kind, "hole_depth"},
  {"block_height",          "m",      &StartSpec::block_height,            between(0.0, 200.0),  "top-drive shaft above the rotary table"},
  {"weight_on_bit",         "N",      &StartSpec::weight_on_bit,           between(0.0, 1e6),    "on bottom only: the winch is set so that the bit carries it"},
  {"torque_on_bit",         "N m",    &StartSpec::torque_on_bit,           between(0.0, 1e5),    "on bottom only"},
  {"toolface_deg",          "deg",    &StartSpec::toolface,                turn,                 "of the bend, after the equilibrium"},
}};

const Table<NumericsSpec> numerics_keys = {"numerics", "How the equations are solved.", {
  {"level",                 "",       Choice<NumericsSpec>{level_words, [](NumericsSpec& n, int word) { n.level = static_cast<Level>(word); },
                                               [](const NumericsSpec& n) { return static_cast<int>(n.level); }},
                                                                           none,                 "which motions are modelled. beam3d: all. axial_torsional: along the hole and about it, the string confined to it, its friction a soft string's. hybrid: all near the bit, those two above. auto: the cheapest of them that meets the tolerance in the needs, with the steps and elements that go with it. rigid: as axial_torsional, but the string stretches and twists a hundredth of what it would, for steady loads"},
  {"free_length",           "m",      &NumericsSpec::free_length,          between(0.0, 20000.0), "level hybrid: so far above the bit's face all motions are modelled; 0: the bottom-hole assembly, up to the first drill pipe (more than two stands, its bore over 0.7 of its outer diameter), and two stands", no_kind, every_kind, "the assembly and two stands"},
  {"integrator",            "",       Choice<NumericsSpec>{integrator_words, [](NumericsSpec& n, int word) { n.integrator = static_cast<IntegratorKind>(word); },
                                               [](const NumericsSpec& n) { return static_cast<int>(n.integrator); }},
                                                                           none,                 "method of time integration"},
  {"element",               "",       Choice<NumericsSpec>{element_words, [](NumericsSpec& n, int word) { n.element = static_cast<ElementKind>(word); },
                                               [](const NumericsSpec& n) { return static_cast<int>(n.element); }},
                                                                           none,                 "kind of beam element; rotation_vector fails when the string's top has made a full turn"},
  {"kernel",                "",       Choice<NumericsSpec>{kernel_words, [](NumericsSpec& n, int word) { n.kernel = static_cast<Kernel>(word); },
                                               [](const NumericsSpec& n) { return static_cast<int>(n.kernel); }},
                                                                           none,                 "instructions of the processor that the arithmetic is made of; auto: the widest that it has. Runs repeat bit for bit by one kernel; others differ in rounding"},
  {"step",                  "s",      &NumericsSpec::step,                 between(0.0, 0.05),   "physics step, 1e-5 or more; 0: variable, as long as the tolerance allows", no_kind, every_kind, "0; 0.01 at a level by hand or by a method without variable steps"},
  {"element_length",        "m",      &NumericsSpec::element_length,       between(0.0, 50.0),   "longest element, 0.1 or more; 0, by the hole: 4.75 m where it inclines or friction below pushes the pipe, and a stand and a half above (9.5 m for a tolerance of 0.05 or more, 3.17 m below 0.02, 2.38 m below 0.005), 9.5 m higher up", no_kind, every_kind, "by the hole"},
  {"pushed_element_length", "m",      &NumericsSpec::pushed_element_length, between(0.0, 50.0),  "longest element where friction pushes pipe that slides down, 0.1 or more, if that is shorter than element_length; 0: as elsewhere"},
  {"guided_element_length", "m",      &NumericsSpec::guided_element_length, between(0.0, 50.0),  "longest element of guided pipe that friction does not push, if that is longer than element_length: two joints that are no longer together are one element, of the last part within a stand; 0: as elsewhere"},
  {"tolerance",             "-",      &NumericsSpec::tolerance,            between(1e-6, 0.5),   "of variable steps, level auto and the mesh by the hole: error that they may leave in the needs, over what these range over"},
  {"refinement",            "-",      &NumericsSpec::refinement,           between(1.0, 64.0),   "factor by which elements and steps are shorter: what changes by it is numerical error, as `drill verify` shows"},
  {"companion",             "",       Choice<NumericsSpec>{companion_words, [](NumericsSpec& n, int word) { n.companion = static_cast<CompanionKind>(word); },
                                               [](const NumericsSpec& n) { return static_cast<int>(n.companion); }},
                                                                           none,                 "another model of the rig, which gets the same commands; the difference measures the error of each output, and `accuracy_warning` depends on it. finer: elements and steps half as long, three times the computing time of the run. coarser: twice as long, half the time, but many false warnings. none: the error is not measured. auto: finer where level is auto, else none"},
  {"judge",                 "",       Choice<NumericsSpec>{judge_words, [](NumericsSpec& n, int word) { n.judge = static_cast<Judge>(word); },
                                               [](const NumericsSpec& n) { return static_cast<int>(n.judge); }},
                                                                           none,                 "values whose error is measured. truth: as they are. readings: as the instruments show them, with their filter, delay, rate and resolution: what a controller cannot see is no error then"},
  {"reference_tolerance",   "-",      &NumericsSpec::reference_tolerance,  between(1e-10, 1e-2), "integrator ida: local error of velocities (m/s, rad/s, and relative); of places (m, rad) a hundredth of it"},
  {"reference_order",       "",       &NumericsSpec::reference_order,      between(1, 5),        "integrator ida: highest order of its BDF; above 2 waves that are hardly damped force shorter steps"},
  {"reference_index",       "",       &NumericsSpec::reference_index,      between(2, 3),        "integrator ida: index of the DAE, 2 stabilised; 3 only shows how it fails"},
  {"newton_tolerance",      "m, rad", &NumericsSpec::newton_tolerance,     between(1e-12, 1e-3), "error that Newton's iteration may leave in the increments of a step"},
  {"structural_damping",    "s",      &NumericsSpec::structural_damping,   between(0.0, 0.1),    "c of stress = E (strain + c strain rate), in stretch, twist and bending"},
}};

// clang-format on

}  // namespace drill_rig_sim
