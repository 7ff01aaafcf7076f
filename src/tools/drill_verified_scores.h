// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_TOOLS_DRILL_VERIFIED_SCORES_H
#define DRILL_RIG_SIM_SRC_TOOLS_DRILL_VERIFIED_SCORES_H

#include <array>
#include <string>

#include "drill_output.h"
#include "drill_rig_sim/sim/finer_pair.h"
#include "drill_score_options.h"
#include "drill_series.h"
#include "drill_temporary_folder.h"

namespace drill_rig_sim
{
/// Time series of a run and of the two finer models beside it, in a folder of their own that goes with them, and what `drill
/// score` makes of each.
class VerifiedScores
{
public:
  /// Throws UsageError with one line where there is no room for them.
  VerifiedScores();

  /// Call after each frame of `frame` [s].
  void add(const Simulator& simulator, const FinerPair& pair, double frame);
  /// Prints the scores of the three and how far the run's are off; the same as JSON. Throws ComputationError where they could not
  /// be written or judged.
  std::string compare(const ScoreOptions& options, const std::string& units);

private:
  std::string file(std::size_t series) const;

  TemporaryFolder folder_;
  std::array<File, 3> files_;
  Beat beat_;
};

}  // namespace drill_rig_sim

#endif
