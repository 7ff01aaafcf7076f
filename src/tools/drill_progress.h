// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_TOOLS_DRILL_PROGRESS_H
#define DRILL_RIG_SIM_SRC_TOOLS_DRILL_PROGRESS_H

#include <chrono>

namespace drill_rig_sim
{
/// A progress bar on standard error, drawn at most ten times a second; nothing at all where standard error is no terminal.
/// By hand, because Debian 12 has no C++ library for it.
class Progress
{
public:
  Progress();
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// `fraction` done, 0 .. 1; simulated time [s]; hole depth [m].
  void show(double fraction, double time, double hole_depth);

private:
  using Clock = std::chrono::steady_clock;
  bool terminal_;
  bool drawn_ = false;
  Clock::time_point begin_;
  Clock::time_point next_;
};

}  // namespace drill_rig_sim

#endif
