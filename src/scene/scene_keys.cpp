// SPDX-License-Identifier: BSD-3-Clause
#include "scene_keys.h"

// Keys of scene, well, formation and mud; string_keys.cpp, rig_keys.cpp, numerics_keys.cpp, instrument_keys.cpp and
// program_keys.cpp have the others.
namespace drill_rig_sim
{
const std::vector<const char*> need_words = {"hook_load", "torque",    "wob",     "rop",     "bit_speed",
                                             "pressure",  "direction", "contact", "buckling"};
const std::vector<const char*> rheology_words = {"newtonian", "bingham", "power_law", "herschel_bulkley"};

namespace
{
const std::vector<const char*> projection_words = {"none", "straight", "curvature"};
const std::vector<const char*> connections_words = {"off", "auto"};
constexpr unsigned bingham = kind(RheologyLaw::bingham), yields = kind(RheologyLaw::herschel_bulkley),
                   thins = kind(RheologyLaw::power_law) | yields;
}  // namespace

// clang-format off
const Table<Scene> scene_keys = {"", "The scene file's top level.", {
  // key                    unit      field                                allowed               meaning
  {"name",                  "",       &Scene::name,                        none,
      "name of the scene: letters, digits and _", must},
  {"well",                  "",       Nested{},                            none,                 "the hole", must},
  {"formation",             "",       Nested{},                            none,
      "list of rock layers, top down by true vertical depth", must},
  {"mud",                   "",       Nested{},                            none,                 "the drilling fluid"},
  {"string",                "",       Nested{},                            none,
      "list of drillstring parts, from the bit up", must},
  {"rig",                   "",       Nested{},                            none,
      "hoisting, top drive and mud pump"},
  {"contact",               "",       Nested{},                            none,
      "contact of the string with the wall"},
  {"trajectory",            "",       Nested{},                            none,
      "correction of the drilled path"},
  {"start",                 "",       Nested{},                            none,                 "state at time 0", must},
  {"numerics",              "",       Nested{},                            none,                 "how the equations are solved"},
  {"instruments",           "",       Nested{},                            none,
      "sensors: rates, filters, noise, bias, resolution"},
  {"needs",                 "",       WordSet<Scene>{need_words, &Scene::needs}, none,
      "outputs that matter to you; `accuracy_warning` is set where the level does not model one of them"},
  {"connections",           "",       Choice<Scene>{connections_words,
      [](Scene& s, int word) { s.connections = static_cast<Connections>(word); },
      [](const Scene& s) { return static_cast<int>(s.connections); }},
      none, "auto: the crew adds a stand when the block is down and removes one when the block is up; off: slips and "
          "connections are commanded"},
  {"program",               "",       Nested{},                            none,
      "list of commands at simulated times, for the offline runner and demos"},
  {"operations",            "",       Nested{},                            none,
      "list of tasks, each ends on a condition; `program` is a time schedule"},
}};

const Table<WellSpec> well_keys = {"well", "The hole before drilling starts. Give `survey` or `stations`.", {
  {"survey",                "",       Nested{},                            none,
      "the survey's file, a table (CSV) or a WITSML trajectory, or a block `well.survey`; a relative path starts at the scene "
      "file's folder"},
  {"stations",              "m, deg", Nested{},                            none,
      "list of [measured depth, inclination, azimuth], the first at depth 0 or tied in"},
  {"tie_in",                "",       Nested{},                            none,
      "position of the first station, where that is below depth 0; a smooth hole leads there. Replaces the columns of the CSV "
      "file"},
  {"hole_depth",            "m",      &WellSpec::hole_depth,               between(0.1, 20000.0),
      "measured depth of the hole's bottom; below the last station only with `project`", no_kind, every_kind, "the last station"},
  {"project",               "",       Choice<WellSpec>{projection_words,
      [](WellSpec& w, int i) { w.project = static_cast<Projection>(i); },
      [](const WellSpec& w) { return static_cast<int>(w.project); }}, none,
      "direction of the hole between the last station and hole_depth, at most 30.5 m: straight on, or with the curvature of the "
      "last interval"},
  {"sections",              "",       Nested{},                            none,
      "list of hole sections, top down; the last reaches hole_depth", must},
  {"pilot_depth",           "m",      &WellSpec::pilot_depth,              between(0.0, 20000.0),
      "measured depth to which a narrower pilot hole exists; the bit reams it from hole_depth on; 0: none"},
  {"pilot_diameter",        "m",      &WellSpec::pilot_diameter,           between(0.0, 1.0),
      "diameter of the pilot hole, at most 0.95 of the bit's"},
}};

const Table<SurveyFormat> survey_keys = {"well.survey", "The survey's file and how to read it, where its header does not say. "
    "`--columns MAP.yaml` of `drill survey`, `score` and `plot` takes the same keys except `file`.", {
  {"file",                  "",       Nested{},                            none,                 "the survey's file",
      survey_of_scene, survey_of_scene},
  {"columns",               "",       Nested{},                            none,
      "names and units of the columns"},
  {"delimiter",             "",       &SurveyFormat::delimiter,            none,
      "between cells: `\",\"`, `\";\"`, bar, tab or space. Decimal commas are read where the delimiter is not a comma, grouped "
      "digits where the decimal sign is certain (`1,234.5`, `1.234,5`, `1 234`)", no_kind, every_kind, "by the header"},
  {"quality",               "",       Nested{},                            none,
      "column that marks stations as good or bad, where its cells are no usual words such as bad or rejected"},
  {"pass_over",             "",       Flag<SurveyFormat>{&SurveyFormat::pass_over}, none,
      "true: stations without a value (empty or -999.25) and repeated stations are left out; a vertical station then needs no "
      "azimuth", no_kind, every_kind, "false"},
}};

const Table<SurveyFormat> survey_columns_keys = {"well.survey.columns",
    "Columns of a survey's table, where their names are not the usual ones. Give only what is unclear.", {
  {"md",                    "",       Nested{},                            none,                 "measured depth"},
  {"inclination",           "",       Nested{},                            none,
      "inclination from vertical down"},
  {"azimuth",               "",       Nested{},                            none,                 "azimuth, clockwise from north"},
  {"north",                 "",       Nested{},                            none,
      "north of the rotary table; north, east and tvd are used where the first station is below the table"},
  {"east",                  "",       Nested{},                            none,                 "east of the rotary table"},
  {"tvd",                   "",       Nested{},                            none,                 "true vertical depth"},
}};

const Table<SurveyColumn> survey_column_keys = {"well.survey.columns.*", "A column.", {
  {"column",                "",       &SurveyColumn::column,               none,                 "name in the header", no_kind,
      every_kind, "by the usual names"},
  {"unit",                  "",       &SurveyColumn::unit,                 none,
      "length: such as m, ft or ftUS (US survey foot); angle: such as deg, rad or gon", no_kind, every_kind,
      "as the header says"},
}};

const Table<SurveyQuality> survey_quality_keys = {"well.survey.quality", "Stations whose cell is not one of the good ones are "
    "left out, and reported.", {
  {"column",                "",       &SurveyQuality::column,              none,                 "name in the header", must},
  {"good",                  "",       &SurveyQuality::good,                none,
      "cells of good stations, between blanks", must},
}};

const Table<TieIn> tie_in_keys = {"well.tie_in", "Position of a survey's first station below the rotary table. The hole above "
    "it leaves the table vertically and consists of straight pieces and arcs of at most 15 deg/30 m.", {
  {"north",                 "m",      &TieIn::north,                       between(-20000.0, 20000.0),
      "north of the rotary table"},
  {"east",                  "m",      &TieIn::east,                        between(-20000.0, 20000.0),
      "east of the rotary table"},
  {"tvd",                   "m",      &TieIn::tvd,                         above(0.0, 20000.0),  "true vertical depth", must},
}};

const Table<HoleSection> section_keys = {"well.sections[]", "A section of the hole; it begins where the section above it ends.", {
  {"to",                    "m",      &HoleSection::to,                    between(0.01, 20000.0),
      "measured depth of its lower end", must},
  {"diameter",              "m",      &HoleSection::diameter,              between(0.03, 2.0),   "hole diameter", must},
  {"friction",              "-",      &HoleSection::friction,              between(0.0, 5.0),
      "kinetic friction coefficient of string on wall", must},
  {"static_ratio",          "-",      &HoleSection::static_ratio,          between(1.0, 5.0),    "static over kinetic friction",
      no_kind, every_kind, "of `contact`"},
  {"stribeck_speed",        "m/s",    &HoleSection::stribeck_speed,        between(1e-4, 10.0),
      "slip speed over which friction falls from static to kinetic", no_kind, every_kind, "of `contact`"},
}};

const Table<FormationLayer> layer_keys = {"formation[]",
    "A layer of rock. ROP = drillability (weight - threshold)^weight_exponent bit_speed^speed_exponent.", {
  {"to_tvd",                "m",      &FormationLayer::to_tvd,             above(0.0, 1e6),
      "true vertical depth of its base; the last layer continues below it", must},
  {"drillability",          "m/s; N; rad/s", &FormationLayer::drillability, above(0.0, 1.0),
      "factor K of the rate of penetration", must},
  {"weight_exponent",       "-",      &FormationLayer::weight_exponent,    between(0.5, 3.0),    "exponent of the weight"},
  {"speed_exponent",        "-",      &FormationLayer::speed_exponent,     between(0.0, 2.0),    "exponent of the bit's speed"},
  {"threshold",             "N",      &FormationLayer::threshold,          between(0.0, 1e6),
      "weight below which the rock does not break"},
  {"dip_deg",               "deg",    &FormationLayer::dip,                between(0.0, 90.0),
      "dip of the beds below the horizontal"},
  {"strike_deg",            "deg",    &FormationLayer::strike,             between(-360.0, 360.0),
      "azimuth of the strike; the beds dip to the right of it"},
  {"anisotropy",            "-",      &FormationLayer::anisotropy,         below(0.0, 1.0),
      "0: the rock drills alike in all directions"},
  {"friction",              "-",      &FormationLayer::friction,           between(0.0, 5.0),
      "kinetic friction coefficient of string on wall in new hole of this layer, instead of the section's", no_kind, every_kind,
      "of the section"},
}};

const Table<MudSpec> mud_keys = {"mud", "The drilling fluid around and inside the string.", {
  {"density",               "kg/m3",  &MudSpec::density,                   between(0.0, 3000.0), "density; 0: air, no buoyancy"},
  {"viscosity",             "Pa s",   &MudSpec::viscosity,                 between(0.0, 1.0),
      "dynamic viscosity. It damps the string's waves (see the next keys); 0: no damping. 0.02 Pa s is 20 cP, an assumption; "
      "plastic viscosities of muds are 5 to 60 cP. With `rheology` only for a Newtonian mud; other muds damp by their plastic "
      "viscosity"},
  {"axial_damping",         "N s/m per m", &MudSpec::axial_damping,        between(0.0, 1e4),
      "viscous drag for motion along the string", no_kind, every_kind, "by the viscosity, for a wave of 1 Hz: 6.3 for 5 in pipe"},
  {"lateral_damping",       "N s/m per m", &MudSpec::lateral_damping,      between(0.0, 1e5),
      "viscous drag for motion across the string, the part proportional to speed", no_kind, every_kind,
      "by the viscosity, for a swing of 5 Hz: 43 for 5 in pipe in an 8 1/2 in hole"},
  {"drag_coefficient",      "-",      &MudSpec::drag_coefficient,          between(0.0, 10.0),
      "drag coefficient C_d for motion across the string, the part proportional to the square of the speed"},
  {"torsional_damping",     "N m s/rad per m", &MudSpec::torsional_damping, between(0.0, 100.0),
      "viscous drag for rotation of the string", no_kind, every_kind, "by the viscosity, for a wave of 1 Hz: 0.02 for 5 in pipe"},
  {"bulk_modulus",          "Pa",     &MudSpec::bulk_modulus,              between(1e7, 1e11),
      "bulk modulus of the mud, with the elasticity of pipe and hole in it; pressure follows the pump with the time constant of "
      "volume / bulk_modulus"},
  {"gel_strength",          "Pa",     &MudSpec::gel_strength,              between(0.0, 100.0),
      "shear stress that starts mud which has rested for ten minutes; 1 lb/100 ft2 is 0.479 Pa, muds have 2 to 15 Pa"},
  {"added_mass",            "-",      &MudSpec::added_mass,                between(0.0, 5.0),
      "factor on the mass of the mud that moves sideways with the string, inside it and around it"},
  {"rheology",              "",       Nested{},                            none,
      "flow curve of the mud: pressure losses by section, ECD, surge and swab follow from it instead of "
      "`rig.mud_pump.pressure_coefficient`. Needs `nozzles` or `nozzle_area` of the bit", no_kind, every_kind, "none"},
  {"cuttings",              "",       Nested{},                            none,
      "cuttings that the mud carries: their weight in the annulus, and the bed on the low side of an inclined hole with its "
      "drag on the string; `{}` takes all defaults. Needs `rheology`", no_kind, every_kind, "none, the mud stays clean"},
  {"pressure_waves",        "",       Nested{},                            none,
      "pressure waves in bore and annulus: pump strokes, water hammer, pulses and the delay of the pipe's length in "
      "`stand_pipe_pressure`; `{}` takes all defaults. Needs `rheology`", no_kind, every_kind, "none, two volumes"},
  {"temperature",           "",       Nested{},                            none,
      "temperature of the mud along the hole, which changes its density and its flow curve: losses, ECD and stand-pipe pressure "
      "follow; `{}` takes all defaults. Needs `rheology`", no_kind, every_kind, "none, the mud is alike everywhere"},
  {"fill",                  "m",      Nested{},                            none,
      "mud level in a string that is run in with a float and not filled: distance along the string from the rotary table down. "
      "One number, or by bit depth `[[bit_depth, level], ...]`, linear between rows. A level at the bit or deeper: the string "
      "is empty. The pump fills the string before mud reaches the bit", no_kind, every_kind, "0, full"},
}};

const Table<CuttingsSpec> cuttings_keys = {"mud.cuttings", "Cuttings in the mud; needs `mud.rheology`.", {
  {"density",               "kg/m3",  &CuttingsSpec::density,              between(1000.0, 5000.0),
      "density of the rock, above the mud's"},
  {"size",                  "m",      &CuttingsSpec::size,                 between(1e-4, 0.05),  "diameter of a cutting"},
  {"porosity",              "-",      &CuttingsSpec::porosity,             between(0.2, 0.7),
      "share of mud in a bed of cuttings"},
  {"friction",              "-",      &CuttingsSpec::friction,             between(0.0, 2.0),
      "friction coefficient of a bed on the pipe that it covers, an assumption; 0: a bed has no drag"},
}};

const Table<PressureWavesSpec> pressure_waves_keys = {"mud.pressure_waves",
    "Pressure waves in the mud, at the speed sqrt(bulk_modulus / density); needs `mud.rheology`, not together with `mud.fill`.", {
  {"cylinders",             "",       &PressureWavesSpec::cylinders,       between(0, 12),
      "pistons of the pump, evenly spaced over a stroke; 0: no ripple"},
  {"dampener_volume",       "m3",     &PressureWavesSpec::dampener_volume, between(0.0, 10.0),
      "gas volume of the pulsation dampener at the pump, at its precharge; 0: no dampener. 20 gal by default"},
  {"dampener_pressure",     "Pa",     &PressureWavesSpec::dampener_pressure, between(0.0, 1e8),
      "precharge of the dampener; below this pressure it has no effect"},
  {"pulse_height",          "Pa",     &PressureWavesSpec::pulse_height,    between(0.0, 2e7),
      "pressure that a closed pulser of the MWD adds at the bit at the pump's `max_flow`, in proportion to flow^2; 0: no pulses"},
  {"pulse_period",          "s",      &PressureWavesSpec::pulse_period,    between(0.1, 100.0),
      "period of the pulses; the pulser is closed for the first half of it"},
}};

const Table<MudTemperatureSpec> temperature_keys = {"mud.temperature",
    "Temperature of mud and rock; needs `mud.rheology`. Temperatures in degC.", {
  {"inlet",                 "degC",   &MudTemperatureSpec::inlet,          between(-20.0, 100.0),
      "temperature of the mud that is pumped in, at which `mud.density` holds; an assumption"},
  {"surface",               "degC",   &MudTemperatureSpec::surface,        between(-20.0, 60.0),
      "undisturbed temperature of the ground at its surface (mean of the standard atmosphere at sea level)"},
  {"gradient",              "K/m",    &MudTemperatureSpec::gradient,       between(0.0, 0.2),
      "rise of the ground's temperature by true vertical depth; continents 0.025 to 0.03 K/m; an assumption"},
  {"heat_capacity",         "J/(kg K)", &MudTemperatureSpec::heat_capacity, between(500.0, 5000.0),
      "heat capacity of the mud. By default of water with a tenth of solids by volume; oil-based muds have about 2000"},
  {"pipe_coefficient",      "W/(m2 K)", &MudTemperatureSpec::pipe_coefficient, between(0.0, 1e4),
      "heat transfer between the mud inside and around the string, per area of its outside; 30 Btu/(h ft2 degF) by default "
      "(Holmes and Swift, 1970)"},
  {"wall_coefficient",      "W/(m2 K)", &MudTemperatureSpec::wall_coefficient, between(0.0, 1e4),
      "heat transfer between the annulus and the hole's wall, without the rock behind it; an assumption, as `pipe_coefficient`"},
  {"rock_conductivity",     "W/(m K)", &MudTemperatureSpec::rock_conductivity, above(0.0, 100.0),
      "heat conductivity of the rock; 1.3 Btu/(h ft degF) by default (Holmes and Swift, 1970)"},
  {"rock_diffusivity",      "m2/s",   &MudTemperatureSpec::rock_diffusivity, between(1e-8, 1e-4),
      "thermal diffusivity of the rock, conductivity over heat capacity per volume; by default of 2643 kg/m3 and 837 J/(kg K) "
      "(Holmes and Swift, 1970)"},
  {"expansion",             "1/K",    &MudTemperatureSpec::expansion,      between(0.0, 2e-3),
      "thermal expansion of the mud: its density falls by this share per kelvin. By default of water at 50 degC less a tenth of "
      "solids; oil-based muds have about 7e-4"},
  {"compressibility",       "1/Pa",   &MudTemperatureSpec::compressibility, between(0.0, 2e-9),
      "compressibility of the mud: its density grows by this share per pascal of hydrostatic pressure. By default of water"},
  {"activation",            "K",      &MudTemperatureSpec::activation,     between(0.0, 1e4),
      "B of the factor exp(B (1/T - 1/T_r)) on yield stress and consistency, T in kelvin. By default of water between 20 and 100 "
      "degC, an assumption for muds; 0: the flow curve does not change"},
  {"rheology_temperature",  "degC",   &MudTemperatureSpec::rheology_temperature, between(0.0, 200.0),
      "T_r: temperature at which `mud.rheology` holds; 120 degF by default, at which API RP 13B-1 tests muds"},
  {"circulated",            "s",      &MudTemperatureSpec::circulated,     between(0.0, 1e8),
      "how long mud has been pumped at the pump's `max_flow` before the start; 0: mud and rock have rested"},
}};

const Table<RheologySpec> rheology_keys = {"mud.rheology",
    "Flow curve of the mud: stress = yield stress + consistency rate^index. Give the numbers of the law, or `readings`.", {
  {"law",                   "",       Choice<RheologySpec>{rheology_words,
      [](RheologySpec& r, int word) { r.law = static_cast<RheologyLaw>(word); },
      [](const RheologySpec& r) { return static_cast<int>(r.law); }},
      none, "flow law; newtonian uses `mud.viscosity`", must},
  {"readings",              "rpm, deg", Nested{},                          none,
      "viscometer readings (rotor R1, bob B1, spring F1), rows [speed, dial], such as `[[600, 65], [300, 39]]`: at least 1 for "
      "newtonian, 2 for bingham and power_law, 3 for herschel_bulkley. 600, 300, 6 and 3 rpm of a Herschel-Bulkley mud as in "
      "API RP 13D, others by least squares", no_kind, every_kind, "none"},
  {"plastic_viscosity",     "Pa s",   &RheologySpec::plastic_viscosity,    between(1e-4, 1.0),   "plastic viscosity PV", no_kind,
      bingham, "of the readings"},
  {"yield_point",           "Pa",     &RheologySpec::yield_point,          between(0.0, 200.0),
      "yield point YP; 1 lb/100 ft2 is 0.479 Pa", no_kind, bingham, "of the readings"},
  {"yield_stress",          "Pa",     &RheologySpec::yield_stress,         between(0.0, 200.0),
      "shear stress below which the mud does not flow", no_kind, yields, "of the readings"},
  {"consistency",           "Pa s^n", &RheologySpec::consistency,          between(1e-4, 100.0), "consistency K", no_kind, thins,
      "of the readings"},
  {"index",                 "-",      &RheologySpec::index,                between(0.1, 1.0),
      "flow index n; 1: no shear thinning", no_kind, thins, "of the readings"},
  {"eccentricity",          "-",      &RheologySpec::eccentricity,         between(0.0, 0.95),
      "offset of the string in its hole over the clearance; it lowers the annulus's pressure loss, at 0.95 to half"},
  {"rotation_factor",       "-",      &RheologySpec::rotation_factor,      between(0.6, 3.0),
      "annulus's pressure loss with the top drive at 120 rpm over that without rotation; the change is in proportion to the "
      "speed, up to 240 rpm. From a test of the rig at several speeds"},
}};

// clang-format on

}  // namespace drill_rig_sim
