#include <time.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>

#include "drill_averages.h"
#include "drill_command.h"
#include "drill_json.h"
#include "drill_output.h"
#include "drill_progress.h"
#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/scene/read_scene.h"
#include "drill_rig_sim/sim/program.h"
#include "drill_rig_sim/sim/simulator.h"
#include "drill_scene.h"

namespace drill_rig_sim
{
namespace
{
constexpr double longest_run = 30.0 * 86400.0;  // simulated [s]
constexpr double frame_length = 0.01;           // simulated [s], as the node's default
constexpr double after_program = 60.0;          // simulated [s] that a run goes on after the program's last line by default

/// When a run ends.
struct Goal
{
  double duration;
  double depth;  // infinite where only time counts
};

/// What a run took.
struct Elapsed
{
  double wall;  // [s]
  double cpu;   // [s]
};

/// How a run ended; empty text: as it should.
struct Ending
{
  std::string failure;
  bool depth_reached = true;
};

double cpu_time()
{
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

Goal goal_of(const Arguments& arguments, const Scene& scene)
{
  const bool has_depth = arguments.has("--until-depth");
  const double program_end = scene.program.empty() ? 0.0 : scene.program.back().at;
  Goal goal{};
  goal.duration = arguments.number("--duration", 1e-3, longest_run, has_depth ? longest_run : program_end + after_program);
  goal.depth = arguments.number("--until-depth", scene.well.hole_depth, 20000.0, HUGE_VAL);
  return goal;
}

/// Plays the program up to the goal. `csv` may be null; it gets a row every `every` seconds.
Ending play(Simulator& simulator, const Goal& goal, std::FILE* csv, double every, DrillingRecord& record)
{
  const double step = simulator.scene().numerics.step;
  const double frame = step * std::max(1.0, std::round(frame_length / step));
  const Measurements& m = simulator.measurements();
  const double start_depth = m.hole_depth;
  ProgramPlayer program(simulator.scene().program);
  Progress progress;
  double next_row = 0.0;
  const auto write_row = [&]
  {
    if (!csv || m.time < next_row - 0.5 * frame) return;
    write_csv_row(csv, m);
    next_row += every * std::max(1.0, std::ceil((m.time + 0.5 * frame - next_row) / every));
  };

  write_row();
  while (m.time < goal.duration - 0.5 * frame && m.hole_depth < goal.depth)
  {
    program.apply(simulator);
    if (simulator.frame(frame) == FrameStatus::failed) return {simulator.failure(), false};
    record.add(m);
    write_row();
    const double drilled = (m.hole_depth - start_depth) / (goal.depth - start_depth);
    progress.show(std::max(m.time / goal.duration, drilled), m.time, m.hole_depth);
  }
  return {"", m.hole_depth >= goal.depth || std::isinf(goal.depth)};
}

Json json_of(const Averages& a)
{
  Json json;
  json.add("hook_load", a.hook_load());
  json.add("torque", a.torque());
  json.add("wob", a.wob());
  json.add("bit_torque", a.bit_torque());
  json.add("bit_speed_rpm", a.bit_speed() / rpm);
  json.add("rop", a.rop());
  json.add("hole_depth", a.hole_depth());
  json.add("bit_east", a.bit_position().x());
  json.add("bit_north", a.bit_position().y());
  json.add("bit_up", a.bit_position().z());
  json.add("inclination_deg", a.inclination() / degree);
  json.add("azimuth_deg", a.azimuth() / degree);
  return json;
}

Json json_of(const Profiler& costs)
{
  const std::pair<const char*, Cost> names[] = {{"kinematics", Cost::kinematics},
                                                {"elements", Cost::elements},
                                                {"inertia", Cost::inertia},
                                                {"contact", Cost::contact},
                                                {"bit", Cost::bit},
                                                {"rig", Cost::rig},
                                                {"linear_solve", Cost::linear_solve},
                                                {"rock_penetration", Cost::rock_penetration},
                                                {"other", Cost::other}};
  double total = 0.0;
  for (const auto& name : names) total += costs.seconds(name.second);
  Json json;
  for (const auto& name : names) json.add(name.first, costs.seconds(name.second) / total);
  return json;
}

Json json_of(const ReferenceReport& report)
{
  Json json;
  json.add("constraint_drift", report.drift);
  json.add("constraint_rate_drift", report.rate_drift);
  json.add("jacobians", static_cast<double>(report.ida.jacobians));
  json.add("error_test_failures", static_cast<double>(report.ida.error_test_failures));
  json.add("newton_failures", static_cast<double>(report.ida.newton_failures));
  json.add("starts", static_cast<double>(report.ida.starts));
  json.add("last_order", report.ida.last_order);
  json.add("last_step", report.ida.last_step);
  json.add("smallest_step", report.ida.smallest_step);
  return json;
}

Json json_of(const EnergyAccounts& e)
{
  Json json;
  const std::pair<const char*, double> accounts[] = {
      {"winch", e.winch}, {"drive", e.drive}, {"pump", e.pump}, {"gravity", e.gravity}, {"stored", e.stored()},
      {"wall_friction", e.wall_friction}, {"wall_damping", e.wall_damping}, {"bottom_damping", e.bottom_damping}, {"squeeze_film", e.squeeze_film},
      {"mud", e.mud}, {"structural", e.structural}, {"motor_slip", e.motor_slip}, {"stuck_point_released", e.stuck_point_released},
      {"ledge", e.ledge}, {"added_mass", e.added_mass}, {"rock_thrust", e.rock_thrust}, {"rock_torque", e.rock_torque}, {"correction", e.correction},
      {"numerical_inertia", e.of_inertia}, {"numerical_beams", e.of_beams}, {"numerical_contact", e.of_contact},
      {"numerical_line", e.of_line}, {"numerical_residual", e.of_residual}, {"numerical_rebasing", e.of_rebasing},
      {"residual", e.residual()}, {"throughput", e.throughput()}, {"closure", e.closure()}, {"numerical_share", e.numerical_share()},
      {"numerical_of_losses", e.numerical_of_losses()}};
  for (const auto& account : accounts) json.add(account.first, account.second);
  return json;
}

Json summary_of(const Simulator& simulator, const Elapsed& elapsed, const DrillingRecord& record, const Ending& ending)
{
  const SimulatorStatistics& s = simulator.statistics();
  const Measurements& m = simulator.measurements();
  Json json;
  json.add("scene", simulator.scene().name);
  json.add("simulated_s", m.time);
  json.add("wall_s", elapsed.wall);
  json.add("cpu_s", elapsed.cpu);
  json.add("real_time_factor", m.time / elapsed.cpu);
  json.add("level", std::string(s.level));
  json.add("integrator", std::string(s.integrator));
  json.add("step", s.step);
  json.add("nodes", s.nodes);
  json.add("coordinates", s.coordinates);
  json.add("steps", static_cast<double>(s.steps));
  json.add("newton_iterations", static_cast<double>(s.newton_iterations));
  json.add("rejected_steps", static_cast<double>(s.convergence_failures + s.error_test_failures));
  json.add("convergence_failures", static_cast<double>(s.convergence_failures));
  json.add("error_test_failures", static_cast<double>(s.error_test_failures));
  json.add("residuals", static_cast<double>(s.work.residuals));
  json.add("tangents", static_cast<double>(s.work.tangents));
  json.add("solves", static_cast<double>(s.work.solves));
  json.add("substitutions", static_cast<double>(s.work.substitutions));
  if (s.is_reference) json.add("reference", json_of(s.reference));
  json.add("cost_share", json_of(s.costs));
  if (simulator.energy().time > 0.0) json.add("energy", json_of(simulator.energy()));
  Averages now;
  now.add(m);
  json.add("final", json_of(now));
  json.add("mean_drilling", json_of(record.all()));
  json.add("mean_last_quarter", json_of(record.last_quarter()));
  if (!ending.failure.empty()) json.add("failure", ending.failure);
  return json;
}

void print_summary(const Simulator& simulator, const Elapsed& elapsed, const DrillingRecord& record)
{
  const Measurements& m = simulator.measurements();
  std::printf("%s: %.1f s simulated in %.2f s (%.1f times real time), hole %.3f m\n", simulator.scene().name.c_str(), m.time,
              elapsed.cpu, m.time / elapsed.cpu, m.hole_depth);
  const Averages mean = record.last_quarter();
  if (mean.samples() == 0)
  {
    std::printf("the bit was not on bottom; hook load %.1f kN, torque %.2f kN m\n", m.hook_load / 1e3, m.torque / 1e3);
    return;
  }
  std::printf(
      "drilling, mean of the last quarter: hook load %.1f kN, torque %.2f kN m, WOB %.1f kN, ROP %.2f m/h, bit %.0f rpm\n",
      mean.hook_load() / 1e3, mean.torque() / 1e3, mean.wob() / 1e3, 3600.0 * mean.rop(), mean.bit_speed() / rpm);
}

void refuse_what_is_not_there(const Arguments& arguments)
{
  if (arguments.has("--bag")) throw UsageError("--bag: not available yet; use --csv");
  const std::string level = arguments.text("--level", "beam3d");
  if (level != "beam3d") throw UsageError("--level: '" + level + "' is not available yet, allowed: beam3d");
}

// options that are keys of the scene under another name
std::vector<std::string> settings_of(const Arguments& arguments)
{
  std::vector<std::string> settings = arguments.all("--set");
  const std::pair<const char*, const char*> keys[] = {
      {"--level", "level"}, {"--integrator", "integrator"}, {"--step", "step"}, {"--element-length", "element_length"}};
  for (const auto& key : keys)
  {
    if (arguments.has(key.first)) settings.push_back(std::string("numerics.") + key.second + "=" + arguments.text(key.first));
  }
  return settings;
}

/// Saves the last good state, the summary and the forces along the string, and throws.
[[noreturn]] void report_failure(const Simulator& simulator, const Ending& ending, const std::string& summary,
                                 const Arguments& arguments)
{
  const std::string json = arguments.text("--json", "drill_failed.json");
  const std::string csv =
      (json.size() > 5 && json.substr(json.size() - 5) == ".json" ? json.substr(0, json.size() - 5) : json) + "_string.csv";
  if (!arguments.has("--json"))
  {
    File out = open_output("last good state", json);
    std::fputs(summary.c_str(), out.get());
    close_output(std::move(out), json);
  }
  StringProfile profile;
  simulator.profile(profile);
  File out = open_output("last good state", csv);
  write_profile(out.get(), profile);
  close_output(std::move(out), csv);

  char at[64];
  std::snprintf(at, sizeof at, "at %.3f s simulated: ", simulator.measurements().time);
  throw ComputationError(simulator.scene().file + ": " + at + ending.failure + "; the last good state is in " + json + " and " +
                         csv);
}

void run(const Arguments& arguments)
{
  refuse_what_is_not_there(arguments);
  const Scene scene = read_scene(arguments.file, settings_of(arguments));
  const Goal goal = goal_of(arguments, scene);
  const double every = arguments.number("--every", 1e-4, 1e6, 0.1);
  const auto seed = static_cast<std::uint64_t>(arguments.number("--seed", 0.0, 9e15, 0.0));

  // all files are opened ahead, so that a long run does not end on a misspelt folder
  const auto open = [&](const char* option)
  { return arguments.has(option) ? open_output(option, arguments.text(option)) : File(); };
  File csv = open("--csv"), json = open("--json"), path = open("--path"), raw_path = open("--raw-path");
  if (csv) write_csv_header(csv.get());

  Simulator simulator = build_simulator(scene, seed);
  if (arguments.has("--energy") && !simulator.balance_energy())
    throw UsageError("--energy: no energy balance for integrator '" + std::string(simulator.statistics().integrator) + "' with element '" +
                     find_beam(scene.numerics.element).name + "', allowed: all integrators but ida, element corotational");
  DrillingRecord record;
  const auto wall_start = std::chrono::steady_clock::now();
  const double cpu_start = cpu_time();
  const Ending ending = play(simulator, goal, csv.get(), every, record);
  const Elapsed elapsed{std::chrono::duration<double>(std::chrono::steady_clock::now() - wall_start).count(),
                        cpu_time() - cpu_start};
  const std::string summary = summary_of(simulator, elapsed, record, ending).text() + "\n";

  if (json) std::fputs(summary.c_str(), json.get());
  if (path) write_path(path.get(), simulator);
  if (raw_path) write_raw_path(raw_path.get(), simulator);
  if (csv) close_output(std::move(csv), arguments.text("--csv"));
  if (json) close_output(std::move(json), arguments.text("--json"));
  if (path) close_output(std::move(path), arguments.text("--path"));
  if (raw_path) close_output(std::move(raw_path), arguments.text("--raw-path"));
  if (!ending.failure.empty()) report_failure(simulator, ending, summary, arguments);
  print_summary(simulator, elapsed, record);
  if (!ending.depth_reached) std::printf("the depth of --until-depth was not reached within --duration\n");
}
}  // namespace

const Command run_command = {
    "run",
    "SCENE",
    "plays a scene's program as fast as it goes",
    {{"--duration", "S", "simulated seconds; default: until depth, or 60 s after the program's last line"},
     {"--until-depth", "MD", "stop when the hole is this deep [m]"},
     {"--level", "L", "level of the model instead of the scene's"},
     {"--integrator", "I", "stepper instead of the scene's"},
     {"--step", "H", "physics step instead of the scene's [s]"},
     {"--element-length", "M", "longest element instead of the scene's [m]"},
     {"--set", "KEY=VALUE", "any key of the scene, as well.sections[0].friction=0; may be repeated"},
     {"--seed", "N", "of the sensors' noise"},
     {"--csv", "FILE", "writes time series"},
     {"--every", "S", "between rows of the time series, default 0.1"},
     {"--json", "FILE", "writes a summary"},
     {"--energy", nullptr, "keeps an energy balance; the summary shows it [J]"},
     {"--path", "FILE", "writes the well's corrected path"},
     {"--raw-path", "FILE", "writes the uncorrected path of the last metres"},
     {"--bag", "FILE", "not available yet"}},
    run};

}  // namespace drill_rig_sim
