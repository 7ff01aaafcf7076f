// SPDX-License-Identifier: BSD-3-Clause
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

#include "../fmi/fmu_rig.h"
#include "../fmi/model_description.h"
#include "drill_command.h"
#include "drill_options.h"
#include "drill_python.h"
#include "drill_rig_sim/sim/requests.h"
#include "drill_scene.h"
#include "drill_temporary_folder.h"

namespace drill_rig_sim
{
namespace
{
namespace fs = std::filesystem;

struct FmuOptions
{
  std::string scene, out;
  std::vector<std::string> settings;
  std::optional<double> rate;
};

void write(const fs::path& file, const std::string& text)
{
  std::ofstream out(file);
  out << text;
  out.close();
  if (!out) throw ComputationError(file.string() + " could not be written whole; is the disk full?");
}

/// The libraries that an FMU holds: both lie in the folder above the runner's, in the devel space and in an install space.
void copy_libraries(const fs::path& folder)
{
  const fs::path libraries = (runner_folder() / "..").lexically_normal();
  for (const std::string name : {DRILL_RIG_SIM_SONAME, "libdrill_rig_sim_fmu.so"})
  {
    std::error_code missing;
    const fs::path to = folder / (name == DRILL_RIG_SIM_SONAME ? name : std::string(fmi::model_identifier) + ".so");
    fs::copy_file(libraries / name, to, missing);
    if (missing)
      throw UsageError((libraries / name).string() + " cannot be copied: " + missing.message() +
                       "; build or install the package whole");
  }
}

void write_fmu(const FmuOptions& options)
{
  const Scene scene = open_scene(options.scene, options.settings);
  const TemporaryFolder folder("--out");
  const fs::path top(folder.path());
  fs::create_directories(top / "resources");
  fs::create_directories(top / "binaries/linux64");
  const double rate = options.rate.value_or(fmi::Inputs().rate);
  try
  {
    check_rate(rate, scene);
  }
  catch (const std::runtime_error& error)
  {
    throw UsageError(std::string("--") + error.what());
  }
  const std::string resources = (top / "resources").string();
  fmi::write_resources(resources, scene, rate);
  write(top / "modelDescription.xml",
        fmi::model_description("drill_rig_sim." + fs::path(options.scene).stem().string(), fmi::FmuRig(resources).inputs()));
  copy_libraries(top / "binaries/linux64");
  if (run_python("fmu_archive", {folder.path(), options.out}) != 0)
    throw UsageError("--out: " + options.out + " cannot be written");
}
}  // namespace

Command add_fmu_command(CLI::App& drill)
{
  CLI::App* words =
      drill.add_subcommand("fmu", "writes the rig of a scene as an FMU (FMI 2.0, co-simulation) for other simulation programs");
  const auto options = std::make_shared<FmuOptions>();
  add_file(*words, "SCENE", options->scene, "the scene's file");
  add_text(*words, "--out", options->out, "FILE", "the FMU to be written, FILE.fmu")->required();
  add_number(*words, "--rate", options->rate, 0.1, 1e4, "R",
             "frames a second; a communication step is a whole number of frames (100) [1/s]");
  add_settings(*words, options->settings);
  return {words, [options] { write_fmu(*options); }};
}

}  // namespace drill_rig_sim
