#ifndef DRILL_RIG_SIM_SIM_COMMANDS_H
#define DRILL_RIG_SIM_SIM_COMMANDS_H

#include "drill_rig_sim/rig/setpoints.h"

namespace drill_rig_sim
{
/// What became of a command.
struct CommandResult
{
  enum class Outcome
  {
    accepted,
    clamped,  ///< taken, at the limit
    refused   ///< nothing changed
  };
  Outcome outcome = Outcome::accepted;
  const char* reason = "";  ///< one line, static storage; names the field and what is allowed
};

}  // namespace drill_rig_sim

#endif
