// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SCENE_OPERATION_H
#define DRILL_RIG_SIM_SCENE_OPERATION_H

#include <cmath>
#include <limits>

/// What a scene's operations program is made of: what a driller does, one thing after the other, each until its end.
namespace drill_rig_sim
{
enum class OperationKind
{
#define OPERATION(name, ...) name,
#include "drill_rig_sim/scene/operation_list.h"
};

struct OperationTraits
{
  const char* word;  ///< of the scene file
  bool moves;        ///< the block: the brake is set at its end
  bool drills;       ///< its depth and distance are those of the hole
  bool by_crew;      ///< the rig's crew (crew/crew.h) makes connections for it, whatever `connections` of the scene says
};

/// By OperationKind.
constexpr OperationTraits operation_traits[] = {
#define OPERATION(name, moves, drills, by_crew, ...) {#name, moves, drills, by_crew},
#include "drill_rig_sim/scene/operation_list.h"
};
constexpr const OperationTraits& traits_of(OperationKind kind) noexcept
{
  return operation_traits[static_cast<int>(kind)];
}

/// One operation. NaN means that it does not end by this. It goes by the readings, as a driller does, and ends by whichever of
/// its ends comes first.
struct Operation
{
  static constexpr double unset = std::numeric_limits<double>::quiet_NaN();
  OperationKind kind = OperationKind::wait;
  double ramp = 0.0;  ///< over which flow or rotary speed is reached, in a straight line [s]
  double flow = 0.0;  ///< of the pump [m3/s]
  double rotary_speed =
      0.0;  ///< + clockwise; of oscillate, and of slide that rocks, the largest, 0: angle_speed (drive_reference.h) [rad/s]
  double speed = 0.1;            ///< of the block; of drill and slide the largest [m/s]
  double weight = unset;         ///< surface weight on bit: to be kept by drill and slide, an end of slack_off and tag [N]
  double toolface = 0.0;         ///< to be held; of steer as SteeringSetpoint's [rad]
  double ratio = 0.0;            ///< of steer, 0 .. 1
  double amplitude_right = 0.0;  ///< about the drive's angle clockwise [rad]
  double amplitude_left = 0.0;   ///< counterclockwise [rad]
  int times = 1;                 ///< strokes of ream, up and down
  double to_depth = unset;       ///< end: bit depth; of drill and slide hole depth [m MD]
  double distance = unset;       ///< end: travel of the block; of drill and slide metres drilled; of ream a stroke [m]
  double time = unset;           ///< end: so long after it began, or after a ramp was over [s]
  double remove = unset;         ///< 1: connection takes a stand away
  double overpull = unset;       ///< end of pick_up: hook load above that at its beginning [N]

  template <class V>
  void visit(V& v)
  {
    v("kind", kind);
    v("ramp", ramp);
    v("flow", flow);
    v("rotary_speed", rotary_speed);
    v("speed", speed);
    v("weight", weight);
    v("toolface", toolface);
    v("ratio", ratio);
    v("amplitude_right", amplitude_right);
    v("amplitude_left", amplitude_left);
    v("times", times);
    v("to_depth", to_depth);
    v("distance", distance);
    v("time", time);
    v("remove", remove);
    v("overpull", overpull);
  }
};

/// Whether a number of an operation or of a program's line was given: unset is NaN.
inline bool is_set(double value) noexcept
{
  return !std::isnan(value);
}
/// The word of the scene file.
constexpr const char* word_of(OperationKind kind) noexcept
{
  return traits_of(kind).word;
}
constexpr bool needs_crew(OperationKind kind) noexcept
{
  return traits_of(kind).by_crew;
}
/// Of a kind, with what it is by default.
Operation default_operation(OperationKind kind) noexcept;

}  // namespace drill_rig_sim

#endif
