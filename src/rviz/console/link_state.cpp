// SPDX-License-Identifier: BSD-3-Clause
#include "link_state.h"

namespace drill_rig_sim::console
{
LinkState link_state(const Heard& heard)
{
  if (!heard.shown) return LinkState::hidden;
  if (!heard.master) return LinkState::no_master;
  if (!heard.publisher || (heard.state_age > gone_after && heard.diagnostics_age > gone_after)) return LinkState::absent;
  const double slowness = heard.speed > 0.0 && heard.speed < 1.0 ? 1.0 / heard.speed : 1.0;
  const bool lives = heard.diagnostics_age < diagnostics_late_after || heard.state_age < diagnostics_late_after;
  switch (heard.run_state)
  {
    case RunState::unknown:
      return LinkState::expected;
    case RunState::running:
      return heard.state_age < late_after * slowness ? LinkState::running : LinkState::late;
    case RunState::paused:
      return lives ? LinkState::paused : LinkState::late;
    case RunState::waiting:
      return lives ? LinkState::waiting : LinkState::late;
    case RunState::failed:
      return lives ? LinkState::failed : LinkState::late;
  }
  return LinkState::expected;
}

bool hears(LinkState state)
{
  return state != LinkState::hidden && state != LinkState::no_master && state != LinkState::absent;
}

const char* name_of(LinkState state)
{
  switch (state)
  {
    case LinkState::hidden:
      return "HIDDEN";
    case LinkState::no_master:
      return "NO MASTER";
    case LinkState::absent:
      return "ABSENT";
    case LinkState::expected:
      return "NO READINGS YET";
    case LinkState::running:
      return "RUNNING";
    case LinkState::late:
      return "LATE";
    case LinkState::paused:
      return "PAUSED";
    case LinkState::waiting:
      return "WAITS FOR A STEP";
    case LinkState::failed:
      return "FAILED";
  }
  return "";
}

RunState run_state_of(const std::string& word)
{
  if (word == "running") return RunState::running;
  if (word == "paused") return RunState::paused;
  if (word == "waiting for a step") return RunState::waiting;
  if (word == "failed") return RunState::failed;
  return RunState::unknown;
}

}  // namespace drill_rig_sim::console
