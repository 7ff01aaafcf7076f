#ifndef DRILL_RIG_SIM_ACCURACY_MEASURED_ERROR_H
#define DRILL_RIG_SIM_ACCURACY_MEASURED_ERROR_H

#include <array>

#include "drill_rig_sim/accuracy/output_difference.h"

namespace drill_rig_sim
{
/// How much finer than the model that a frame shows is the one that its error is measured beside (finer.h).
constexpr double finer_companion = 1.5;
/// The model's error over its difference to that companion. Where both fall with the square of elements and steps it would be 1/(1 - 1/1.5^2) = 1.8; but
/// what elements and steps leave of blows, fronts and friction falls more slowly, and at times hardly at all. By windows of random scenes nine of ten errors so measured
/// are 0.6 to 1.7 of the true ones, in the middle 0.9: `./test/accuracy/run --random` tells it.
constexpr double error_over_difference = 1.2;

/// What the numerics make of a rig's outputs, measured beside a finer model: over the last 3 s (difference_window), as a share of what an output has ranged
/// over so far, a tenth of its level, or what an instrument tells apart, or a tenth of that over the tolerance, whichever is most: what nobody can read is no error.
class MeasuredError
{
public:
  /// @param tolerance  numerics.tolerance
  explicit MeasuredError(double tolerance = 0.02) noexcept;

  /// Outputs of the run and of the finer model over a frame of `duration` [s].
  void add(const Outputs& run, const Outputs& finer, double duration) noexcept;
  double error(Output output) const noexcept;
  Outputs errors() const noexcept;

  template <class V>
  void visit(V& v)
  {
    v("differences", differences_);
  }

private:
  double resolved_share_;  // a tenth of what an instrument tells apart over the tolerance, over what it tells apart
  std::array<OutputDifference, output_count> differences_;
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
