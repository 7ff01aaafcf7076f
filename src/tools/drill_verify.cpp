#include <CLI/App.hpp>
#include <cmath>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "drill_command.h"
#include "drill_failure.h"
#include "drill_options.h"
#include "drill_output.h"
#include "drill_progress.h"
#include "drill_rig_sim/accuracy/refined.h"
#include "drill_rig_sim/accuracy/verification.h"
#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/sim/run.h"
#include "drill_run_options.h"
#include "drill_scene.h"
#include "drill_units.h"

namespace drill_rig_sim
{
namespace
{
struct VerifyOptions
{
  RunOptions run;
  std::optional<double> times;
  std::string units = "si";
};

Outputs errors_of(const Simulator& simulator) noexcept
{
  Outputs errors;
  for (std::size_t i = 0; i < output_count; ++i) errors[i] = simulator.measured_error(static_cast<Output>(i));
  return errors;
}

const char* word_of(Verification::Verdict verdict)
{
  constexpr const char* words[] = {"right", "warned", "silent", "unknown"};
  return words[static_cast<std::size_t>(verdict)];
}

struct Shown
{
  Dimension dimension;
  Printed::InSI si;
};
const Shown shown[output_count] = {{Dimension::force, {"%.1f", "kN", 1e-3}},     {Dimension::torque, {"%.2f", "kN m", 1e-3}},
                                   {Dimension::force, {"%.1f", "kN", 1e-3}},     {Dimension::penetration, {"%.2f", "m/h", 3600.0}},
                                   {Dimension::rotation, {"%.1f", "rpm", 1.0 / rpm}}, {Dimension::pressure, {"%.2f", "MPa", 1e-6}}};

void print_findings(const Verification& verification, const Printed& printed)
{
  std::printf("%-20s %14s %14s %12s %9s %10s\n", "output", "mean", "of the finest", "worst 3 s", "at", "known to");
  for (std::size_t i = 0; i < output_count; ++i)
  {
    const Output output = static_cast<Output>(i);
    const Verification::Finding found = verification.finding(output);
    const auto value = [&](double si) { return printed(si, shown[i].dimension, shown[i].si); };
    std::printf("%-20s %14s %14s %10.2f %% %7.0f s %8.2f %%%s\n", traits_of(output).name, value(found.mean).c_str(), value(found.finest_mean).c_str(),
                100.0 * found.worst, found.worst_until, 100.0 * found.own, verification.needed(output) ? "" : "  (not in needs)");
  }
}

/// The first output that is needed and wrong, or not known.
std::size_t first_bad(const Verification& verification)
{
  for (std::size_t i = 0; i < output_count; ++i)
  {
    const Verification::Finding found = verification.finding(static_cast<Output>(i));
    if (verification.needed(static_cast<Output>(i)) && (!std::isnan(found.wrong_from) || !found.known)) return i;
  }
  return 0;
}

void print_verdict(const Verification& verification, double tolerance)
{
  const std::size_t i = first_bad(verification);
  const Verification::Finding found = verification.finding(static_cast<Output>(i));
  switch (verification.verdict())
  {
    case Verification::Verdict::right:
      std::printf("right: over any 3 s no output that is needed is off by more than %g %% of its range\n", 100.0 * tolerance);
      break;
    case Verification::Verdict::warned:
      std::printf("wrong, and warned of: %s is off by more than %g %% from %.0f s on, a warning came at %.0f s\n", output_traits[i].name, 100.0 * tolerance,
                  found.wrong_from, verification.warned_from());
      break;
    case Verification::Verdict::silent:
      std::printf("wrong without a warning: %s is off by more than %g %% from %.0f s on\n", output_traits[i].name, 100.0 * tolerance, found.wrong_from);
      break;
    case Verification::Verdict::unknown:
      std::printf("not known: the finer runs differ too much in %s to tell %g %%; one moment of it is one case of many there, means over minutes may hold\n",
                  output_traits[i].name, 100.0 * tolerance);
      break;
  }
}

/// What is not finite is written as null.
nlohmann::ordered_json json_of(const Simulator& simulator, const Verification& verification, double times)
{
  nlohmann::ordered_json out{{"scene", simulator.scene().name}, {"verdict", word_of(verification.verdict())}, {"tolerance", simulator.scene().numerics.tolerance},
                             {"refined", {times, times * times}}, {"simulated_s", simulator.truth().time}, {"warned_from", verification.warned_from()}};
  for (std::size_t i = 0; i < output_count; ++i)
  {
    const Output output = static_cast<Output>(i);
    const Verification::Finding f = verification.finding(output);
    out["outputs"][traits_of(output).name] = {{"needed", verification.needed(output)}, {"mean", f.mean}, {"finest_mean", f.finest_mean}, {"scale", f.scale}, {"worst", f.worst},
                                              {"worst_until", f.worst_until}, {"known_to", f.own}, {"known", f.known}, {"wrong_from", f.wrong_from}, {"off", f.off}, {"measured", f.measured}};
  }
  return out;
}

/// Throws ComputationError where a finer run has ended.
void require_companions(const Simulator& simulator)
{
  for (int i = 0; i < simulator.companions(); ++i)
    if (const char* why = simulator.companion_failure(i); *why)
      throw ComputationError("a finer run fails: " + std::string(why));
}

/// Plays the scene with two finer models beside it.
RunEnd play(Simulator& simulator, const RunGoal& goal, double times, Verification& verification)
{
  const int finer_one = simulator.add_companion(refined(with_free_nodes(simulator.scene().numerics), times)), finest = simulator.add_companion(refined(with_free_nodes(simulator.scene().numerics), times * times));
  ScenePlayer player(simulator.scene());
  Progress progress;
  const double frame = frame_of_whole_steps(frame_length, simulator.scene().numerics.step);
  return run(simulator, player, goal, frame_length,
             [&](const Truth& m)
             {
               require_companions(simulator);
               verification.add(outputs_of(m), outputs_of(simulator.companion_truth(finer_one)), outputs_of(simulator.companion_truth(finest)), m.accuracy_warning, errors_of(simulator), m.time, frame);
               progress.show(m.time / goal.duration, m.time, m.hole_depth);
             });
}

void verify(const VerifyOptions& options)
{
  const Scene scene = open_scene(options.run.scene, settings_of(options.run));
  const RunGoal goal = goal_of(options.run, scene);
  const double times = options.times.value_or(2.0);
  File json = open_output("--json", options.run.json);
  Simulator simulator = build_simulator(scene, options.run.seed);
  const double tolerance = simulator.scene().numerics.tolerance;
  Verification verification(tolerance, simulator.scene().needs);
  const RunEnd end = play(simulator, goal, times, verification);
  if (end == RunEnd::failure) throw ComputationError(scene.file + ": after " + std::to_string(simulator.truth().time) + " s: " + simulator.failure());
  if (json) std::fputs((json_of(simulator, verification, times).dump(2) + "\n").c_str(), json.get());
  close_output(std::move(json), options.run.json);
  std::printf("%s: %.1f s beside free nodes with elements and steps %g and %g times as short\n", scene.name.c_str(), simulator.truth().time, times, times * times);
  print_findings(verification, Printed(options.units));
  print_verdict(verification, tolerance);
  if (verification.verdict() == Verification::Verdict::silent) throw ToleranceExceeded();
}
}  // namespace

Command add_verify_command(CLI::App& drill)
{
  CLI::App* words = drill.add_subcommand("verify", "plays a scene beside two finer models of it and says how wrong it is; exit status 1: wrong without a warning");
  const auto options = std::make_shared<VerifyOptions>();
  add_goal_options(*words, options->run);
  add_settings(*words, options->run.settings);
  add_number(*words, "--times", options->times, 1.2, 8.0, "N", "how much shorter elements and steps of the finer model are, of the finest its square; default 2");
  add_text(*words, "--json", options->run.json, "FILE", "writes the findings");
  add_units(*words, options->units);
  return {words, [options] { verify(*options); }};
}

}  // namespace drill_rig_sim
