// SPDX-License-Identifier: BSD-3-Clause
#include "drill_failure.h"

#include <cmath>
#include <cstddef>
#include <cstdio>
#include <utility>

#include "drill_command.h"
#include "drill_output.h"

namespace drill_rig_sim
{
namespace
{
std::string without_json(const std::string& name)
{
  const bool ends = name.size() > 5 && name.compare(name.size() - 5, 5, ".json") == 0;
  return ends ? name.substr(0, name.size() - 5) : name;
}

/// Where the last good state is, or why it is nowhere: the failure itself is reported in any case.
std::string keep_last_state(const Simulator& simulator, const std::string& summary, const std::string& json_name)
try
{
  const std::string json = json_name.empty() ? "drill_failed.json" : json_name;
  if (json_name.empty())
  {
    File out = open_output("last good state", json);
    std::fputs(summary.c_str(), out.get());
    close_output(std::move(out), json);
  }
  const std::string csv = without_json(json) + "_string.csv";
  if (csv.rfind("/dev/", 0) == 0) return "the last good state's summary is in " + json;
  StringProfile profile;
  simulator.profile(profile);
  File out = open_output("last good state", csv);
  write_profile(out.get(), profile);
  close_output(std::move(out), csv);
  return "the last good state is in " + json + " and " + csv;
}
catch (const std::exception& e)
{
  return e.what();
}
}  // namespace

void report_failure(const Simulator& simulator, const std::string& summary, const std::string& json_name)
{
  char at[64];
  std::snprintf(at, sizeof at, "at %.3f s simulated: ", simulator.truth().time);
  throw ComputationError(simulator.scene().file + ": " + at + simulator.failure() + "; " +
                         keep_last_state(simulator, summary, json_name));
}

void report_standstill(const Simulator& simulator, const RunGoal& goal, const std::vector<double>& operations_began)
{
  char text[160];
  const std::vector<Operation>& operations = simulator.scene().operations;
  const std::size_t i = operations_over(operations_began);
  if (i < operations.size())
  {
    std::snprintf(text, sizeof text, ": operations[%zu], %s, has made no progress for %g s: its end cannot be reached", i,
                  word_of(operations[i].kind), goal.patience);
    throw ComputationError(simulator.scene().file + text);
  }
  std::snprintf(text, sizeof text,
                ": the depth of --until-depth, %g m, is not reached: the hole is %.3f m deep and has not grown for %g s",
                goal.depth, simulator.truth().hole_depth, goal.patience);
  throw ComputationError(simulator.scene().file + text);
}

void report_trouble(const Simulator& simulator, const OperationStatus& operation)
{
  char text[200];
  std::snprintf(text, sizeof text, ": operations[%d], %s, was given up at %.3f s, and the block braked: %s", operation.number - 1,
                word_of(operation.kind), simulator.truth().time, text_of(operation.trouble));
  throw ComputationError(simulator.scene().file + text);
}

}  // namespace drill_rig_sim
