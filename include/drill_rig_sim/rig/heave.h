#ifndef DRILL_RIG_SIM_RIG_HEAVE_H
#define DRILL_RIG_SIM_RIG_HEAVE_H

/// Heave of a floating rig: floor, derrick, winch, rail and slips go up and down together about the place where the hole's depths begin.
namespace drill_rig_sim
{
struct HeaveSpec
{
  double amplitude = 0.0;  ///< A [m]; 0: the rig stands on the ground
  double period = 10.0;    ///< T [s]
};

/// Of the rotary table about its mean place.
struct FloorMotion
{
  double height = 0.0;  ///< [m], + up
  double speed = 0.0;   ///< [m/s]
};

/// A r(t/T) sin(2 pi t/T) at `time` t >= 0 [s] after the rig stood at rest: regular waves, that come up in the first period by r(s) = s^2 (3 - 2 s), then 1, so that
/// neither height nor speed nor acceleration jumps at the start.
FloorMotion floor_motion(const HeaveSpec& spec, double time) noexcept;

/// Largest acceleration of the waves once they are there, A (2 pi/T)^2 [m/s2].
double heave_acceleration(const HeaveSpec& spec) noexcept;

}  // namespace drill_rig_sim

#endif
