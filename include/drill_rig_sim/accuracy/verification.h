// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_ACCURACY_VERIFICATION_H
#define DRILL_RIG_SIM_ACCURACY_VERIFICATION_H

#include <array>
#include <limits>
#include <vector>

#include "drill_rig_sim/accuracy/output_difference.h"

namespace drill_rig_sim
{
/// Compares a run with two finer runs of the same rig: error of each output.
///
/// The finest run is the reference. Its own error is a third of the difference of the two finer runs, because half elements and
/// steps divide an error of second order by four. Larger errors were seldom found (test/accuracy/README.md).
///
/// In a vibration that lasts (stick-slip, bit bounce, whirl) small errors of the period add up, and the runs get out of phase for
/// good: their instants are then samples of the same motion. Where no warning was given, such an output is judged by its
/// statistics over statistics_window instead, from the begin of the first wrong window of the run on (Finding::parted_from). The
/// conditions:
/// - a whole statistics_window has passed since;
/// - at its end the root mean square of the difference over the last statistics_window is beyond the tolerance, so the runs have
///   not come back to each other;
/// - the output swings in the run and in the finest one, three times or more in each such window (WindowStatistics).
class Verification
{
public:
  static constexpr double none = std::numeric_limits<double>::quiet_NaN();

  /// What was found of an output over the windows of the run, each of difference_window.
  struct Finding
  {
    double scale = 0.0;  ///< range of the finest run, a tenth of its level or the resolution of an instrument, whichever is most
    double worst = 0.0;  ///< largest root mean square of a window's difference to the finest run, over `scale` [-]
    double worst_until = 0.0;   ///< end of that window [s]
    double own = 0.0;           ///< of the finest run's own errors, in the same way, the largest [-]
    double wrong_from = none;   ///< begin of the first window beyond the tolerance [s]; NaN: none
    bool known = true;          ///< the finest run's own error is below a third of the tolerance there, or of the difference
    double parted_from = none;  ///< its statistics are judged from then on [s]; NaN: its instants are
    /// Largest differences of statistics to the finest run since parted_from: over `scale`, of the period relative [-]; else NaN.
    StatisticDifferences statistics{none, none, none, none};
    bool statistics_known = true;          ///< as `known`, of them
    double mean = 0.0, finest_mean = 0.0;  ///< of the whole run
    std::vector<double> off,
        measured;  ///< of each window: its difference to the finest run over `scale`, and the error measured at its end [-]
  };

  /// From the best to the worst.
  enum class Verdict
  {
    right,   ///< no window of an output that is needed is beyond the tolerance, or no statistics where these are judged
    warned,  ///< some are, and a warning had begun by the end of the first of them
    missed,  ///< some are, and none had
    unknown  ///< the own error of the finest run is too large for a verdict
  };

  /// @param tolerance  relative
  /// @param needs      outputs that count for the verdict, a sum of Need
  Verification(double tolerance, unsigned needs);

  /// A frame that ends at `time` [s]. `warned`: the run itself says that it may be wrong. `measured`: its errors by its own
  /// companion; NaN without one.
  void add(const Outputs& run, const Outputs& finer, const Outputs& finest, bool warned, const Outputs& measured, double time,
           double duration);
  Finding finding(Output output) const;
  /// On one output, whether it is needed or not.
  Verdict verdict(Output output) const;
  /// The worst of the outputs that are needed.
  Verdict verdict() const;
  /// When the first warning began [s]; NaN: none did.
  double warned_from() const noexcept { return warned_from_; }
  /// Begin of the first window of the run in which an output that is needed is wrong [s]; NaN: none is.
  double parted_from() const;
  bool needed(Output output) const noexcept { return (needs_ & traits_of(output).need) != 0u; }

private:
  struct Row
  {
    OutputDifference to_finest, between_finer;
    std::vector<double> off, own;                          // of each window, in the output's unit
    std::vector<StatisticDifferences> off_over, own_over;  // of statistics_window at the end of each
    std::vector<double> measured;                          // at its end [-]
    double sum = 0.0, finest_sum = 0.0;
  };

  void end_window(const Outputs& measured, double time);
  void find_instants(const Row& row, Finding& found) const;
  void find_statistics(const Row& row, double from, Finding& found) const;
  /// Window whose end is the first with a whole statistics_window since `from`; ends_.size() where there is none.
  std::size_t first_over(double from) const;
  bool has_parted(const Row& row, const Finding& found, double from) const;
  static bool swings(const StatisticDifferences& over) noexcept;

  double tolerance_;
  unsigned needs_;
  double time_ = 0.0, since_window_ = 0.0;  // [s]
  double warned_from_ = none;
  std::array<Row, output_count> rows_;
  std::vector<double> ends_;  // of the windows [s]
};

}  // namespace drill_rig_sim

#endif
