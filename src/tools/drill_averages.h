// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_TOOLS_DRILL_AVERAGES_H
#define DRILL_RIG_SIM_SRC_TOOLS_DRILL_AVERAGES_H

#include <Eigen/Core>
#include <cstddef>
#include <deque>

#include "drill_rig_sim/instruments/signals.h"

namespace drill_rig_sim
{
/// Sums of what a run reports, over the samples of a while.
class Averages
{
public:
  void add(const Truth& m) noexcept;
  void add(const Averages& other) noexcept;

  std::size_t samples() const noexcept { return samples_; }
  double first_time() const noexcept { return first_time_; }
  double last_time() const noexcept { return last_time_; }

  /// Means; NaN without samples. Units as in Truth. The hole's inclination and azimuth are those of the mean direction.
  double hook_load() const noexcept { return sum_.hook_load / count(); }
  double torque() const noexcept { return sum_.torque / count(); }
  double wob() const noexcept { return sum_.wob / count(); }
  double bit_torque() const noexcept { return sum_.bit_torque / count(); }
  double bit_speed() const noexcept { return sum_.bit_speed / count(); }
  double rop() const noexcept { return sum_.rop / count(); }
  double hole_depth() const noexcept { return sum_.hole_depth / count(); }
  Eigen::Vector3d bit_position() const noexcept { return position_ / count(); }
  double inclination() const noexcept;
  double azimuth() const noexcept;

private:
  struct Sums
  {
    double hook_load = 0.0, torque = 0.0, wob = 0.0, bit_torque = 0.0, bit_speed = 0.0, rop = 0.0, hole_depth = 0.0;
  };
  double count() const noexcept;

  std::size_t samples_ = 0;
  double first_time_ = 0.0, last_time_ = 0.0;
  Sums sum_;
  Eigen::Vector3d position_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d direction_ = Eigen::Vector3d::Zero();
};

/// Averages of the drilling in a run whose end is not known beforehand: sums over slices of simulated time, put together at the
/// end.
class DrillingRecord
{
public:
  /// Takes a sample if the bit is on bottom.
  void add(const Truth& m);
  /// Over all the drilling.
  Averages all() const;
  /// Over the last quarter of the time spent drilling.
  Averages last_quarter() const;

private:
  static constexpr double slice_length = 1.0;  // [s]
  std::deque<Averages> slices_;
};

/// Averages of the last 10 s, whether the bit is on bottom or not.
class LatestRecord
{
public:
  void add(const Truth& m);
  Averages all() const;

private:
  static constexpr double slice_length = 1.0;  // [s]
  static constexpr std::size_t most_slices = 10;
  std::deque<Averages> slices_;
};

}  // namespace drill_rig_sim

#endif
