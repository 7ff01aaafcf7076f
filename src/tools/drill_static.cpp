#include <cstdio>
#include <memory>
#include <utility>

#include "drill_command.h"
#include "drill_options.h"
#include "drill_output.h"
#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/scene/read_scene.h"
#include "drill_rig_sim/sim/profile.h"

namespace drill_rig_sim
{
namespace
{
struct StaticOptions
{
  std::string scene;
  std::vector<std::string> settings;
  std::string motion = "none";
  std::string csv;
};

FrictionMode motion_of(const std::string& motion)
{
  if (motion == "none") return FrictionMode::none;
  if (motion == "up") return FrictionMode::up;
  if (motion == "down") return FrictionMode::down;
  if (motion == "rotate") return FrictionMode::rotate;
  throw UsageError("--motion: '" + motion + "' is not known, allowed: none, up, down or rotate");
}

void print_static(const StaticOptions& options)
{
  const FrictionMode motion = motion_of(options.motion);
  const Scene scene = read_scene(options.scene, options.settings);
  if (is_same_file(options.csv, options.scene)) throw UsageError("--csv: " + options.csv + " is the scene, needed: a file of its own");
  File csv = open_output("--csv", options.csv);
  StaticReport report;
  try
  {
    report = static_report(scene, motion);
  }
  catch (const std::exception& e)
  {
    throw ComputationError(scene.file + ": " + e.what());
  }
  std::printf("hook load        %12.1f N\n", report.hook_load);
  std::printf("of the string    %12.1f N\n", report.hook_load_string);
  std::printf("torque           %12.1f N m\n", report.torque);
  std::printf("weight on bit    %12.1f N\n", report.outcome.forces.wob);
  std::printf("bit side force   %12.1f N, at %.1f deg clockwise from the high side\n", report.bit_side_force,
              report.bit_side_direction / degree);
  std::printf("bit tilt         %12.3f deg to the hole\n", report.bit_tilt / degree);
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
  add_text(*words, "--csv", options->csv, "FILE", "writes forces along the string");
  add_settings(*words, options->settings);
  return {words, [options] { print_static(*options); }};
}

}  // namespace drill_rig_sim
