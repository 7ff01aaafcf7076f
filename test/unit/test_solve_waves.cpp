// SPDX-License-Identifier: BSD-3-Clause
// Axial and torsional waves travel at the speed of the bar's wave equation; tool joints, mass without stiffness, slow them.
#include <gtest/gtest.h>

#include <cmath>

#include "drill_rig_sim/math/rotation.h"
#include "drill_rig_sim/model/guides.h"
#include "drill_rig_sim/solve/start.h"
#include "drill_rig_sim/solve/stepper.h"
#include "test_scenes.h"

namespace test_solve_waves
{
using namespace drill_rig_sim;
using Eigen::Vector3d;

namespace
{
constexpr double kStep = 1e-4;
constexpr double kElement = 1.0;
constexpr double kWidth = 10.0;    // of the pulse [m]
constexpr double kCentre = 150.0;  // from the bit [m]

enum class Kind
{
  axial,
  torsional
};

/// 400 m of uniform pipe that hangs free, without damping.
Scene hanging_pipe(double linear_mass)
{
  Scene scene = without_damping(vertical_scene(500.0, 400.0));
  scene.string = {bit_part(0.2), pipe_part(0, 10.0, linear_mass, pipe_outer)};
  scene.numerics.element_length = kElement;
  return scene;
}

/// A smooth pulse at rest: by d'Alembert it parts into two halves that run up and down without change of shape.
void release_pulse(RigAtRest& rig, Kind kind)
{
  for (int i = 0; i + 1 < rig.model->nodes(); ++i)
  {
    const double x = (rig.model->mesh().nodes[i].from_bit - kCentre) / kWidth;
    const double shape = std::exp(-0.5 * x * x);
    if (kind == Kind::axial)
      rig.state.nodes[i].position.z() += 1e-4 * shape;
    else
      rig.state.nodes[i].orientation = rig.state.nodes[i].orientation * rotation_from_vector(Vector3d(1e-3 * shape, 0.0, 0.0));
  }
  settle_guided(rig.state);
}

/// Times at which the pulse's peak passes the nodes nearest to `places`: the zero of the rate there, from the sign that it had.
std::vector<double> arrivals(RigAtRest& rig, Kind kind, const std::vector<double>& places, double until)
{
  std::vector<int> node;
  for (double place : places)
  {
    int nearest = 0;
    for (int i = 0; i < rig.model->nodes(); ++i)
      if (std::abs(rig.model->mesh().nodes[i].from_bit - place) < std::abs(rig.model->mesh().nodes[nearest].from_bit - place))
        nearest = i;
    node.push_back(nearest);
  }
  Stepper stepper(rig.model, find_method(IntegratorKind::automatic));
  stepper.limits().tolerance = 1e-12;
  std::vector<double> last(places.size(), 0.0), most(places.size(), 0.0), out(places.size(), 0.0);
  while (rig.state.time < until)
  {
    EXPECT_TRUE(stepper.advance(rig.state, kStep, Setpoints()));
    for (std::size_t k = 0; k < places.size(); ++k)
    {
      const NodeRate& r = rig.state.nodes[node[k]].rate;
      const double rate = kind == Kind::axial ? r.velocity.z() : r.spin;
      most[k] = std::max(most[k], rate);
      const bool front_has_passed = most[k] > (kind == Kind::axial ? 1e-3 : 1e-2);  // a tenth of its rate
      if (out[k] == 0.0 && front_has_passed && rate < 0.0) out[k] = rig.state.time - kStep * (1.0 - last[k] / (last[k] - rate));
      last[k] = rate;
    }
  }
  return out;
}

/// Speed between two places, and that by which the pulse left its centre.
void expect_speed(double linear_mass, Kind kind, double expected)
{
  for (const Level level : {Level::beam3d, Level::axial_torsional})
  {
    Scene scene = hanging_pipe(linear_mass);
    scene.numerics.level = level;
    RigAtRest rig = build_at_rest(scene);
    release_pulse(rig, kind);
    const std::vector<double> places = {50.0, 90.0, 210.0, 260.0, 310.0};
    const std::vector<double> t = arrivals(rig, kind, places, 190.0 / expected);
    for (std::size_t k = 0; k < places.size(); ++k)
      EXPECT_NEAR(std::abs(places[k] - kCentre) / t[k], expected, 0.01 * expected) << places[k] << " m";
    EXPECT_NEAR((places[4] - places[2]) / (t[4] - t[2]), expected, 0.01 * expected);
  }
}
}  // namespace

// Lumped masses lag by (k h)^2/24 and BDF2 by (w dt)^2/3 with k = 1/width: together below 1e-3.
TEST(Waves, axialInPlainPipe)
{
  expect_speed(plain_pipe_mass, Kind::axial, std::sqrt(206e9 / steel_density));
}

TEST(Waves, axialSlowedByToolJoints)
{
  const double speed = std::sqrt(206e9 * pipe_area / tool_jointed_mass);
  EXPECT_NEAR(speed, 4700.0, 50.0) << "about 4.7 km/s";
  expect_speed(tool_jointed_mass, Kind::axial, speed);
}

TEST(Waves, torsionalInPlainPipe)
{
  expect_speed(plain_pipe_mass, Kind::torsional, std::sqrt(206e9 / 2.6 / steel_density));
}

TEST(Waves, torsionalSlowedByToolJoints)
{
  expect_speed(tool_jointed_mass, Kind::torsional, std::sqrt(206e9 / 2.6 * pipe_area / tool_jointed_mass));
}
}  // namespace test_solve_waves
