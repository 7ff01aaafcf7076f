// SPDX-License-Identifier: BSD-3-Clause
// A collar that rolls on the wall of its hole without slip. Its axis circles the hole's axis with radius rho = (D - d)/2 and rate
// Omega, its surface is at rest at the contact: Omega rho + omega d/2 = 0, hence Omega = -omega d/(D - d): backward whirl.
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "drill_rig_sim/solve/start.h"
#include "drill_rig_sim/solve/stepper.h"
#include "groups.h"
#include "report.h"
#include "test_scenes.h"

namespace drill_rig_sim
{
namespace
{
constexpr double kHole = 0.2159;   // D [m]
constexpr double kFriction = 1.0;  // ample for rolling

/// 3 m of collar on 40 m of slim pipe in a vertical hole, in nothing that drags: mud without density.
Scene rolling_scene(double collar)
{
  Scene scene = without_damping(vertical_scene(50.0, 40.0, kFriction));
  scene.mud.density = 1.0;
  scene.mud.lateral_damping = 0.0;
  PartSpec body = collar_part(3, 1.0);
  body.outer_diameter = collar;
  PartSpec pipe = pipe_part(0, 9.5, 8.0, 0.0);
  pipe.outer_diameter = 0.05;
  pipe.inner_diameter = 0.03;
  scene.string = {bit_part(collar), body, pipe};
  scene.string[0].bit->squeeze_film_damping = 0.0;
  scene.contact.law.stiffness = 1e10;  // so stiff that the embedding does not widen the circle: 0.03 mm
  return scene;
}

/// Puts the collar on the wall, turning, and circling a fifth too slowly: friction must find the rate.
void start_whirling(RigAtRest& rig, double collar, double speed)
{
  const double radius = 0.5 * (kHole - collar), rate = -0.8 * speed * collar / (kHole - collar);
  const double stiff = 3.5, slope = 25.0;  // the collar as one, the pipe above it back to the middle [m]
  for (int i = 0; i < rig.model->nodes(); ++i)
  {
    NodeState& node = rig.state.nodes[i];
    const double share = std::max(0.0, 1.0 - std::max(0.0, rig.model->mesh().nodes[i].from_bit - stiff) / slope);
    node.rate.spin = speed;
    node.position.x() += share * radius;
    node.rate.velocity = share * radius * rate * Eigen::Vector3d(0.0, -1.0, 0.0);  // clockwise looking down
  }
  rig.state.drive.speed = speed;
}

/// Angle from a to b about the vertical, clockwise looking down [rad].
double turn_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  return -std::atan2(a.x() * b.y() - a.y() * b.x(), a.head<2>().dot(b.head<2>()));
}

/// Angle circled per angle spun, over five seconds after five of run-in.
double whirl_ratio(double collar)
{
  RigAtRest rig = build_at_rest(rolling_scene(collar));
  Setpoints setpoints;
  setpoints.top_drive.speed = 60.0 * rpm;
  start_whirling(rig, collar, setpoints.top_drive.speed);
  Stepper stepper(rig.model, find_method(IntegratorKind::automatic));
  const double step = 5e-4;
  const NodeState& node = rig.state.nodes[2];  // 1.3 m from the bit
  double circled = 0.0, spun_before = 0.0;
  for (int k = 0; k < 20000; ++k)
  {
    if (k == 10000)
    {
      circled = 0.0;
      spun_before = node.spin_angle;
    }
    const Eigen::Vector3d before = node.position;
    if (!stepper.advance(rig.state, step, setpoints)) throw std::runtime_error("whirl: a step failed");
    circled += turn_between(before, node.position);
  }
  return circled / (node.spin_angle - spun_before);
}
}  // namespace

void whirl_cases(Report& report)
{
  // 0.5 %: the embedding widens the circle by 0.03 mm of 25 mm, and five turns do not average the bounces of the pipe above
  report.add({"backward whirl per turn: collar 0.165 m in 0.2159 m [-]", whirl_ratio(0.165), -0.165 / (kHole - 0.165), 5e-3,
              "rolling without slip: -d/(D - d)"});
  report.add({"backward whirl per turn: collar 0.120 m in 0.2159 m [-]", whirl_ratio(0.120), -0.120 / (kHole - 0.120), 5e-3,
              "rolling without slip: -d/(D - d)"});
}

}  // namespace drill_rig_sim
