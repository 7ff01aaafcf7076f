#include <cstdio>
#include <memory>
#include <optional>
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
  std::optional<double> speed, rpm;
  std::string csv;
};

SlidingMotion motion_of(const StaticOptions& options)
{
  const std::string& motion = options.motion;
  if (options.speed || options.rpm)
  {
    if (motion != "none") throw UsageError("--motion: with --speed or --rpm it is given twice, needed: one of them");
    return {-options.speed.value_or(0.0), options.rpm.value_or(0.0) * rpm};
  }
  if (motion == "none") return no_sliding;
  if (motion == "up") return sliding_up;
  if (motion == "down") return sliding_down;
  if (motion == "rotate") return sliding_around;
  throw UsageError("--motion: '" + motion + "' is not known, allowed: none, up, down or rotate");
}

void print_buckled(const BuckledPipe& buckled)
{
  if (buckled.length == 0.0) return;
  std::printf("buckled          %12.0f m of pipe, between %.0f and %.0f m above the bit", buckled.length, buckled.from_bit, buckled.to);
  if (buckled.helical > 0.0) std::printf(", %.0f m of it into a helix", buckled.helical);
  std::printf("\n");
}

void print_pushed(const StaticReport& report)
{
  if (report.hook_load_string >= 0.0) return;
  std::printf("pushed in        the string must be pushed with %.1f kN at the top, its own weight does not carry it down; ", -report.hook_load_string / 1e3);
  const double block = report.hook_load - report.hook_load_string;
  std::printf(report.hook_load < 0.0 ? "block and top drive weigh %.1f kN only\n" : "the weight of block and top drive (%.1f kN) does\n", block / 1e3);
}

void print_static(const StaticOptions& options)
{
  const SlidingMotion motion = motion_of(options);
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
  std::printf("yield            %12.2f of what the pipe bears, %.0f m above the bit\n", report.loads.stress.share, report.loads.stress.from_bit);
  std::printf("buckling         %12.2f of what it bears straight, %.0f m above the bit\n", report.loads.buckling.share, report.loads.buckling.from_bit);
  print_buckled(report.buckled);
  print_pushed(report);
  if (report.refined_length > 0.0) std::printf("mesh             elements of %.3g m where pipe is compressed, shorter than the scene's\n", report.refined_length);
  const std::string doubt = text_of(report.accuracy, scene.numerics.step);
  if (!doubt.empty()) std::printf("accuracy warning: %s\n", doubt.c_str());
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
  add_number(*words, "--speed", options->speed, -20.0, 20.0, "M/S", "moves along the hole instead, + up, and turns at --rpm [m/s]");
  add_number(*words, "--rpm", options->rpm, -1000.0, 1000.0, "N", "turns instead, + clockwise, and moves at --speed; their ratio counts [rpm]");
  add_text(*words, "--csv", options->csv, "FILE", "writes forces along the string");
  add_settings(*words, options->settings);
  return {words, [options] { print_static(*options); }};
}

}  // namespace drill_rig_sim
