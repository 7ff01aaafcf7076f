// SPDX-License-Identifier: BSD-3-Clause
#include "camera_preset.h"

#include <algorithm>
#include <cmath>

#include "color_scale.h"
#include "well_picture.h"

namespace drill_rig_sim
{
using Eigen::Vector3d;

namespace
{
constexpr double half_pi = 1.5707963267948966;
constexpr double shown = 0.83;  // height of the picture over the distance of what is shown, at 45 deg from top to bottom
constexpr double margin = 1.25;

OrbitView looking_from(const Vector3d& focus, const Vector3d& towards_eye, double distance)
{
  OrbitView view;
  view.focus = focus;
  view.distance = distance;
  view.yaw = std::atan2(towards_eye.y(), towards_eye.x());
  view.pitch = std::atan2(towards_eye.z(), towards_eye.head<2>().norm());
  return view;
}

/// Horizontal, to the right of the way from the table to the hole's bottom.
Vector3d beside_well(const HoleAxis& axis)
{
  const Vector3d along = closure_direction(axis);
  return {along.y(), -along.x(), 0.0};
}

OrbitView whole_well(Preset preset, const HoleAxis& axis, double crown_height)
{
  Vector3d least = Vector3d::Zero(), most = Vector3d::Zero();
  for (const AxisPoint& p : axis.points())
  {
    least = least.cwiseMin(p.position);
    most = most.cwiseMax(p.position);
  }
  if (preset == Preset::plan)
  {
    OrbitView view;
    view.focus = 0.5 * (least + most);
    view.focus.z() = 0.0;
    view.distance = std::max(margin * (most - least).head<2>().maxCoeff() / shown, 60.0);
    view.yaw = -half_pi;
    view.pitch = half_pi - 0.001;
    return view;
  }
  most.z() = crown_height;
  const double size =
      std::max(most.z() - least.z(), (most - least).head<2>().norm() / 1.4);  // a picture is wider than it is high
  return looking_from(0.5 * (least + most), beside_well(axis), std::max(margin * size / shown, 30.0));
}
}  // namespace

double exaggeration_for(Preset preset, const HoleAxis& axis, double hole_radius) noexcept
{
  constexpr double by_bit = 10.0, share = 1.0 / 50.0;
  if (preset == Preset::derrick) return 1.0;
  if (preset != Preset::plan && preset != Preset::section) return by_bit;
  return std::max(by_bit, round_up(0.7 * share * axis.depth() / (2.0 * std::max(hole_radius, 0.01))));
}

OrbitView view_of(Preset preset, const HoleAxis& axis, const Subject& subject) noexcept
{
  const AxisPoint bit = axis.at(subject.bit_md);
  switch (preset)
  {
    case Preset::derrick:
    {
      const double height = subject.crown_height;
      return looking_from({0.0, 0.0, 0.45 * height}, {1.0, -0.8, 0.25}, margin * height / shown);
    }
    case Preset::along_hole:
    {
      // from the high side, beside the string, and not so far up that a bend of the hole hides the bit
      const double back = 14.0 * subject.hole_radius;
      const AxisPoint up = axis.at(subject.bit_md - back);
      const Vector3d towards_eye = up.position + 0.8 * subject.hole_radius * high_side_of(up.tangent) - subject.bit;
      OrbitView view = looking_from(subject.bit, towards_eye, towards_eye.norm());
      view.pitch = std::min(view.pitch, half_pi - 0.001);
      return view;
    }
    case Preset::bit:
    {
      const double height = std::max(12.0 * subject.hole_radius, 20.0);
      const Vector3d beside(bit.tangent.y(), -bit.tangent.x(), 0.0);
      const Vector3d towards_eye = beside.norm() > 0.02 ? Vector3d(beside.normalized()) : beside_well(axis);
      return looking_from(subject.bit - 0.3 * height * bit.tangent, towards_eye + 0.15 * Vector3d::UnitZ(), height / shown);
    }
    case Preset::plan:
    case Preset::section:
      break;
  }
  return whole_well(preset, axis, subject.crown_height);
}

}  // namespace drill_rig_sim
