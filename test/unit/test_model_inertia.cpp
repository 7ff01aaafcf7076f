// SPDX-License-Identifier: BSD-3-Clause
// Inertia of the string's sections: whirl of a spinning rotor, frequency of tilting, kinetic energy by hand.
#include <gtest/gtest.h>

#include <cmath>

#include "drill_rig_sim/math/rotation.h"
#include "drill_rig_sim/model/energy.h"
#include "drill_rig_sim/sim/integrator_table.h"
#include "drill_rig_sim/solve/stepper.h"
#include "lone_bit.h"

namespace test_model_inertia
{
using namespace drill_rig_sim;
using Eigen::Vector3d;

namespace
{
constexpr double step = 0.0005;  // [s]

/// A rotor on the pipe's lower end that can tilt and spin, but not move: its mass is beyond measure, too. `stiffness`: of the
/// pipe against the tilting of that end [N m/rad].
struct Rotor
{
  double spin_inertia, tilt_inertia, stiffness = 0.0;
  RigAtRest rig;

  Rotor(double spin, double tilt, double young_modulus)
      : spin_inertia(spin),
        tilt_inertia(tilt),
        rig(lone_bit(scene_of(young_modulus),
                     [&](MeshNode& bit, BeamSection& pipe)
                     {
                       bit.mass = 1e12;
                       bit.spin_inertia = spin;
                       bit.tilt_inertia = tilt;
                       stiffness = pipe.bending_near;
                     }))
  {
  }

  static Scene scene_of(double young_modulus)
  {
    Scene scene = weightless(lone_bit_scene());
    scene.string[1].young_modulus = young_modulus;
    return scene;
  }

  /// The two whirl speeds of the spinning rotor, forward first: tilt_inertia l^2 - spin_inertia spin l - stiffness = 0.
  std::pair<double, double> whirl(double spin) const
  {
    const double half = 0.5 * spin_inertia * spin / tilt_inertia, root = std::sqrt(half * half + stiffness / tilt_inertia);
    return {half + root, half - root};
  }
};

/// Where the rotor's axis points, off the vertical: angle about it, clockwise looking down, and size.
std::pair<double, double> lean_of(const State& state)
{
  const Vector3d n = x_axis(state.nodes[0].orientation);
  return {std::atan2(-n.y(), n.x()), std::hypot(n.x(), n.y())};
}

/// Spins all at `spin`, starts the rotor's axis on a circle at whirl speed `whirl`, and expects it to stay on it for a second.
void expect_whirl(const Rotor& rotor, IntegratorKind kind, double spin, double whirl, double tolerance)
{
  const Vector3d down = -Vector3d::UnitZ();
  const Vector3d tilt = 1e-3 * Vector3d::UnitX();
  State state = rotor.rig.state;
  for (NodeState& node : state.nodes) node.rate.spin = spin;
  state.drive.speed = spin;
  NodeState& bit = state.nodes[0];
  bit.orientation = rotation_from_vector(tilt) * bit.orientation;
  bit.rate.tilt = whirl * down.cross(tilt);  // the tilt turns clockwise
  Setpoints setpoints;
  setpoints.top_drive.speed = spin;
  const auto [start, lean] = lean_of(state);
  double turned = 0.0, last = start;
  Stepper stepper(rotor.rig.model, find_method(kind));
  stepper.limits().tolerance = 1e-12;
  for (int k = 0; k < 2000; ++k)
  {
    ASSERT_TRUE(stepper.advance(state, step, setpoints));
    const auto [angle, size] = lean_of(state);
    turned += std::remainder(angle - last, 2.0 * pi);
    last = angle;
    ASSERT_NEAR(size, lean, tolerance * lean) << find_integrator(kind).name << ", spin " << spin << ", after " << k << " steps";
  }
  EXPECT_NEAR(turned, whirl, tolerance * std::abs(whirl)) << find_integrator(kind).name << ", spin " << spin;
}

constexpr IntegratorKind methods[] = {IntegratorKind::bdf2, IntegratorKind::trbdf2, IntegratorKind::generalised_alpha};
}  // namespace

// Without stiffness the fast whirl is the free precession, spin_inertia/tilt_inertia times the spin, in the sense of the spin.
// Bound: the methods' own error, (l h)^2/3 of the angle and less of the size, 2e-5; the pipe's bending, of order
// stiffness/(spin_inertia spin^2) 1e-4.
TEST(Gyroscope, freeRotorPrecessesBySpinInertiaOverTiltInertia)
{
  for (const double ratio : {0.5, 1.0, 1.8})
  {
    const Rotor rotor(ratio * 1000.0, 1000.0, 1e6);
    for (const double spin : {12.0, -8.0})
      for (const IntegratorKind kind : methods) expect_whirl(rotor, kind, spin, ratio * spin, 1e-3);
  }
}

// On a stiff pipe forward and backward whirl split by spin_inertia spin/tilt_inertia; their product stays stiffness/tilt_inertia.
TEST(Gyroscope, spinSplitsForwardAndBackwardWhirl)
{
  const Rotor rotor(1500.0, 1000.0, 206e9);
  for (const double spin : {0.0, 5.0, 15.0})
  {
    const auto [forward, backward] = rotor.whirl(spin);
    EXPECT_NEAR(forward + backward, 1.5 * spin, 1e-9);
    for (const IntegratorKind kind : methods)
    {
      expect_whirl(rotor, kind, spin, forward, 1e-3);
      expect_whirl(rotor, kind, spin, backward, 1e-3);
    }
  }
}

// The tangent holds the gyroscopic terms: central differences of the bit's six rows, of which some 1e-9 are round-off.
TEST(Gyroscope, tangentIsTheDerivativeOfTheMoment)
{
  const Rotor rotor(1500.0, 1000.0, 206e9);
  const Model& model = *rotor.rig.model;
  State state = rotor.rig.state;
  state.nodes[0].rate = {Vector3d(0.1, -0.2, 0.3), Vector3d(0.4, -0.5, 0.0), 15.0};
  Stage stage(model);
  Workspace work(model);
  begin_step(model, state, 0.01, Setpoints(), stage);
  prepare_implicit_euler(state, 0.01, stage);
  BlockTridiagonal tangent;
  tangent.resize(model.nodes());
  Eigen::VectorXd u = Eigen::VectorXd::Zero(6 * model.nodes()), above(u), below(u), residual(u);
  u[5] = -0.15;  // spins on
  evaluate(model, state, stage, u.data(), work, residual.data(), &tangent);
  const double scale = rotor.spin_inertia * 15.0 / 0.01;  // [N m/rad]
  for (int k = 3; k < 6; ++k)
  {
    constexpr double d = 1e-6;
    Eigen::VectorXd moved = u;
    moved[k] += d;
    evaluate(model, state, stage, moved.data(), work, above.data(), nullptr);
    moved[k] -= 2.0 * d;
    evaluate(model, state, stage, moved.data(), work, below.data(), nullptr);
    for (int row = 3; row < 6; ++row)
      EXPECT_NEAR(tangent.diagonal(0)(row, k), (above[row] - below[row]) / (2.0 * d), 1e-6 * scale) << row << ", " << k;
  }
}

// Nodes that move, tilt and spin at given rates, below and above the rotary table: mass along the string, mass and added mass of
// mud across it, tilt and spin each with its inertia; above the table no mud moves along.
TEST(KineticEnergy, isThatOfMassAndInertiaByHand)
{
  RigAtRest rig = build_at_rest(drilling_scene(5.0));
  const Mesh& mesh = rig.model->mesh();
  double translation = 0.0, rotation = 0.0;
  int above = 0;
  for (int i = 0; i + 1 < rig.model->nodes(); ++i)
  {
    const double along = 0.3 + 0.01 * i, east = 0.2 - 0.02 * i, north = -0.1;
    const double tilt_east = 0.05 * i, tilt_north = 0.4, spin = 3.0 - 0.2 * i;
    rig.state.nodes[i].rate = {Vector3d(east, north, -along), Vector3d(tilt_east, tilt_north, 0.0), spin};
    const bool in_air = rig.state.nodes[i].position.z() > 0.0;
    above += in_air;
    const double hole = 0.2159 * 0.2159, body = mesh.nodes[i].diameter * mesh.nodes[i].diameter;
    const double mud = mesh.nodes[i].mud_inside + (hole + body) / (hole - body) * mesh.nodes[i].mud_outside;
    const double sideways = mesh.nodes[i].mass + (in_air ? 0.0 : mud);
    translation += 0.5 * mesh.nodes[i].mass * along * along + 0.5 * sideways * (east * east + north * north);
    rotation += 0.5 * mesh.nodes[i].tilt_inertia * (tilt_east * tilt_east + tilt_north * tilt_north);
    rotation += 0.5 * mesh.nodes[i].spin_inertia * spin * spin;
  }
  ASSERT_GT(above, 0);
  const int top = rig.model->top();
  rig.state.nodes[top].rate.velocity.z() = 0.7;
  translation += 0.5 * (mesh.nodes[top].mass + rig.model->scene().rig.hoisting.block_mass) * 0.7 * 0.7;
  rig.state.drive.speed = 5.0;

  Stage stage(*rig.model);
  Workspace work(*rig.model);
  begin_step(*rig.model, rig.state, 0.0, Setpoints(), stage);
  prepare_start(rig.state, stage);
  stage.drive.rate_0 = rig.state.drive.speed;
  const std::vector<double> u(6 * rig.model->nodes(), 0.0);
  const StoredEnergy energy = stored_energy(*rig.model, rig.state, stage, u.data(), work);
  EXPECT_NEAR(energy.kinetic, translation, 1e-6 * translation);  // the string is not quite vertical at rest
  EXPECT_NEAR(energy.turning, rotation, 1e-6 * rotation);
  EXPECT_NEAR(energy.rotor, 0.5 * 2500.0 * 25.0, 1e-6 * energy.rotor);
}
}  // namespace test_model_inertia
