// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_SIM_PIPE_HANDLING_H
#define DRILL_RIG_SIM_SRC_SIM_PIPE_HANDLING_H

#include <memory>

#include "command_intake.h"
#include "motion.h"

namespace drill_rig_sim
{
/// Slips, and the string that is lengthened or shortened in them (crew/connection.h).
/// Owns `connection` and `string` of the simulator's state. Reasons are one line, in static storage; null: there is none.
class PipeHandling
{
public:
  /// All of these have to outlive this.
  PipeHandling(const Scene& scene, Motion& motion, CommandIntake& commands, SimulatorState& state);

  /// The joint's end of pipe that is nearest to the rotary table; -1: there is none.
  int joint_at_table() const noexcept;
  /// The end above which a connection with these joints adds or takes away pipe; -1: not as many are there. Allocates.
  int joint_for(int joints, bool remove) const;
  /// Of a joint's end, unstretched from the bit's face [m]; and the end that is nearest to such a place.
  double place_of(int joint) const noexcept;
  int joint_at(double from_bit) const noexcept;
  /// Why the slips cannot be set under a joint's end now.
  const char* why_not_set(int joint) const noexcept;
  void set_slips(int joint) noexcept;
  const char* why_not_pulled() const noexcept;
  void pull_slips() noexcept;
  /// Of the pipe above the slips on what they hold [N]. The slips are set.
  double rest_load() const noexcept;

  /// Of this number of joints, 0: of a stand; < 0: to take away [m].
  double length_of(int joints, bool remove) const noexcept;
  /// Why pipe of such a length cannot be added or taken away now.
  const char* why_no_connection(int joints, bool remove) const noexcept;
  /// Breaks out: makes the string up once to see where the block has to run, and whether it can be. Allocates.
  const char* begin_connection(double length) noexcept;
  /// `duration` passes [s].
  void go_on(double duration) noexcept;
  /// It is as old as that of the rig that a companion goes along with [s].
  void follow(double elapsed) noexcept;
  /// Over, but for end_connection().
  bool is_made_up() const noexcept;
  /// Goes on with the changed string, as string_changed() has to be called then. Allocates.
  void end_connection();

  /// The model of a string. Allocates.
  std::shared_ptr<const Model> model_of(const StringBuilt& string) const;
  /// The motion's model is another one. Allocates.
  void string_changed();
  /// Node at which the crew would take a stand away; -1: none.
  int joint_below_stand() const noexcept { return joint_below_stand_; }

private:
  const char* break_out(double length);

  const Scene& scene_;
  Motion& motion_;
  CommandIntake& commands_;
  const SimulatorState& state_;
  ConnectionState& connection_;
  StringBuilt& string_;
  int joint_below_stand_ = -1;
};

}  // namespace drill_rig_sim

#endif
