// SPDX-License-Identifier: BSD-3-Clause
#include "sim_functions.h"

#include <pybind11/stl.h>

#include <array>
#include <map>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "../scene/station_steps.h"
#include "../scene/survey_titles.h"
#include "../scene/text_file.h"
#include "../sim/build_identity.h"
#include "drill_rig_sim/math/latin_letters.h"
#include "drill_rig_sim/math/shown_units.h"
#include "drill_rig_sim/math/unit_table.h"
#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/rig/hoisting.h"
#include "drill_rig_sim/scene/quality_flags.h"
#include "drill_rig_sim/scene/read_scene.h"
#include "drill_rig_sim/scene/survey_file.h"
#include "drill_rig_sim/scene/write_scene.h"
#include "drill_rig_sim/sim/profile.h"
#include "in_process_rig.h"

namespace py = pybind11;

namespace drill_rig_sim
{
namespace
{
/// Of the library, in hexadecimal digits.
std::string build()
{
  constexpr char digits[] = "0123456789abcdef";
  std::string text;
  for (const unsigned char byte : build_identity()) text += {digits[byte / 16], digits[byte % 16]};
  return text;
}

/// The units that numbers may have, by quantity and spelling: SI units in one of each; without those whose zero is another.
py::dict units()
{
  py::dict families;
  for (const UnitFamily& family : unit_families())
  {
    py::dict names;
    for (const UnitName& unit : family.units)
    {
      std::istringstream spellings(unit.name + std::string(" ") + unit.spellings);
      for (std::string spelling; unit.zero == 0.0L && spellings >> spelling;) names[py::str(spelling)] = unit.factor();
    }
    const std::string quantity = family.quantity;
    families[py::str(quantity.substr(quantity.find(' ') + 1))] = names;
  }
  return families;
}

/// SI units in one of a text that is a unit of a quantity, and why it is none: a number and "", or None and the problem.
py::tuple find_unit_of(const std::string& quantity, const std::string& text)
{
  const UnitFamily& family = units_of_quantity(quantity);
  const FoundUnit found = find_unit(family, text);
  if (found.unit) return py::make_tuple(found.unit->factor(), "");
  if (!found.choices.empty()) return py::make_tuple(py::none(), text + " is ambiguous; allowed: " + found.choices);
  return py::make_tuple(py::none(), (text.empty() ? "(none)" : text) + " is not known for " + family.quantity +
                                        "; allowed: " + listed_units(family));
}

/// The sense of a column of quality flags, "" where the name is none, and what else the name says.
py::tuple flag_name_of(const std::string& name)
{
  constexpr std::array<const char*, 5> senses = {"", "status", "quality", "good if true", "bad if true"};
  const FlagName found = flag_name(name);
  return py::make_tuple(senses[static_cast<std::size_t>(found.sense)], found.of);
}

/// What the different cells of a column called `name` say: `good`, `bad`, `derived` or `other`; whether one is good or bad, and
/// whether they differ and which of them are bad cannot be known.
py::tuple flag_cells_of(const std::string& name, const std::vector<std::string>& cells)
{
  constexpr std::array<const char*, 4> words = {"good", "bad", "derived", "other"};
  const FlagCells found = flag_cells(flag_name(name).sense, cells);
  std::vector<std::string> meanings;
  for (const FlagMeaning meaning : found.meanings) meanings.emplace_back(words[static_cast<std::size_t>(meaning)]);
  return py::make_tuple(meanings, found.known, found.unclear);
}

/// step_in_feet() of scene/station_steps.h for a table of depths [m], None where it is none of pipe.
py::object pipe_step_in_feet(const std::vector<double>& depths)
{
  constexpr std::size_t fewest = 3;
  const std::optional<double> step = step_in_feet(depths, fewest, true);
  return step ? py::object(py::float_(*step)) : py::none();
}

/// The line of a text that names another well than one above it, that well and the one above; None where all are of one.
py::object other_well_in(const std::string& text)
{
  const OtherWell other = other_well(text);
  return other.line > 0 ? py::object(py::make_tuple(other.line, other.well, other.above)) : py::none();
}

/// The units that the runner's commands show numbers in with --units oilfield: shown numbers in one SI unit.
py::dict oilfield_units()
{
  py::dict names;
  for (int k = 0; k < static_cast<int>(Dimension::count); ++k)
  {
    const Unit& unit = unit_of(static_cast<Dimension>(k), UnitSystem::oilfield);
    names[unit.name] = unit.per_si;
  }
  return names;
}

/// What the scene's gauge of the hook load shows of a weight on the lines, without its errors [N].
/// @param direction  of the block's last motion, 1 up, -1 down, 0: none, without the friction of rail and sheaves
double shown(const Scene& scene, double weight, int direction)
{
  const SteadyHookLoad gauges = steady_hook_load(scene.rig.hoisting, weight, direction);
  return scene.instruments.hook_load.place == HookLoadPlace::block ? gauges.at_block : gauges.at_dead_line;
}

/// What shown() is of the block alone, as in a simulated connection: the string is in the slips, and the block's rail does not
/// rub [N].
double empty_block(const std::string& scene_file, int direction)
{
  Scene scene = read_scene(scene_file);
  scene.rig.hoisting.rail_friction = 0.0;
  return shown(scene, standard_gravity * scene.rig.hoisting.block_mass, direction);
}

/// As `drill static` names it.
SlidingMotion motion_called(const std::string& name)
{
  const std::map<std::string, SlidingMotion> motions = {
      {"none", no_sliding}, {"up", sliding_up}, {"down", sliding_down}, {"rotate", sliding_around}};
  const auto found = motions.find(name);
  if (found == motions.end()) throw std::runtime_error("motion: '" + name + "' is not known, allowed: none, up, down or rotate");
  return found->second;
}

/// Loads of a scene's string as it hangs at its start, in SI units: static_report() of a motion with that name, or in the mud at
/// a speed, + up, and rotation; with a flow of the pump.
py::dict static_loads(const std::string& scene_file, const std::string& motion, double speed, double rotation, double flow)
{
  const SlidingMotion called = motion_called(motion), given{-speed, rotation};
  if (!given.still() && !called.still())
    throw std::runtime_error("motion: '" + motion + "' is not allowed together with a speed or a rotation");
  StaticReport report;
  Scene scene;
  {
    const py::gil_scoped_release others;
    scene = read_scene(scene_file);
    report = static_report(scene, given.still() ? called : given, {!given.still(), flow});
  }
  py::dict loads;
  loads["hook_load"] = report.hook_load;
  loads["hook_load_gauge"] = report.hook_load_gauge;
  loads["hook_load_gauge_after_up"] = shown(scene, report.hook_load, 1);
  loads["hook_load_gauge_after_down"] = shown(scene, report.hook_load, -1);
  loads["hook_load_string"] = report.hook_load_string;
  loads["torque"] = report.torque;
  loads["wob"] = report.outcome.forces.wob;
  loads["bit_side_force"] = report.bit_side_force;
  loads["annulus_pressure"] = report.annulus_pressure;
  return loads;
}

/// A scene's file as a text that needs no other file, with numbers in SI units alone. Throws SceneError.
std::string plain_scene(const std::string& scene_file)
{
  return write_scene(read_scene(scene_file));
}

/// What the reader of a scene's file has to report, a line each. Throws SceneError.
std::vector<std::string> scene_remarks(const std::string& scene_file)
{
  return read_scene(scene_file).remarks;
}

/// Of a survey's file, as survey_format() says, by the rules of scenes: measured depths [m], inclinations and azimuths [rad], and
/// where the first station lies, (east, north, up) from the rotary table [m], and remarks to be reported. Throws SceneError.
py::tuple read_survey(const std::string& file, const std::string& columns, bool pass_over, bool plan)
{
  const SurveyTable table = read_survey_file(file, survey_format(columns, pass_over, plan));
  std::vector<double> md, inclination, azimuth;
  for (const SurveyStation& station : table.stations)
  {
    md.push_back(station.md);
    inclination.push_back(station.inclination);
    azimuth.push_back(station.azimuth);
  }
  const TieIn start = table.tie_in.value_or(TieIn());
  return py::make_tuple(md, inclination, azimuth, py::make_tuple(start.east, start.north, -start.tvd), table.remarks);
}

/// A text file's content, of at most `longest` bytes, and a remark to be reported, else an empty one, as all text files are read
/// here. Throws SceneError.
py::tuple read_text(const std::string& file, std::size_t longest)
{
  const TextFile read = read_text_file(file, "a text file", longest);
  return py::make_tuple(read.text, read.remark);
}
}  // namespace

void bind_functions(py::module_& module)
{
  module.def("build", build);
  module.def("static_loads", static_loads, py::arg("scene"), py::arg("motion"), py::arg("speed") = 0.0, py::arg("rotation") = 0.0,
             py::arg("flow") = 0.0);
  module.def("empty_block", empty_block);
  module.def("plain_scene", plain_scene);
  module.def("scene_remarks", scene_remarks);
  module.def("units", units);
  module.def("find_unit", find_unit_of);
  module.def("flag_name", flag_name_of);
  module.def("flag_cells", flag_cells_of);
  module.def("latin_letters", latin_letters);
  module.def("pipe_step_in_feet", pipe_step_in_feet);
  module.def("names_well", names_well);
  module.def("other_well", other_well_in);
  module.def("oilfield_units", oilfield_units);
  module.def("read_survey", read_survey);
  module.def("read_text", read_text, py::arg("file"), py::arg("longest") = longest_text);
}
}  // namespace drill_rig_sim
