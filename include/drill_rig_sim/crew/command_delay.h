// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_CREW_COMMAND_DELAY_H
#define DRILL_RIG_SIM_CREW_COMMAND_DELAY_H

#include <cstddef>
#include <vector>

#include "drill_rig_sim/rig/setpoints.h"

namespace drill_rig_sim
{
/// Dead times between a set point and its actuator: the rig's controller (PLC) passes all of them on after one, the drawworks'
/// drive takes the winch's after another. An actuator gets y(t) = x(t - T), of the set points x that were given at the frames'
/// begins. Without dead times they pass as they are. A dead time is held in steps of a 400th of the longest.
class CommandDelay
{
public:
  CommandDelay() = default;
  /// `plc`: of all set points, `drawworks`: beyond that of the winch's [s]. Allocates.
  CommandDelay(double plc, double drawworks);
  /// The frame that begins at `now` [s] has these set points given.
  void take(const Setpoints& given, double now) noexcept;
  /// What the actuators get in it; before the first set point is due, those of a rig at rest, braked.
  const Setpoints& passed() const noexcept { return passed_; }
  /// Of a model that goes along with another: actuators get what those of the other get.
  void follow(const Setpoints& passed) noexcept { passed_ = passed; }
  bool is_on() const noexcept { return plc_ > 0.0 || drawworks_ > 0.0; }

  /// What it remembers; the dead times are the scene's.
  template <class V>
  void visit(V& v)
  {
    v("line", line_);
    v("next", next_);
    v("held", held_);
    v("passed", passed_);
  }

private:
  struct Sample
  {
    double time = 0.0;
    Setpoints given;

    template <class V>
    void visit(V& v)
    {
      v("time", time);
      v("given", given);
    }
  };
  const Setpoints& given_before(double time) const noexcept;

  double plc_ = 0.0, drawworks_ = 0.0;  // [s]
  double spacing_ = 0.0;                // between samples, at the shortest [s]
  std::vector<Sample> line_;            // ring
  std::size_t next_ = 0, held_ = 0;
  Setpoints passed_;
};

}  // namespace drill_rig_sim

#endif
