// SPDX-License-Identifier: BSD-3-Clause
// Friction of the wall on the bit's gauge: the gauge turns with the mud motor, the string above it does not.
#include <gtest/gtest.h>

#include <cmath>

#include "drill_rig_sim/math/rotation.h"
#include "lone_bit.h"
#include "one_step.h"

namespace test_model_gauge
{
using namespace drill_rig_sim;
using Eigen::Vector3d;

namespace
{
constexpr double step = 0.01, pressed = 1e-3, kinetic = 0.3, ratio = 1.5, stribeck = 0.8;  // [s], [m], [-], [-], [m/s]
constexpr double radius = 0.05;                                                            // of the bit [m]

/// The bit, or the string's node above it, pressed into the wall on the east side. Its friction falls from 0.45 to 0.3 over 0.8
/// m/s.
struct PressedGauge
{
  RigAtRest rig;
  int node;
  double normal = 0.0;  // force [N]

  explicit PressedGauge(int at = 0) : rig(build_at_rest(scene())), node(at)
  {
    const MeshNode& mesh_node = rig.model->mesh().nodes[node];
    rig.state.nodes[node].position.x() = 0.5 * 0.2159 - mesh_node.contact_radius + pressed;
    normal = mesh_node.contact.stiffness * std::pow(pressed, 1.5);
  }
  static Scene scene()
  {
    Scene scene = lone_bit_scene();
    scene.well.sections[0].friction = kinetic;
    scene.contact.static_ratio = ratio;
    scene.contact.stribeck_speed = stribeck;
    scene.string = {bit_part(2.0 * radius), pipe_part(0, 4.0, plain_pipe_mass, pipe_outer)};
    return scene;
  }
  /// After a step in which the node turned at `spin` and sank at `down`, the motor turning at `motor` [rad/s], [m/s].
  const RigForces& after(double spin, double down, double motor, Workspace& work)
  {
    rig.state.bit.motor_speed = motor;
    std::vector<double> u(6 * rig.model->nodes(), 0.0);
    u[6 * node + 2] = -step * down;
    u[6 * node + 5] = -step * spin;  // clockwise looking down
    evaluate_one_step(rig, step, u, work);
    return work.result.forces;
  }
  /// Of the friction at a sliding speed [N].
  double friction(double speed) const
  {
    return kinetic * (1.0 + (ratio - 1.0) * std::exp(-std::pow(speed / stribeck, 2))) * normal;
  }
};
}  // namespace

// Clockwise looking down the gauge's east side goes south: the wall pushes it north, and turns the bit anticlockwise, which is +
// z.
TEST(Gauge, slidesAtTheMotorsSpeed)
{
  PressedGauge gauge;
  Workspace work(*gauge.rig.model);
  for (const double motor : {8.0, 16.0, 40.0})
  {
    const double friction = gauge.friction(radius * motor);
    const RigForces& f = gauge.after(0.0, 0.0, motor, work);
    EXPECT_NEAR(f.contact[0], gauge.normal, 1e-3 * gauge.normal);
    EXPECT_NEAR(f.wall[0].x(), -gauge.normal, 1e-3 * gauge.normal);
    EXPECT_NEAR(f.wall[0].y(), friction, 1e-3 * friction);
    EXPECT_NEAR(f.bit_moment.z(), radius * friction, 1e-3 * radius * friction);
  }
}

TEST(Gauge, addsTheStringsSpinToTheMotors)
{
  PressedGauge gauge;
  Workspace work(*gauge.rig.model);
  const double together = gauge.friction(radius * 22.0);
  EXPECT_NEAR(gauge.after(6.0, 0.0, 16.0, work).wall[0].y(), together, 1e-3 * together);
  EXPECT_NEAR(gauge.after(-38.0, 0.0, 16.0, work).wall[0].y(), -together, 1e-3 * together) << "and the string's turn against it";
  // a string that turns back as fast as the motor turns on leaves the gauge where it is
  EXPECT_NEAR(gauge.after(-16.0, 0.0, 16.0, work).wall[0].y(), 0.0, 1e-6 * gauge.normal);
  EXPECT_NEAR(work.result.bristle[0].norm(), 0.0, 1e-9);
}

// Turning frees the axial slide: friction points against the whole of the sliding, 0.6 m/s around and 0.3 m/s down.
TEST(Gauge, motorTakesItsShareOfTheFriction)
{
  PressedGauge gauge;
  Workspace work(*gauge.rig.model);
  const double around = radius * 12.0, down = 0.3, speed = std::hypot(around, down), friction = gauge.friction(speed);
  const RigForces& f = gauge.after(0.0, down, 12.0, work);
  EXPECT_NEAR(f.wall[0].y(), friction * around / speed, 1e-3 * friction);
  EXPECT_NEAR(f.wall[0].z(), friction * down / speed, 1e-3 * friction);
}

TEST(Gauge, turnsAloneTheStringStands)
{
  PressedGauge above(1);
  Workspace work(*above.rig.model);
  const RigForces& f = above.after(0.0, 0.0, 40.0, work);
  EXPECT_NEAR(f.contact[1], above.normal, 1e-3 * above.normal);
  EXPECT_NEAR(f.wall[1].y(), 0.0, 1e-9 * above.normal);
  const double friction = above.friction(0.5 * pipe_outer * 16.0);
  EXPECT_NEAR(above.after(16.0, 0.0, 40.0, work).wall[1].y(), friction, 1e-3 * friction) << "at its own speed";
}
}  // namespace test_model_gauge
