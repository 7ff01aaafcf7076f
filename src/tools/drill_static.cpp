// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <memory>
#include <optional>
#include <utility>

#include "drill_command.h"
#include "drill_options.h"
#include "drill_output.h"
#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/sim/profile.h"
#include "drill_scene.h"
#include "drill_units.h"

namespace drill_rig_sim
{
namespace
{
struct StaticOptions
{
  std::string scene;
  std::vector<std::string> settings;
  std::string motion = "none";
  std::optional<double> speed, rpm, flow;
  std::string csv, units = "si";
};

void print_buckled(const BuckledPipe& buckled, const Printed& printed)
{
  if (buckled.length == 0.0) return;
  const auto metres = [&](double length) { return printed(length, Dimension::length, {"%.0f", "m"}); };
  std::printf("buckled          %s of pipe, between %s and %s above the bit", metres(buckled.length).c_str(),
              metres(buckled.from_bit).c_str(), metres(buckled.to).c_str());
  if (buckled.helical > 0.0) std::printf(", %s of it into a helix", metres(buckled.helical).c_str());
  std::printf("\n");
}

void print_pushed(const StaticReport& report, const Printed& printed)
{
  if (report.hook_load_string >= 0.0) return;
  const auto force = [&](double load) { return printed(load, Dimension::force, {"%.1f", "kN", 1e-3}); };
  std::printf("pushed in        the string must be pushed with %s at the top: its own weight is not enough; ",
              force(-report.hook_load_string).c_str());
  const std::string block = force(report.hook_load - report.hook_load_string);
  std::printf(
      report.hook_load < 0.0 ? "block and top drive weigh only %s\n" : "the weight of block and top drive, %s, is enough\n",
      block.c_str());
}

void print_report(const StaticReport& report, bool is_rule_of_thumb, const Printed& printed)
{
  const Printed::InSI newton{"%.1f", "N"}, newton_metre{"%.1f", "N m"}, metre{"%.0f", "m"};
  const auto force = [&](const char* name, double si, const char* end)
  {
    std::printf("%-16s %12s %s%s", name, printed.number(si, Dimension::force, newton).c_str(),
                printed.unit(Dimension::force, newton), end);
  };
  force("hook load", report.hook_load, "\n");
  force("of the string", report.hook_load_string, "\n");
  force("gauge at block", report.gauges.at_block, ", with the friction of the block's rail\n");
  force("at the dead line", report.gauges.at_dead_line, ", with that of the sheaves\n");
  std::printf("torque           %12s %s\n", printed.number(report.torque, Dimension::torque, newton_metre).c_str(),
              printed.unit(Dimension::torque, newton_metre));
  force("weight on bit", report.outcome.forces.wob, "\n");
  force("bit side force", report.bit_side_force, ", ");
  std::printf("at %.1f deg clockwise from the high side\n", report.bit_side_direction / degree);
  std::printf("bit tilt         %12.3f deg to the hole\n", report.bit_tilt / degree);
  const auto share = [&](const char* name, const char* what, const auto& load)
  {
    std::printf("%-16s %12.2f of %s, %s above the bit\n", name, load.share, what,
                printed(load.from_bit, Dimension::length, metre).c_str());
  };
  share("yield", "its yield strength", report.loads.stress);
  share("buckling", "its critical buckling load", report.loads.buckling);
  if (report.annulus_pressure != 0.0)
    std::printf("annulus          %12s at the bit, by the moving mud%s\n",
                printed(report.annulus_pressure, Dimension::pressure, {"%.3f", "MPa", 1e-6}).c_str(),
                is_rule_of_thumb ? ": a rule of thumb, whatever the viscosity; set mud.rheology" : "");
  print_buckled(report.buckled, printed);
  print_pushed(report, printed);
  if (report.refined_length > 0.0)
    std::printf("mesh             elements of %s where pipe is compressed, shorter than the scene's\n",
                printed(report.refined_length, Dimension::length, {"%.3g", "m"}).c_str());
}

SlidingMotion motion_of(const StaticOptions& options)
{
  const std::string& motion = options.motion;
  if (options.speed || options.rpm)
  {
    if (motion != "none") throw UsageError("--motion: not allowed together with --speed or --rpm");
    return {-options.speed.value_or(0.0), options.rpm.value_or(0.0) * rpm};
  }
  if (motion == "none") return no_sliding;
  if (motion == "up") return sliding_up;
  if (motion == "down") return sliding_down;
  if (motion == "rotate") return sliding_around;
  throw UsageError("--motion: '" + motion + "' is not known, allowed: none, up, down or rotate");
}

void print_static(const StaticOptions& options)
{
  const SlidingMotion motion = motion_of(options);
  const Scene scene = open_scene(options.scene, options.settings);
  if (is_same_file(options.csv, options.scene))
    throw UsageError("--csv: " + options.csv + " is the scene file, needed: another file");
  File csv = open_output("--csv", options.csv);
  StaticReport report;
  try
  {
    report = static_report(scene, motion, {options.speed || options.rpm, options.flow.value_or(0.0)});
  }
  catch (const std::exception& e)
  {
    throw ComputationError(scene.file + ": " + e.what());
  }
  print_report(report, !scene.rheology, Printed(options.units));
  const std::string doubt = text_of(report.accuracy);
  if (!doubt.empty()) std::printf("accuracy warning: %s\n", doubt.c_str());
  if (report.tight) std::printf("assembly warning: %s\n", text_of(*report.tight).c_str());
  if (csv)
  {
    write_profile(csv.get(), report.profile);
    close_output(std::move(csv), options.csv);
  }
}
}  // namespace

Command add_static_command(CLI::App& drill)
{
  CLI::App* words = drill.add_subcommand("static", "static equilibrium at the scene's start, or quasi-static with full slip");
  const auto options = std::make_shared<StaticOptions>();
  add_file(*words, "SCENE", options->scene, "the scene's file");
  add_text(*words, "--motion", options->motion, "M", "none (frictionless, the default), up, down or rotate");
  add_number(*words, "--speed", options->speed, -20.0, 20.0, "M/S",
             "moves along the hole instead, + up, and turns at --rpm, with the drag of the mud [m/s]");
  add_number(*words, "--rpm", options->rpm, -1000.0, 1000.0, "N",
             "turns instead, + clockwise, and moves at --speed, with the drag of the mud [rpm]");
  add_number(*words, "--flow", options->flow, 0.0, 1.0, "M3/S", "flow of the pump [m3/s]");
  add_text(*words, "--csv", options->csv, "FILE", "writes forces along the string, in SI units");
  add_units(*words, options->units);
  add_settings(*words, options->settings);
  return {words, [options] { print_static(*options); }};
}

}  // namespace drill_rig_sim
