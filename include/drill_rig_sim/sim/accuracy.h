// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SIM_ACCURACY_H
#define DRILL_RIG_SIM_SIM_ACCURACY_H

#include <cstdint>
#include <string>

#include "drill_rig_sim/accuracy/output_difference.h"
#include "drill_rig_sim/accuracy/outputs.h"

namespace drill_rig_sim
{
/// Why the numbers of a run may be wrong, though every step was solved.
enum class AccuracyDoubt
{
  none,
  measured,     ///< the measured error of an output is larger than the tolerance
  confined,     ///< guided pipe is compressed so far that it would buckle
  compression,  ///< an element carries more than it can bend under
  twist,        ///< an element is twisted by more than its beam is made for
  embedding,    ///< the string lies deeper in the wall than the hole is wide beside it
  slant,        ///< the hole is inclined at the rotary table, but the rig is upright
  level,        ///< the level does not represent an output that the scene needs
  turn          ///< the bit drills aside, and the body that follows it does not let the hole turn so fast
};

/// A warning, how large and where.
struct AccuracyReport
{
  AccuracyDoubt doubt = AccuracyDoubt::none;
  double measure =
      0.0;  ///< measured: error [-]; confined: over the critical buckling load; compression: over what the element can carry;
            ///< twist [rad]; embedding [m]; slant [rad]; level: sum of the needs; turn: of the hole by the rock law [rad/m]
  double from_bit = 0.0;        ///< where on the string [m]; confined, compression, twist, embedding
  double element_length = 0.0;  ///< of the element there [m]; compression, twist
  double allowed = 0.0;  ///< measured: numerics.tolerance [-]; turn: by the body [rad/m]; embedding: stiffness that will do
  Output output = Output::hook_load;  ///< measured: the one with the largest error
  StatisticDifferences statistics{};  ///< measured: errors of its statistics over 30 s [-]

  template <class V>
  void visit(V& v)
  {
    v("doubt", doubt);
    v("measure", measure);
    v("output", output);
    v("from_bit", from_bit);
    v("element_length", element_length);
    v("allowed", allowed);
    v("statistics", statistics);
  }
};

/// A short identifier of the reason, which stays the same in later versions; empty for none.
const char* code_of(AccuracyDoubt doubt) noexcept;

/// The warning in one line that names the remedy; empty where there is none. Allocates.
std::string text_of(const AccuracyReport& report);

/// What is kept from frame to frame.
struct AccuracyMemory
{
  std::uint64_t frames = 0;  ///< since the start
  double stands_for = 0.0;   ///< the report stays so much longer without a new cause [s]
  AccuracyReport report;

  template <class V>
  void visit(V& v)
  {
    v("frames", frames);
    v("stands_for", stands_for);
    v("report", report);
  }
};

}  // namespace drill_rig_sim

#endif
