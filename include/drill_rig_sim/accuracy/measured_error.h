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
/// Where both errors fell with the square of elements and steps the run's error would be 1/(1 - 1/2^2) = 1.33 of its difference to the finer companion, and
/// 1/(2^2 - 1) = 0.33 to the coarser one. Impacts, fronts and friction make it fall more slowly. In 48 random scenes, with a reference of elements and
/// steps a quarter as long, the difference to the finer companion is 0.55 to 1.6 of the true error in 90 % of the windows; to the coarser one 0.4 to 4.9.
/// With a factor of 1 the finer one warns of 5 of the 39 right scenes and of all wrong ones, of one of them 3 s late; with 1.05 of 8, with 1.2 of 12.
/// `./test/accuracy/run --random` reports that ratio.
constexpr CompanionTraits traits_of(CompanionKind kind) noexcept
{
  return kind == CompanionKind::finer ? CompanionTraits{2.0, 1.0} : CompanionTraits{0.5, 0.85};
}

/// How far the measurement is behind the run [s], so that run and companion need not wait for each other at every frame.
constexpr double measured_after = 0.1;

/// Errors of a run's outputs, measured beside a companion: over the last 3 s (difference_window), relative to the output's range so far, a tenth of its
/// level, or a tenth of an instrument's resolution over the tolerance, whichever is largest: errors that no instrument shows do not count.
///
/// The outputs of a frame are compared measured_after later, or when `capacity` frames wait: then the same frames are compared at the same time wherever the
/// companion is computed. Bounded, allocates nothing.
class MeasuredError
{
public:
  /// Frames that can wait to be compared.
  static constexpr std::uint64_t capacity = 256;

  /// @param tolerance              numerics.tolerance
  /// @param error_over_difference  CompanionTraits
  explicit MeasuredError(double tolerance = 0.02, double error_over_difference = 1.0) noexcept;

  /// Outputs of the run over a frame of `duration` [s]. Needs a free place: due() is false, or compare() was called since.
  void add_run(const Outputs& run, double duration) noexcept;
  /// Outputs of the companion over the first frame that has none yet; NaN: it has failed. Nothing happens where no frame waits for them.
  void add_companion(const Outputs& companion) noexcept;
  /// The oldest frame is to be compared now.
  bool due() const noexcept { return compared_ < run_ && (waiting_ - oldest().duration > measured_after - rounding || is_full()); }
  /// The companion's outputs of the oldest frame are there.
  bool ready() const noexcept { return compared_ < companion_; }
  bool is_full() const noexcept { return run_ - compared_ == capacity; }
  /// Compares the oldest frame, which is ready(). False: the companion had failed, and nothing was measured.
  bool compare() noexcept;

  /// [-]
  double error(Output output) const noexcept;
  /// Of the statistics over 30 s (statistics_window), relative as error() [-]: reliable where a vibration in the two models runs out of phase.
  StatisticDifferences statistics(Output output) const noexcept;
  /// In the output's unit.
  double absolute_error(Output output) const noexcept;
  Outputs errors() const noexcept;

  template <class V>
  void visit(V& v)
  {
    v("differences", differences_);
    v("frames", frames_);
    v("run", run_);
    v("companion", companion_);
    v("compared", compared_);
    v("waiting", waiting_);
  }

private:
  double scale(Output output) const noexcept;
  static constexpr double rounding = 1e-9;  // of sums of frames [s]
  struct Frame
  {
    Outputs run{}, companion{};
    double duration = 0.0;

    template <class V>
    void visit(V& v)
    {
      v("run", run);
      v("companion", companion);
      v("duration", duration);
    }
  };
  const Frame& oldest() const noexcept { return frames_[compared_ % capacity]; }

  double error_over_difference_;
  double resolved_share_;  // a tenth of an instrument's resolution over the tolerance, over that resolution
  std::array<OutputDifference, output_count> differences_;
  std::array<Frame, capacity> frames_;  // ring
  std::uint64_t run_ = 0, companion_ = 0, compared_ = 0;  // frames, since the start
  double waiting_ = 0.0;  // duration of the frames not compared yet [s]
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
