// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "drill_rig_sim/crew/program.h"
#include "drill_rig_sim/hydraulics/mud_circuit.h"
#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/rig/drive_tuning.h"
#include "drill_rig_sim/scene/scene_mesh.h"
#include "drill_rig_sim/sim/accuracy_watch.h"
#include "drill_rig_sim/sim/assembly_fit.h"
#include "drill_rig_sim/sim/simulator.h"
#include "drill_rig_sim/sim/wall_loss.h"
#include "drill_rig_sim/solve/start.h"
#include "drill_command.h"
#include "drill_feed.h"
#include "drill_losses.h"
#include "drill_margins.h"
#include "drill_options.h"
#include "drill_program.h"
#include "drill_scene.h"
#include "drill_temperature.h"
#include "drill_units.h"

namespace drill_rig_sim
{
namespace
{
const char* word(PartType type)
{
  switch (type)
  {
    case PartType::bit:
      return "bit";
    case PartType::mud_motor:
      return "mud motor";
    case PartType::collar:
      return "collar";
    case PartType::stabilizer:
      return "stabilizer";
    case PartType::mwd:
      return "mwd";
    case PartType::pipe:
      return "pipe";
    case PartType::rotary_steerable:
      return "rotary steerable";
  }
  return "";
}

// how numbers are written in SI
constexpr Printed::InSI depth{"%g", "m"}, tenth_kilonewton{"%.1f", "kN", 1e-3}, tenth_kilonewton_metre{"%.1f", "kN m", 1e-3};

void print_string(const Scene& scene, const Printed& printed)
{
  constexpr Printed::InSI length{"%.2f", "m"}, kilograms{"%.0f", "kg"};
  const auto metres = [&](double si) { return printed.number(si, Dimension::length, length); };
  const auto mass_of = [&](double si) { return printed.number(si, Dimension::mass, kilograms); };
  const std::string from = std::string("from bit ") + printed.unit(Dimension::length, length),
                    to = std::string("to ") + printed.unit(Dimension::length, length);
  const Mesh mesh = build_mesh(scene, scene.start.bit_depth + scene.start.block_height);
  std::printf("\n%-16s %-10s %10s %10s %12s\n", "part", "type", from.c_str(), to.c_str(),
              (std::string("mass ") + printed.unit(Dimension::mass, kilograms)).c_str());
  double total = 0.0;
  for (std::size_t i = 0; i < scene.string.size(); ++i)
  {
    const PartSpec& part = scene.string[i];
    const double length = mesh.part_top[i] - mesh.part_bottom[i];
    const double mass = part.bit ? part.bit->mass : part.linear_mass * length;
    total += mass;
    std::printf("%-16s %-10s %*s %10s %12s\n", part.name.c_str(), word(part.type), static_cast<int>(from.size()),
                metres(mesh.part_bottom[i]).c_str(), metres(mesh.part_top[i]).c_str(), mass_of(mass).c_str());
  }
  std::printf("%-16s %-10s %*s %10s %12s\n\n", "string", "", static_cast<int>(from.size()), "", metres(mesh.total_length).c_str(),
              mass_of(total).c_str());
}

void print_mud(const Scene& scene, const Mesh& mesh, const Printed& printed)
{
  const MudCircuit mud = mud_circuit(scene, mesh);
  const auto volume = [&](const HydraulicVolume& of) {
    return printed(of.capacity * scene.mud.bulk_modulus, Dimension::volume, {"%.1f", "m3"});
  };
  std::printf("mud         %s, %s in the string, %s in the annulus\n",
              printed(scene.mud.density, Dimension::density, {"%g", "kg/m3"}).c_str(), volume(mud.circuit.bore).c_str(),
              volume(mud.circuit.annulus).c_str());
  print_losses(scene, mesh, mud, printed);
  const std::string doubt = doubt_of_pressures(mud);
  if (!doubt.empty()) std::printf("            %s\n", doubt.c_str());
}

/// Of a string that is not full.
void print_fill(const Scene& scene, const Mesh& mesh, const Printed& printed)
{
  const double level = std::min(fill_level(scene.mud, scene.start.bit_depth), scene.start.bit_depth);
  if (level <= 0.0) return;
  double air = 0.0;  // [m3]
  for (std::size_t e = 0; e < mesh.elements.size(); ++e)
  {
    const double lower = scene.start.bit_depth - mesh.nodes[e].from_bit,
                 upper = scene.start.bit_depth - mesh.nodes[e + 1].from_bit;
    air += mesh.elements[e].holds * std::max(0.0, std::min(lower, level) - std::max(upper, 0.0));
  }
  std::printf("fill        the string is empty down to %s (mud.fill), %s of air\n",
              printed(level, Dimension::length, depth).c_str(), printed(air, Dimension::volume, {"%.2f", "m3"}).c_str());
}

/// What the drive's modes are tuned to, and by it.
void print_tuned_drive(const Scene& scene, const Mesh& mesh, const Printed& printed)
{
  const auto stiffness = [&](double si) { return printed(si, Dimension::torsional_stiffness, {"%.3g", "N m/rad"}); };
  const auto damping = [&](double si) { return printed(si, Dimension::torsional_damping, {"%.3g", "N m s/rad"}); };
  const TopDriveSpec drive = tuned(scene.rig.top_drive, mesh);
  const DriveImpedance &soft = drive.soft_torque, &z = drive.z_torque;
  std::printf(
      "top drive   torsional impedance of the pipe %s, lowest torsional frequency %.3f Hz: SOFT_TORQUE P %s, I %s; Z_TORQUE P "
      "%s, I %s\n",
      printed(torsional_impedance(mesh), Dimension::torsional_damping, {"%.0f", "N m s/rad"}).c_str(),
      slowest_torsion(mesh) / (2.0 * pi), damping(soft.damping).c_str(), stiffness(soft.stiffness).c_str(),
      damping(z.damping).c_str(), stiffness(z.stiffness).c_str());
}

void print_heave(const HeaveSpec& heave, const Printed& printed)
{
  if (heave.amplitude == 0.0) return;
  std::printf("heave       %s about the mean in %.3g s, up to %.2f m/s2\n",
              printed(heave.amplitude, Dimension::length, {"%.3g", "m"}).c_str(), heave.period, heave_acceleration(heave));
}

void print_sharpest_bend(const Survey& survey, const Printed& printed)
{
  int sharpest = 0;
  for (int i = 1; i + 1 < survey.size(); ++i)
    if (survey.dogleg_severity(i) > survey.dogleg_severity(sharpest)) sharpest = i;
  constexpr double per_metre = 1.0 / 30.0;
  const double severity = survey.dogleg_severity(sharpest);  // [rad/30 m]
  if (severity > 0.0)
    std::printf("dogleg      at most %s, from %s to %s\n",
                printed(severity * per_metre, Dimension::dogleg, {"%.3g", "deg/30 m", 30.0 / degree}).c_str(),
                printed.number(survey.station(sharpest).md, Dimension::length, depth).c_str(),
                printed(survey.station(sharpest + 1).md, Dimension::length, depth).c_str());
}

/// What the rock makes of the friction of hole yet to be drilled, from the hole's bottom down.
void print_new_hole(const Scene& scene, double bottom_tvd, const Printed& printed)
{
  const std::vector<FormationLayer>& rock = scene.formation;
  const bool has_friction =
      std::any_of(rock.begin(), rock.end(), [](const FormationLayer& layer) { return !std::isnan(layer.friction); });
  if (!has_friction) return;
  std::printf("new hole    friction");
  for (std::size_t i = 0; i < rock.size(); ++i)
  {
    const bool last = i + 1 == rock.size();
    if (!last && rock[i].to_tvd <= bottom_tvd) continue;
    if (std::isnan(rock[i].friction))
      std::printf(" that of its section");
    else
      std::printf(" %g", rock[i].friction);
    if (!last) std::printf(" to %s TVD,", printed(rock[i].to_tvd, Dimension::length, depth).c_str());
  }
  std::printf("\n");
}

/// Pads that a bent motor wedges into a hole as narrow as the bit: it turns no more, and steps may fail. False where they are
/// not.
bool print_wedged_gauge(const Scene& scene, const RigAtRest& rig, const Printed& printed)
{
  constexpr double much = 0.25;  // of the motor's stall torque
  const MotorSpec* motor = rig.model->motor();
  const Mesh& mesh = rig.model->mesh();
  if (!motor || mesh.gauge_nodes < 2) return false;
  const double kinetic = scene.well.sections[section_at(scene.well.sections, scene.start.bit_depth)].friction;
  double force = 0.0, friction = 0.0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(mesh.gauge_nodes); ++i)
  {
    force += rig.statics.forces.contact[i];
    friction += kinetic * mesh.nodes[i].contact_radius * rig.statics.forces.contact[i];
  }
  if (friction < much * motor->stall_torque) return false;
  std::printf(
      "gauge       the gauge pads are wedged in the hole with %s: their friction takes %s of the motor's stall torque, %s; use a "
      "larger gauge_clearance\n",
      printed(force, Dimension::force, tenth_kilonewton).c_str(),
      printed(friction, Dimension::torque, tenth_kilonewton_metre).c_str(),
      printed.number(motor->stall_torque, Dimension::torque, tenth_kilonewton_metre).c_str());
  return true;
}

/// What a wall that is softer than rock takes from the side forces. False where that is little.
bool print_wall_loss(const Scene& scene, const RigAtRest& rig, const Printed& printed)
{
  const std::optional<WallLoss> loss = wall_loss(rig);
  if (!loss) return false;
  std::printf("wall        %s is %s deep in the wall %s above the bit: side forces are too small; ",
              scene.string[static_cast<std::size_t>(loss->part)].name.c_str(),
              printed(loss->depth, Dimension::diameter, {"%.2g", "mm", 1e3}).c_str(),
              printed(loss->from_bit, Dimension::length, {"%.3g", "m"}).c_str());
  const auto instead_of = [&](double right, double now)
  {
    return printed(right, Dimension::force, tenth_kilonewton) + " instead of " +
           printed.number(now, Dimension::force, tenth_kilonewton);
  };
  if (loss->known)
    std::printf(
        "use contact: {stiffness: %g} in all parts but bit and pipe, then the bit's side force is %s, the sum of all wall "
        "forces %s\n",
        scene.contact.assembly_stiffness, instead_of(loss->stiff_side_force, loss->side_force).c_str(),
        instead_of(loss->stiff_contact, loss->contact).c_str());
  else
    std::printf(
        "by how much is not known, because contact: {stiffness: %g} in all parts but bit and pipe has no equilibrium; use a "
        "thinner body or a smaller bend\n",
        scene.contact.assembly_stiffness);
  return true;
}

/// What the run leaves out or gets too small, and would not be seen by its numbers; then the pages of the manual (src/manual) on
/// it.
void print_shortcomings(const Scene& scene, const Printed& printed)
{
  std::vector<std::string> pages;
  const auto see = [&pages](const char* page)
  {
    if (std::find(pages.begin(), pages.end(), page) == pages.end()) pages.emplace_back(page);
  };
  const BitLawTraits law = traits_of(scene.string.front().bit->torque.model);
  if (law.by_cut)
  {
    std::printf("bit         %s: weight and torque are those of the cut; the face does not rub across the bottom\n", law.word);
    see("theory/bit.md");
  }
  const RigAtRest rig = build_at_rest(scene);
  for (const AccuracyReport& doubt :
       {doubt_of_string(*rig.model, rig.state, rig.statics.forces), doubt_of_hole(rig.state), doubt_of_level(scene, rig.state)})
  {
    if (doubt.doubt == AccuracyDoubt::none) continue;
    std::printf("accuracy    %s\n", text_of(doubt).c_str());
    see("how_to/accuracy_warning.md");
  }
  if (const std::optional<TightAssembly> tight = tight_assembly(*rig.model, rig.statics.forces))
  {
    std::printf("assembly    %s\n", text_of(*tight).c_str());
    see("theory/steering.md");
  }
  if (scene.string.front().bit->gauge_length > 0.0 && print_wedged_gauge(scene, rig, printed)) see("theory/bit.md");
  if (print_wall_loss(scene, rig, printed)) see("theory/wall.md");
  print_margins(rig, printed);
  for (const std::string& page : pages) std::printf("manual      src/manual/%s\n", page.c_str());
}

/// What level auto has chosen, as keys that could be given instead.
void print_choice(const Simulator& simulator)
{
  const NumericsSpec& chosen = simulator.scene().numerics;
  std::printf("choice      level: auto chose %s: %s\n", simulator.statistics().level, simulator.choice().c_str());
  std::printf("            the same by hand: numerics: {level: %s, step: %g", simulator.statistics().level, chosen.step);
  if (chosen.pushed_element_length > 0.0) std::printf(", pushed_element_length: %g", chosen.pushed_element_length);
  if (chosen.guided_element_length > 0.0) std::printf(", guided_element_length: %g", chosen.guided_element_length);
  std::printf("}\n");
}

/// Which key decides how long the elements are.
void print_mesh(const Scene& scene, const Printed& printed)
{
  const NumericsSpec& numerics = scene.numerics;
  const ElementLengths lengths = element_lengths(scene);
  const auto length = [&](double si) { return printed(si, Dimension::length, {"%g", "m"}); };
  const auto place = [&](double si) { return printed(si, Dimension::length, {"%.0f", "m"}); };
  std::ostringstream text;
  if (numerics.element_length > 0.0)
    text << "elements of " << length(numerics.element_length) << " by numerics.element_length, whatever the tolerance";
  else if (lengths.change > 0.0)
    text << "elements of " << length(lengths.lower) << " up to " << place(lengths.change)
         << " above the bit by numerics.tolerance (" << numerics.tolerance << "), of " << length(lengths.upper) << " above that";
  else
    text << "elements of " << length(lengths.upper);
  if (lengths.by_bit < lengths.at(lengths.by_bit_change))
    text << "; of " << length(lengths.by_bit) << " within " << length(lengths.by_bit_change) << " of the bit"
         << (lengths.by_bit == lengths.lower ? " by numerics.tolerance" : "");
  if (lengths.pushed_change > 0.0)
    text << "; of at most " << length(lengths.pushed) << " up to " << place(lengths.pushed_change)
         << ", where friction pushes pipe";
  if (lengths.guided > 0.0)
    text << "; guided pipe of " << length(lengths.guided) << " from " << place(lengths.guided_change) << " on";
  std::printf("mesh        %s\n", text.str().c_str());
}

struct CheckOptions
{
  std::string scene;
  std::vector<std::string> settings;
  std::string units = "si";
};

void print_well(const Scene& scene, const Simulator& simulator, const Printed& printed)
{
  const Truth& m = simulator.truth();
  std::printf("well        %zu stations to %s, hole %s deep, at its bottom %.2f deg inclination, %.2f deg azimuth\n",
              scene.well.survey.size(), printed(scene.well.survey.back().md, Dimension::length, depth).c_str(),
              printed(scene.well.hole_depth, Dimension::length, depth).c_str(), m.bit_inclination / degree,
              m.bit_azimuth / degree);
  print_sharpest_bend(Survey(scene.well.survey), printed);
  print_new_hole(scene, -simulator.wellbore().bottom_position().z(), printed);
  print_string(scene, printed);
  std::printf("start       bit at %s, block at %s, hook load %s, of which the string %s\n",
              printed(m.bit_depth, Dimension::length, {"%.3f", "m"}).c_str(),
              printed(m.block_height, Dimension::length, {"%.2f", "m"}).c_str(),
              printed(m.hook_load, Dimension::force, tenth_kilonewton).c_str(),
              printed(m.hook_load_string, Dimension::force, tenth_kilonewton).c_str());
}

void check(const CheckOptions& options)
{
  const Scene scene = open_scene(options.scene, options.settings);
  require_program(scene, program_end(scene.program));
  const Simulator simulator = build_simulator(scene, 0);
  const Printed printed(options.units);
  const SimulatorStatistics& s = simulator.statistics();
  std::printf("%s: %s: OK\n", options.scene.c_str(), scene.name.c_str());
  print_well(scene, simulator, printed);
  const Mesh mesh = build_mesh(scene, scene.start.bit_depth + scene.start.block_height);
  print_mud(scene, mesh, printed);
  print_temperature(simulator, printed);
  print_fill(scene, mesh, printed);
  print_tuned_drive(scene, mesh, printed);
  print_heave(scene.rig.heave, printed);
  std::printf(
      s.step > 0.0
          ? "model       level %s, integrator %s, step %g s, %d nodes, %d coordinates, kernel %s\n"
          : "model       level %s, integrator %s, variable steps by a tolerance of %g, %d nodes, %d coordinates, kernel %s\n",
      s.level, s.integrator, s.step > 0.0 ? s.step : scene.numerics.tolerance, s.nodes, s.coordinates, name_of(s.kernel));
  if (!simulator.choice().empty()) print_choice(simulator);
  print_mesh(simulator.scene(), printed);
  const bool has_tool =
      std::any_of(scene.string.begin(), scene.string.end(), [](const PartSpec& p) { return p.type == PartType::mwd; });
  if (!has_tool) std::printf("survey tool no part is of type mwd: survey and toolface are measured at the bit's face\n");
  print_shortcomings(simulator.scene(), printed);
  std::printf("program     %zu lines to %g s", scene.program.size(), program_end(scene.program));
  if (!scene.operations.empty()) std::printf(", %zu operations", scene.operations.size());
  std::printf("\n");
  for (const SlowFeed& slow : slow_feeds(scene, -simulator.wellbore().bottom_position().z()))
    std::printf("%s\n",
                feed_limit_text(slow.operation, scene.operations[slow.operation], "limits", slow.weight, 0.0, printed).c_str());
}
}  // namespace

Command add_check_command(CLI::App& drill)
{
  CLI::App* words = drill.add_subcommand("check", "checks a scene and prints the rig, string, well and model that it describes");
  const auto options = std::make_shared<CheckOptions>();
  add_file(*words, "SCENE", options->scene, "the scene's file");
  add_settings(*words, options->settings);
  add_units(*words, options->units);
  return {words, [options] { check(*options); }};
}

}  // namespace drill_rig_sim
