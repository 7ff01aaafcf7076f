// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SIM_REQUESTS_H
#define DRILL_RIG_SIM_SIM_REQUESTS_H

#include <string>

#include "drill_rig_sim/crew/commands.h"
#include "drill_rig_sim/crew/player.h"
#include "drill_rig_sim/scene/fault_spec.h"
#include "drill_rig_sim/sim/simulator.h"

/// Requests to a simulator between two frames, refused with a reason: services of the node and the Python module use them.
/// Each throws std::runtime_error with one line (what, where, what is allowed), and then nothing has changed.
namespace drill_rig_sim
{
/// Refuses a rate that is not 0.1 to 10000 [1/s], and one whose frames hold no whole number of the scene's steps.
void check_rate(double rate, const Scene& scene);

/// Why the simulator would refuse a command at present, one line, static storage; null: it would not.
template <class Setpoint>
const char* why_refused(const Simulator& simulator, const Setpoint& command) noexcept
{
  const char* wrong = what_is_wrong(command);
  return wrong ? wrong : simulator.locked(command);
}

/// Zero of weight and differential pressure: Simulator::tare().
void ask_tare(Simulator& simulator);
/// The same at the means over the last `duration` [s]: Simulator::tare_over(). What was zeroed.
Zero ask_tare_over(Simulator& simulator, double duration);
/// What was zeroed, in one line.
std::string words_of(const Zero& zero);
/// Begins a fault, or ends it.
void ask_fault(Simulator& simulator, const Fault& fault, bool clear);
/// Sets the slips or pulls them.
void ask_slips(Simulator& simulator, bool set);
/// Sets the slips on the joint that a connection with `joints` needs.
void ask_slips_for(Simulator& simulator, std::uint32_t joints, bool remove);
/// The scene that runs, with the hole's depth, the bit's depth and the block's height at present as its start and without program
/// and operations: what operations that are asked for now are read and checked by (operations_of()).
Scene present_scene(const Simulator& simulator);
/// Refuses operations while the string is in the slips.
void require_on_hook(const Simulator& simulator);
/// What plays the operations of a YAML text (parse_operations()) on that rig. Throws SceneError. Needs no simulator, so that one
/// goes on meanwhile.
ScenePlayer operations_of(const std::string& yaml_text, const std::string& name_for_messages, const Scene& present);
/// Begins to add `joints` to the string, 0 to most_joints (connection.h), or to `remove` them; 0: a stand.
void ask_connection(Simulator& simulator, std::uint32_t joints, bool remove);

}  // namespace drill_rig_sim

#endif
