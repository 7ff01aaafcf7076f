// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_RIG_HEAVE_H
#define DRILL_RIG_SIM_RIG_HEAVE_H

/// Heave of a floating rig: floor, derrick, winch, rail and slips go up and down together about the place where the hole's depths
/// begin.
namespace drill_rig_sim
{
struct HeaveSpec
{
  double amplitude = 0.0;  ///< A [m]; 0: the rig stands on the ground
  double period = 10.0;    ///< T [s]

  /// T, or 0 for a rig that stands on the ground [s].
  double wave_period() const noexcept { return amplitude > 0.0 ? period : 0.0; }
};

/// Of the rotary table about its mean place.
struct FloorMotion
{
  double height = 0.0;  ///< [m], + up
  double speed = 0.0;   ///< [m/s]
};

/// Number of periods over which the waves come up: a string of a few kilometres rings for minutes, and in one period they would
/// ring it as much as they swing it.
constexpr double rising_periods = 5.0;

/// A r(t/5T) sin(2 pi t/T) at `time` t >= 0 [s] after the rig stood at rest: regular waves, that come up in five periods by r(s)
/// = s^2 (3 - 2 s), then 1, so that neither height nor speed nor acceleration jumps at the start.
FloorMotion floor_motion(const HeaveSpec& spec, double time) noexcept;

/// How much further off bottom than on the ground the crew lifts the bit before it sets the slips [m]: a string moves by more
/// than the floor.
constexpr double lift_over_waves(const HeaveSpec& spec) noexcept
{
  return 1.5 * spec.amplitude;
}

/// Largest acceleration of the waves once they are there, A (2 pi/T)^2 [m/s2].
double heave_acceleration(const HeaveSpec& spec) noexcept;

}  // namespace drill_rig_sim

#endif
