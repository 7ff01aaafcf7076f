// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_ACCURACY_OUTPUTS_H
#define DRILL_RIG_SIM_ACCURACY_OUTPUTS_H

#include <array>
#include <cstddef>

#include "drill_rig_sim/scene/needs.h"

namespace drill_rig_sim
{
/// What two models of the same rig are compared by.
enum class Output : std::size_t
{
  hook_load,
  torque,  ///< at the surface
  wob,
  rop,  ///< mean of the last second: where rock changes it jumps, and when it does to the frame is nothing
  bit_speed,
  pressure  ///< stand pipe
};

constexpr std::size_t output_count = 6;
/// A value of each, in SI.
using Outputs = std::array<double, output_count>;

struct OutputTraits
{
  const char* name;   ///< as the column of `drill run --csv`
  const char* words;  ///< as a sentence has it
  Need need;          ///< the word of the scene's key `needs` that asks for it
  double resolved;    ///< resolution of an instrument: less does not count as a change of the output
  /// How long its measured error must stay above the tolerance before it is warned of [s]. One that touches it for less than
  /// 0.25 s is known no better. Where a bit comes to bottom, weight and rate of penetration have hardly a range yet, and 2 s
  /// later they have one: in 120 random scenes that leaves 7 of the 94 right ones under a warning instead of 10, and misses no
  /// wrong one more (1 of 26); 1 s for hook load too would leave 5, and miss 2.
  double warned_after;
};

/// Of each output, in their order: kN, 0.1 kN m, kN, 36 mm/h, rpm, bar by what rigs show.
constexpr std::array<OutputTraits, output_count> output_traits = {
    {{"hook_load", "hook load", need_hook_load, 1e3, 0.25},
     {"torque", "torque", need_torque, 100.0, 0.25},
     {"wob", "weight on bit", need_wob, 1e3, 2.0},
     {"rop", "rate of penetration", need_rop, 1e-5, 2.0},
     {"bit_speed", "bit speed", need_bit_speed, 0.1, 0.25},
     {"stand_pipe_pressure", "stand pipe pressure", need_pressure, 1e5, 0.25}}};

constexpr const OutputTraits& traits_of(Output output) noexcept
{
  return output_traits[static_cast<std::size_t>(output)];
}

}  // namespace drill_rig_sim

#endif
