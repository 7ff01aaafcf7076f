#ifndef DRILL_RIG_SIM_MODEL_KERNELS_HISTORY_KERNEL_H
#define DRILL_RIG_SIM_MODEL_KERNELS_HISTORY_KERNEL_H

#include <cstddef>

#include "drill_rig_sim/math/kernel.h"

/// What a step takes from those before it and leaves to the next, several nodes at a time.
namespace drill_rig_sim
{
/// Rows of numbers: the first, and how many bytes lie between two.
template <class Number>
struct NumberRows
{
  Number* first;
  std::ptrdiff_t stride;
};

/// Stage::rate and acceleration as sums of three quantities of the past in the step's axes (in_step_axes()).
struct RatesTask
{
  int count;
  NumberRows<const double> orientation;  ///< at the start of the step
  NumberRows<const double> past[3];      ///< NodeRates
  double in_rate[3], in_acceleration[3];  ///< their factors
  double *rate, *acceleration;           ///< 6 a node, overwritten
};

/// By kernel.
struct HistoryKernel
{
  void (*find_rates)(const RatesTask& task) noexcept;
  /// split() of six numbers of NodeMoves from `at` on: NodeRates, overwritten.
  void (*split)(int count, NumberRows<const double> moves, int at, NumberRows<double> out) noexcept;
  /// NodeRates with their tilts carried() along: into `out`, which may be where they are.
  void (*carry)(int count, NumberRows<const double> moves, NumberRows<const double> rates, NumberRows<double> out) noexcept;
};

/// Null: there is none, and node by node is the way.
const HistoryKernel* history_kernel(Kernel kernel) noexcept;

}  // namespace drill_rig_sim

#endif
