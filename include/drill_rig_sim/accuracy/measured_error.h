// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_ACCURACY_MEASURED_ERROR_H
#define DRILL_RIG_SIM_ACCURACY_MEASURED_ERROR_H

#include <array>
#include <cstdint>

#include "drill_rig_sim/accuracy/output_difference.h"
#include "drill_rig_sim/scene/numerics_spec.h"

namespace drill_rig_sim
{
/// A companion's elements and steps, and what its difference to the run says.
struct CompanionTraits
{
  double refinement;             ///< factor by which its elements and steps are shorter than the run's
  double error_over_difference;  ///< the run's error over its difference to the companion
};

/// Of numerics.companion.
///
/// Where errors fall with the power p of elements and steps, the run's error is 1/(1 - 1/2^p) of its difference to the finer
/// companion: 1.33 for the second order of beams and steps, 1.14 for p = 3; and 1/(2^p - 1) of its difference to the coarser one.
/// Impacts, fronts and friction spread that. In 48 random scenes, with a reference of elements and steps a quarter as long, the
/// error is 1.16 of the difference to the finer companion in the median, 1.05 to 1.3 of it in half of the windows, and 0.7 to 1.5
/// in 90 %. With a factor of 1 the finer one warns of 4 of the 38 right scenes and misses 1 of the 10 wrong ones, with 1.1 of 6
/// and 1, with 1.2 of 8 and none; the exact error as it stands so far, over the range so far, would warn of 4.
/// The factor of the coarser one is 1/(2^p - 1) of p = 1.1, as fronts have it: in 64 other scenes it warns of 10 of the 40 right
/// ones and misses 3 of the 22 wrong ones, where the finer one, three times as dear in all, warns of 6 and misses 4; the measured
/// error is 0.5 to 3.5 of the true one in 90 % of the windows, by the finer one 0.75 to 1.8. `./test/accuracy/run --random`
/// reports all of that.
constexpr CompanionTraits traits_of(CompanionKind kind) noexcept
{
  return kind == CompanionKind::finer ? CompanionTraits{2.0, 1.1} : CompanionTraits{0.5, 0.85};
}

/// How far the measurement is behind the run [s], so that run and companion need not wait for each other at every frame.
constexpr double measured_after = 0.1;

/// Errors of a run's outputs, measured beside a companion: over the last 3 s (difference_window), relative to the output's range
/// so far, a tenth of its level, or an instrument's resolution, whichever is largest (OutputDifference::scale). The range of the
/// whole run is known only at its end. At first it is larger than the range so far, and the error would be too large. So the
/// speed that the top drive has reached counts in the range of the bit speed, which follows later. The range of the weight on bit
/// begins at 0, also in a scene that starts with a weight: it is measured from off bottom. Nothing tells how large it will
/// become.
///
/// The outputs of a frame are compared measured_after later, or when `capacity` frames wait: then the same frames are compared at
/// the same time wherever the companion is computed. Bounded, allocates nothing.
class MeasuredError
{
public:
  /// Frames that can wait to be compared.
  static constexpr std::uint64_t capacity = 256;

  /// @param error_over_difference  CompanionTraits
  explicit MeasuredError(double error_over_difference = 1.0) noexcept;

  /// Outputs of the run over a frame of `duration` [s], and the top drive's speed [rad/s]. Needs a free place: due() is false, or
  /// compare() was called since.
  void add_run(const Outputs& run, double top_drive_speed, double duration) noexcept;
  /// Outputs of the companion over the first frame that has none yet; NaN: it has failed. Nothing happens where no frame waits
  /// for them.
  void add_companion(const Outputs& companion) noexcept;
  /// The oldest frame is to be compared now.
  bool due() const noexcept
  {
    return compared_ < run_ && (waiting_ - oldest().duration > measured_after - rounding || is_full());
  }
  /// The companion's outputs of the oldest frame are there.
  bool ready() const noexcept { return compared_ < companion_; }
  bool is_full() const noexcept { return run_ - compared_ == capacity; }
  /// Compares the oldest frame, which is ready(). False: the companion had failed, and nothing was measured.
  bool compare() noexcept;

  /// [-]
  double error(Output output) const noexcept;
  /// Of the statistics over 30 s (statistics_window), relative as error() [-]: reliable where a vibration in the two models runs
  /// out of phase.
  StatisticDifferences statistics(Output output) const noexcept;
  /// In the output's unit.
  double absolute_error(Output output) const noexcept;
  Outputs errors() const noexcept;
  /// A frame of `duration` [s] later: those of its `errors` that have been above the tolerance for so long that they are warned
  /// of (OutputTraits::warned_after); 0: the others.
  Outputs lasting(const Outputs& errors, double tolerance, double duration) noexcept;

  template <class V>
  void visit(V& v)
  {
    v("differences", differences_);
    v("frames", frames_);
    v("run", run_);
    v("companion", companion_);
    v("compared", compared_);
    v("waiting", waiting_);
    v("above_for", above_for_);
  }

private:
  static constexpr double rounding = 1e-9;  // of sums of frames [s]
  struct Frame
  {
    Outputs run{}, companion{};
    double top_drive_speed = 0.0, duration = 0.0;

    template <class V>
    void visit(V& v)
    {
      v("run", run);
      v("companion", companion);
      v("top_drive_speed", top_drive_speed);
      v("duration", duration);
    }
  };
  const Frame& oldest() const noexcept { return frames_[compared_ % capacity]; }

  double error_over_difference_;
  std::array<OutputDifference, output_count> differences_;
  std::array<Frame, capacity> frames_;                    // ring
  std::uint64_t run_ = 0, companion_ = 0, compared_ = 0;  // frames, since the start
  double waiting_ = 0.0;                                  // duration of the frames not compared yet [s]
  Outputs above_for_{};                                   // how long they have been above the tolerance [s]
};

/// An output and its error [-].
struct OutputError
{
  Output output = Output::hook_load;
  double error = 0.0;
};

/// The largest, of the outputs that `needs` (a sum of Need) asks for.
OutputError largest_of(const Outputs& errors, unsigned needs) noexcept;

}  // namespace drill_rig_sim

#endif
