#include <cstdio>
#include <utility>

#include "drill_command.h"
#include "drill_output.h"
#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/scene/read_scene.h"
#include "drill_rig_sim/sim/profile.h"

namespace drill_rig_sim
{
namespace
{
FrictionMode motion_of(const Arguments& arguments)
{
  const std::string motion = arguments.text("--motion", "none");
  if (motion == "none") return FrictionMode::none;
  if (motion == "up") return FrictionMode::up;
  if (motion == "down") return FrictionMode::down;
  if (motion == "rotate") return FrictionMode::rotate;
  throw UsageError("--motion: '" + motion + "' is not known, allowed: none, up, down or rotate");
}

void print_static(const Arguments& arguments)
{
  const FrictionMode motion = motion_of(arguments);
  const Scene scene = read_scene(arguments.file, arguments.all("--set"));
  File csv = arguments.has("--csv") ? open_output("--csv", arguments.text("--csv")) : File();
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
  std::printf("bit side force   %12.1f N, at %.1f deg clockwise from the high side\n", report.bit_side_force,
              report.bit_side_direction / degree);
  std::printf("bit tilt         %12.3f deg to the hole\n", report.bit_tilt / degree);
  if (csv)
  {
    write_profile(csv.get(), report.profile);
    close_output(std::move(csv), arguments.text("--csv"));
  }
}
}  // namespace

const Command static_command = {"static",
                                "SCENE",
                                "static equilibrium at the scene's start, or quasi-static with full slip",
                                {{"--motion", "M", "none (frictionless, the default), up, down or rotate"},
                                 {"--csv", "FILE", "writes forces along the string"},
                                 {"--set", "KEY=VALUE", "any key of the scene; may be repeated"}},
                                print_static};

}  // namespace drill_rig_sim
