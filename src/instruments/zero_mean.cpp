// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/instruments/zero_mean.h"

#include <cmath>

#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/rig/top_drive.h"

namespace drill_rig_sim
{
namespace
{
/// The block's direction by its set point, + up, 0 at rest.
int direction_of(const WinchSetpoint& winch) noexcept
{
  if (winch.brake) return 0;
  return winch.block_velocity > 0.0 ? 1 : winch.block_velocity < 0.0 ? -1 : 0;
}
}  // namespace

HungString::HungString(const Mesh& mesh, const HoistingSpec& hoisting, double block_height)
{
  double weight = hoisting.block_mass, give = 0.0;
  for (const MeshElement& element : mesh.elements)
  {
    weight += element.linear_mass * element.section.length;
    give += element.section.length / element.section.axial;
  }
  mass = weight - hoisting.block_mass;
  stiffness = 1.0 / give;
  lines = line_pull(hoisting, block_height, line_length_for(hoisting, block_height, weight * standard_gravity)).stiffness;
}

/// A rod of mass m and stiffness k, free below, under a block of mass M on lines of stiffness K: k (b tan b + b^2 M/m) = K, the
/// frequency b sqrt(k/m).
double HungString::ring_period(double block_mass) const noexcept
{
  double low = 0.0, high = 0.5 * pi;
  for (int i = 0; i < 60; ++i)
  {
    const double b = 0.5 * (low + high);
    const bool is_above = stiffness * b * (std::tan(b) + b * block_mass / mass) > lines;
    (is_above ? high : low) = b;
  }
  return 2.0 * pi / (high * std::sqrt(stiffness / mass));
}

ZeroMean::ZeroMean(double wave_period) : heaves_(wave_period > 0.0), mean_(wave_period)
{
}

void ZeroMean::rings_with(double period) noexcept
{
  if (!heaves_) mean_.set_period(mean_time(period));
}

double ZeroMean::mean_time(double period) noexcept
{
  return period * std::ceil(shortest_mean / period);
}

void ZeroMean::take(double hook_load, const RigSignals& now, bool on_bottom) noexcept
{
  const int direction = direction_of(now.setpoints.winch);
  const bool turns = std::abs(now.top_drive_speed) > standing_rotor;
  if (direction != direction_) began_at_ = now.block_height;
  const bool builds_up = direction != 0 && std::abs(now.block_height - began_at_) < 2.0 * sheave_presliding;
  const bool acts_another_way = !heaves_ && (direction != direction_ || turns != turns_ || builds_up);
  if (acts_another_way) mean_.restart();
  if (acts_another_way || on_bottom || now.in_slips || now.setpoints.pump.flow != flow_) window_.restart();
  direction_ = direction;
  turns_ = turns;
  flow_ = now.setpoints.pump.flow;
  mean_.take(hook_load, now.time);
  window_.take(hook_load, now.stand_pipe_pressure, now.time);
}

}  // namespace drill_rig_sim
