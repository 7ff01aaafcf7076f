// SPDX-License-Identifier: BSD-3-Clause
#include "drill_summary.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <optional>

#include "drill_rig_sim/crew/operations.h"
#include "drill_rig_sim/hydraulics/mud_circuit.h"
#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/scene/scene_mesh.h"
#include "drill_rig_sim/instruments/signal_rows.h"

namespace drill_rig_sim
{
namespace
{
using Json = nlohmann::ordered_json;

Json json_of(const Averages& a)
{
  return {{"hook_load", a.hook_load()},
          {"torque", a.torque()},
          {"wob", a.wob()},
          {"bit_torque", a.bit_torque()},
          {"bit_speed_rpm", a.bit_speed() / rpm},
          {"rop", a.rop()},
          {"hole_depth", a.hole_depth()},
          {"bit_east", a.bit_position().x()},
          {"bit_north", a.bit_position().y()},
          {"bit_up", a.bit_position().z()},
          {"inclination_deg", a.inclination() / degree},
          {"azimuth_deg", a.azimuth() / degree}};
}

/// In the type of the message; null for NaN.
Json json_of(const SignalRow& row, double value)
{
  const std::string type = row.type;
  if (type == "bool") return value != 0.0;
  if (type == "float64") return value;
  return static_cast<std::int64_t>(value);
}

Json json_of(const Readings& r)
{
  Json json;
  for (const SignalRow& row : signal_rows())
    if (row.in_readings) json[row.name] = json_of(row, row.in_readings(r));
  const auto once_received = [](std::uint64_t sequence, double value) { return sequence > 0 ? Json(value) : Json(); };
  json["mwd_md"] = once_received(r.mwd.sequence, r.mwd.md);
  json["mwd_inclination_deg"] = once_received(r.mwd.sequence, r.mwd.inclination / degree);
  json["mwd_azimuth_deg"] = once_received(r.mwd.sequence, r.mwd.azimuth / degree);
  json["toolface_deg"] = once_received(r.toolface.sequence, r.toolface.toolface / degree);
  return json;
}

Json shares_of(const Profiler& costs)
{
  const std::pair<const char*, Cost> names[] = {{"kinematics", Cost::kinematics},
                                                {"elements", Cost::elements},
                                                {"guided", Cost::guided},
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
  for (const auto& name : names) json[name.first] = costs.seconds(name.second) / total;
  return json;
}

Json json_of(const ReferenceReport& report)
{
  return {{"constraint_drift", report.drift},
          {"constraint_rate_drift", report.rate_drift},
          {"jacobians", report.ida.jacobians},
          {"error_test_failures", report.ida.error_test_failures},
          {"newton_failures", report.ida.newton_failures},
          {"starts", report.ida.starts},
          {"last_order", report.ida.last_order},
          {"last_step", report.ida.last_step},
          {"smallest_step", report.ida.smallest_step}};
}

Json json_of(const EnergyAccounts& e)
{
  return {{"winch", e.winch},
          {"drive", e.drive},
          {"pump", e.pump},
          {"heave", e.heave},
          {"gravity", e.gravity},
          {"steering", e.steering},
          {"handled", e.handled},
          {"stored", e.stored()},
          {"wall_friction", e.wall_friction},
          {"wall_damping", e.wall_damping},
          {"bottom_damping", e.bottom_damping},
          {"squeeze_film", e.squeeze_film},
          {"mud", e.mud},
          {"structural", e.structural},
          {"block", e.block},
          {"gearbox", e.gearbox},
          {"motor_slip", e.motor_slip},
          {"stuck_point_released", e.stuck_point_released},
          {"ledge", e.ledge},
          {"added_mass", e.added_mass},
          {"rock_thrust", e.rock_thrust},
          {"rock_torque", e.rock_torque},
          {"correction", e.correction},
          {"numerical_inertia", e.of_inertia},
          {"numerical_beams", e.of_beams},
          {"numerical_contact", e.of_contact},
          {"numerical_line", e.of_line},
          {"numerical_residual", e.of_residual},
          {"numerical_rebasing", e.of_rebasing},
          {"residual", e.residual()},
          {"throughput", e.throughput()},
          {"closure", e.closure()},
          {"numerical_share", e.numerical_share()},
          {"numerical_of_losses", e.numerical_of_losses()}};
}

Json json_of(const Doubts& doubts)
{
  Json list = Json::array();
  for (const Doubts::Entry& doubt : doubts.entries())
    list.push_back({{"since", doubt.times.since},
                    {"until", doubt.times.until},
                    {"lasted", doubt.times.lasted},
                    {"text", text_of(doubt.report)}});
  return list;
}

Json json_of(const LargestErrors& errors)
{
  Json out;
  for (std::size_t i = 0; i < output_count; ++i)
  {
    const LargestErrors::Entry& entry = errors.of(static_cast<Output>(i));
    out[output_traits[i].name] = {{"largest", entry.error}, {"until", entry.until}};
  }
  return out;
}

Json json_of(const Limits& limits)
{
  Json list = Json::array();
  for (const Limits::Entry& entry : limits.entries())
  {
    list.push_back(
        {{"flag", entry.flag}, {"since", entry.times.since}, {"until", entry.times.until}, {"lasted", entry.times.lasted}});
    if (entry.load.share == 0.0) continue;
    list.back()["share"] = entry.load.share;
    list.back()["from_bit"] = entry.load.from_bit;
  }
  return list;
}

/// Those that have begun; the last one without an end is under way.
Json json_of(const std::vector<Operation>& operations, const RunRecord& record)
{
  const std::vector<double>& began = record.operations_began;
  Json list = Json::array();
  for (std::size_t i = 0; i < operations.size() && !std::isnan(began[i]); ++i)
  {
    list.push_back({{"do", word_of(operations[i].kind)}, {"began", began[i]}});
    if (!std::isnan(began[i + 1])) list.back()["ended"] = began[i + 1];
  }
  for (const FeedLimits::Entry& entry : record.feed.entries())
    if (entry.is_reported()) list[entry.operation]["limited_by_speed"] = entry.limited;
  const HungUp& hung_up = record.operation.hung_up;
  if (hung_up.number > 0) list[static_cast<std::size_t>(hung_up.number) - 1]["ended_above_bottom"] = hung_up.above;
  if (record.operation.trouble != OperationTrouble::none) list.back()["given_up"] = text_of(record.operation.trouble);
  return list;
}

void print_operations(const std::vector<Operation>& operations, const RunRecord& record)
{
  const std::vector<double>& began = record.operations_began;
  if (operations.empty()) return;
  if (record.operation.hung_up.number > 0) std::printf("operations: %s\n", text_of(record.operation.hung_up).c_str());
  const std::size_t i = operations_over(began);
  if (i == operations.size())
    std::printf("operations: all %zu over at %.1f s\n", i, began[i]);
  else if (record.operation.trouble != OperationTrouble::none)
    std::printf("operations: number %zu of %zu, %s, was given up: %s\n", i + 1, operations.size(), word_of(operations[i].kind),
                text_of(record.operation.trouble));
  else
    std::printf("operations: number %zu of %zu, %s, was not over by the end\n", i + 1, operations.size(),
                word_of(operations[i].kind));
}

const Printed::InSI kilonewton{"%.1f", "kN", 1e-3}, kilonewton_metre{"%.2f", "kN m", 1e-3};

void print_feed(const std::vector<Operation>& operations, const FeedLimits& feed, const Printed& printed)
{
  for (const FeedLimits::Entry& entry : feed.entries())
  {
    if (!entry.is_reported()) continue;
    const Operation& o = operations[entry.operation];
    std::printf("%s\n", feed_limit_text(entry.operation, o, "limited", entry.mean_weight(), entry.limited, printed).c_str());
  }
}

void print(const Limits::Entry& entry, const Printed& printed)
{
  std::printf("limit passed, %s: %s", text_of(entry.times).c_str(), entry.what);
  if (entry.load.share > 0.0)
    std::printf(", at most %.2f times it, %s above the bit", entry.load.share,
                printed(entry.load.from_bit, Dimension::length, {"%.4g", "m"}).c_str());
  std::printf(" (%s)\n", entry.flag);
}

void add_work(const SimulatorStatistics& s, Json& json)
{
  json["steps"] = s.steps;
  json["newton_iterations"] = s.newton_iterations;
  json["rejected_steps"] = s.convergence_failures + s.error_test_failures;
  json["convergence_failures"] = s.convergence_failures;
  json["error_test_failures"] = s.error_test_failures;
  json["residuals"] = s.work.residuals;
  json["tangents"] = s.work.tangents;
  json["solves"] = s.work.solves;
  json["substitutions"] = s.work.substitutions;
}

Json summary_of(const Simulator& simulator, const Elapsed& elapsed, const RunRecord& record)
{
  const SimulatorStatistics& s = simulator.statistics();
  const Truth& m = simulator.truth();
  Json json = {{"scene", simulator.scene().name},
               {"simulated_s", m.time},
               {"wall_s", elapsed.wall},
               {"cpu_s", elapsed.cpu},
               {"real_time_factor", m.time / elapsed.cpu},
               {"level", s.level},
               {"integrator", s.integrator},
               {"kernel", name_of(s.kernel)},
               {"step", s.step},
               {"nodes", s.nodes},
               {"guided_nodes", s.frames > 0 ? static_cast<double>(s.guided_node_frames) / static_cast<double>(s.frames) : 0.0},
               {"coordinates", s.coordinates}};
  if (!simulator.choice().empty()) json["choice"] = simulator.choice();
  add_work(s, json);
  json["accuracy_warnings"] = json_of(record.doubts);
  json["measured_error"] = record.errors.measured() ? json_of(record.errors) : Json();
  if (*s.not_measured) json["not_measured"] = s.not_measured;
  json["limits_passed"] = json_of(record.limits);
  if (!simulator.scene().operations.empty()) json["operations"] = json_of(simulator.scene().operations, record);
  if (s.is_reference) json["reference"] = json_of(s.reference);
  json["cost_share"] = shares_of(s.costs);
  if (simulator.energy().time > 0.0) json["energy"] = json_of(simulator.energy());
  Averages now;
  now.add(m);
  json["final"] = json_of(now);
  json["mean_drilling"] = json_of(record.drilling.all());
  json["mean_last_quarter"] = json_of(record.drilling.last_quarter());
  if (*simulator.failure()) json["failure"] = simulator.failure();
  return json;
}

void print_errors(const Simulator& simulator, const LargestErrors& errors)
{
  if (const char* why = simulator.statistics().not_measured; *why) std::printf("error not measured: %s\n", why);
  if (!errors.measured()) return;
  std::printf("measured error, largest of 3 s:");
  const char* between = " ";
  for (std::size_t i = 0; i < output_count; ++i)
  {
    if (!(simulator.scene().needs & output_traits[i].need)) continue;
    std::printf("%s%s %.2g %%", between, output_traits[i].name, 100.0 * errors.of(static_cast<Output>(i)).error);
    between = ", ";
  }
  std::printf("\n");
}

/// Where the pump has run.
void print_doubt_of_pressures(const Simulator& simulator)
{
  if (simulator.truth().pump_strokes == 0) return;
  const Scene& scene = simulator.scene();
  const std::string doubt =
      doubt_of_pressures(mud_circuit(scene, build_mesh(scene, scene.start.bit_depth + scene.start.block_height)));
  if (!doubt.empty()) std::printf("pressures: %s\n", doubt.c_str());
}

}  // namespace

std::string json_summary(const Simulator& simulator, const Elapsed& elapsed, const RunRecord& record, bool readings)
{
  // a scene's name may hold bytes that are no UTF-8: shown as U+FFFD instead of an exception at the end of a long run
  Json json = summary_of(simulator, elapsed, record);
  if (readings) json["final_readings"] = json_of(simulator.readings());
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

void print_summary(const Simulator& simulator, const Elapsed& elapsed, const RunRecord& record, const Printed& printed)
{
  const Truth& m = simulator.truth();
  std::printf("%s: %.1f s simulated in %.2f s (%.1f times real time), hole %s\n", simulator.scene().name.c_str(), m.time,
              elapsed.cpu, m.time / elapsed.cpu, printed(m.hole_depth, Dimension::length, {"%.3f", "m"}).c_str());
  print_errors(simulator, record.errors);
  for (const Doubts::Entry& doubt : record.doubts.entries())
    std::printf("accuracy warning, %s: %s\n", text_of(doubt.times).c_str(), text_of(doubt.report).c_str());
  for (const Limits::Entry& entry : record.limits.entries()) print(entry, printed);
  print_doubt_of_pressures(simulator);
  if (simulator.statistics().tight) std::printf("assembly warning: %s\n", text_of(*simulator.statistics().tight).c_str());
  print_feed(simulator.scene().operations, record.feed, printed);
  print_operations(simulator.scene().operations, record);
  const Averages mean = record.drilling.last_quarter();
  if (mean.samples() == 0)
  {
    const Averages latest = record.latest.all();
    if (latest.samples() == 0) return;
    std::printf("the bit was never on bottom; mean of %.0f to %.0f s: hook load %s, torque %s\n", latest.first_time(),
                latest.last_time(), printed(latest.hook_load(), Dimension::force, kilonewton).c_str(),
                printed(latest.torque(), Dimension::torque, kilonewton_metre).c_str());
    return;
  }
  std::printf("drilling, mean of its last quarter, %.0f to %.0f s: hook load %s, torque %s, WOB %s, ROP %s, bit %s\n",
              mean.first_time(), mean.last_time(), printed(mean.hook_load(), Dimension::force, kilonewton).c_str(),
              printed(mean.torque(), Dimension::torque, kilonewton_metre).c_str(),
              printed(mean.wob(), Dimension::force, kilonewton).c_str(),
              printed(mean.rop(), Dimension::penetration, {"%.2f", "m/h", 3600.0}).c_str(),
              printed(mean.bit_speed(), Dimension::rotation, {"%.0f", "rpm", 1.0 / rpm}).c_str());
}

}  // namespace drill_rig_sim
