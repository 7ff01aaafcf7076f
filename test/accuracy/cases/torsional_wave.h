// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_ACCURACY_TORSIONAL_WAVE_H
#define DRILL_RIG_SIM_ACCURACY_TORSIONAL_WAVE_H

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

/// A string that only turns, by the method of characteristics: knows nothing of the simulator.
///
///   I v_t = -M_x - d v - F,  M_t = -Z c v_x;  p = v + M/Z runs down, q = v - M/Z up, one cell a step (no numerical diffusion).
/// v spin speed, M torque (+ turns what is below clockwise), I = Z/c rotary inertia per metre, d viscous and F dry friction per
/// metre. Both sections have the same wave speed c. Dry friction holds a cell at rest as long as its limit allows.
namespace drill_rig_sim
{
struct WaveSection
{
  int cells = 0;
  double impedance = 0.0;  ///< Z [N m s/rad]
};

class TorsionalWave
{
public:
  using Friction = std::function<double(double speed, int cell)>;  ///< limit per metre [N m/m]

  /// Cells count from the top; `damping` of each cell [N m s/rad per m].
  TorsionalWave(double wave_speed, double cell_length, WaveSection upper, WaveSection lower, std::vector<double> damping)
      : step_(cell_length / wave_speed),
        upper_(upper),
        lower_(lower),
        damping_(std::move(damping)),
        down_(damping_.size()),
        up_(damping_.size())
  {
    for (std::size_t i = 0; i < damping_.size(); ++i)
      inertia_.push_back((static_cast<int>(i) < upper.cells ? upper : lower).impedance / wave_speed);
  }

  double step() const { return step_; }
  double bit_speed() const { return 0.5 * (down_.back() + up_.back()); }
  /// Torque of the top on the string, as of the last step [N m].
  double top_torque() const { return top_torque_; }

  /// `top_speed` [rad/s]; the bit is free.
  void advance(double top_speed, const Friction& friction)
  {
    const std::size_t joint = static_cast<std::size_t>(upper_.cells);
    const double from_above = down_[joint - 1], from_below = up_[joint];
    const double at_joint =
        (upper_.impedance * from_above + lower_.impedance * from_below) / (upper_.impedance + lower_.impedance);
    const double at_top = up_.front(), at_bit = down_.back();
    std::rotate(down_.rbegin(), down_.rbegin() + 1, down_.rend());
    std::rotate(up_.begin(), up_.begin() + 1, up_.end());
    down_.front() = 2.0 * top_speed - at_top;
    up_.back() = at_bit;
    down_[joint] = 2.0 * at_joint - from_below;
    up_[joint - 1] = 2.0 * at_joint - from_above;
    top_torque_ = upper_.impedance * (top_speed - at_top);
    for (std::size_t i = 0; i < down_.size(); ++i) rub(i, friction);
  }

private:
  void rub(std::size_t i, const Friction& friction)
  {
    const double wanted = 0.5 * (down_[i] + up_[i]), torque = 0.5 * (down_[i] - up_[i]);
    const double free = wanted * (1.0 - step_ * damping_[i] / inertia_[i]);
    const double brake = step_ / inertia_[i] * friction(std::abs(free), static_cast<int>(i));
    const double speed = std::copysign(std::max(0.0, std::abs(free) - brake), free);
    down_[i] = speed + torque;
    up_[i] = speed - torque;
  }

  double step_;
  WaveSection upper_, lower_;
  std::vector<double> damping_, inertia_, down_, up_;
  double top_torque_ = 0.0;
};

}  // namespace drill_rig_sim

#endif
