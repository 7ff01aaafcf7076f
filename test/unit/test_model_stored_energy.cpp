// SPDX-License-Identifier: BSD-3-Clause
// What a rig holds at an instant, each store by its formula with a number of its own: a balance over a long run would not miss a
// small one. And the sums of the accounts.
#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>

#include "drill_rig_sim/compared/rotation_vector_beam.h"
#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/model/energy.h"
#include "drill_rig_sim/model/energy_accounts.h"
#include "drill_rig_sim/model/forces/stuck_point.h"
#include "drill_rig_sim/solve/methods/method.h"
#include "lone_bit.h"

namespace test_model_stored_energy
{
using namespace drill_rig_sim;
using Eigen::Vector3d;

namespace
{
constexpr double friction = 0.3;  // of the wall [-]

StoredEnergy stored(const RigAtRest& rig)
{
  Stage stage(*rig.model);
  begin_step(*rig.model, rig.state, 0.0, Setpoints(), stage);
  prepare_start(rig.state, stage);
  stage.drive.rate_0 = rig.state.drive.speed;
  const std::vector<double> u(6 * static_cast<std::size_t>(rig.model->nodes()), 0.0);
  Workspace work(*rig.model);
  return stored_energy(*rig.model, rig.state, stage, u.data(), work);
}

RigAtRest rig_at_rest()
{
  Scene scene = lone_bit_scene();
  scene.well.sections[0].friction = friction;
  return build_at_rest(scene);
}

/// The bit's node pressed by so much into the wall on the east side [m].
void press(RigAtRest& rig, double depth)
{
  rig.state.nodes[0].position.x() = 0.5 * 0.2159 - rig.model->mesh().nodes[0].contact_radius + depth;
}
}  // namespace

// Mud goes along sideways, not along the hole; spin and tilt have each their inertia.
TEST(Stored, kineticEnergyOfEachMotion)
{
  RigAtRest rig = rig_at_rest();
  const StoredEnergy none = stored(rig);
  EXPECT_EQ(0.0, none.kinetic_all());
  const MeshNode& bit = rig.model->mesh().nodes[0];
  const double hole = 0.2159 * 0.2159, pipe = bit.diameter * bit.diameter;
  const double mud = bit.mud_inside + (hole + pipe) / (hole - pipe) * bit.mud_outside;
  ASSERT_GT(mud, 0.0);
  NodeRate& rate = rig.state.nodes[0].rate;
  rate.velocity = Vector3d(0.3, 0.4, 0.0);
  EXPECT_NEAR(0.5 * (bit.mass + mud) * 0.25, stored(rig).kinetic, 1e-9 * bit.mass);
  rate.velocity = Vector3d(0.0, 0.0, 0.5);
  EXPECT_NEAR(0.5 * bit.mass * 0.25, stored(rig).kinetic, 1e-9 * bit.mass);
  rate.velocity.setZero();
  rate.spin = 7.0;
  EXPECT_NEAR(0.5 * bit.spin_inertia * 49.0, stored(rig).turning, 1e-9);
  rate.spin = 0.0;
  rate.tilt = Vector3d(3.0, 0.0, 0.0);
  EXPECT_NEAR(0.5 * bit.tilt_inertia * 9.0, stored(rig).turning, 1e-9);
  EXPECT_EQ(0.0, stored(rig).kinetic);
}

// k delta^(5/2) / (5/2) in the wall, k_b z^2 / 2 in the bristle that sticks to it.
TEST(Stored, wallAndBristle)
{
  RigAtRest rig = rig_at_rest();
  EXPECT_EQ(0.0, stored(rig).wall + stored(rig).bristles);
  const WallLaw& contact = rig.model->contact(0);
  const double depth = 1e-3, normal = contact.law.stiffness * std::pow(depth, 1.5);
  press(rig, depth);
  EXPECT_NEAR(normal * depth / 2.5, stored(rig).wall, 1e-3 * normal * depth);
  const double stretch = 0.1 * friction * normal / contact.tangential_stiffness;  // far below slipping
  rig.state.nodes[0].bristle = Vector3d(0.0, 0.6 * stretch, 0.8 * stretch);
  const double expected = 0.5 * contact.tangential_stiffness * stretch * stretch;
  ASSERT_GT(expected, 0.0);
  EXPECT_NEAR(expected, stored(rig).bristles, 1e-3 * expected);
}

TEST(Stored, stuckPoint)
{
  RigAtRest rig = rig_at_rest();
  EXPECT_EQ(0.0, stored(rig).stuck_point);
  const double expected = 0.5 * stuck_point_stiffness * 25e-6 + 0.5 * stuck_point_torsion * 0.04;
  for (const int i : {0, 1})
  {
    rig.state.stuck_point = {i, rig.state.nodes[i].position - Vector3d(0.0, 3e-3, 4e-3), rig.state.nodes[i].spin_angle - 0.2};
    EXPECT_NEAR(expected, stored(rig).stuck_point, 1e-9 * expected) << i;
  }
}

// A pipe whose end turns in place sags by w L/12 (1 - cos) where the element has the end moments of its weight, and not at all
// elsewhere.
TEST(Stored, weightAtAnEndThatTurns)
{
  for (const ElementKind kind : {ElementKind::corotational, ElementKind::geometrically_exact, ElementKind::rotation_vector})
  {
    Scene scene = weightless(lone_bit_scene());
    scene.numerics.element = kind;
    scene.string[1].linear_mass = plain_pipe_mass;
    scene.mud.density = 0.0;
    RigAtRest rig = build_at_rest(scene);
    const MeshElement& pipe = rig.model->mesh().elements[0];
    const double length = pipe.section.length, weight = standard_gravity * pipe.linear_mass * length;
    const Eigen::Quaterniond plumb(ground_axes());
    rig.state.nodes[0].orientation = plumb;
    const double before = stored(rig).weight;
    rig.state.nodes[0].orientation = Eigen::AngleAxisd(0.3, Vector3d::UnitY()) * plumb;
    const double sunk = rig.model->beam().load_moments ? weight * length / 12.0 * (1.0 - std::cos(0.3)) : 0.0;
    EXPECT_NEAR(-sunk, stored(rig).weight - before, 1e-9 * weight * length) << rig.model->beam().name;
  }
}

// Strung line of length L_0 under the tension F = load / (2 n) holds F^2 L_0 / (2 E A); the drive J w^2 / 2, its meter k_m
// twist^2 / 2, what its brake holds 1e7 z^2 / 2.
TEST(Stored, lineAndDrive)
{
  RigAtRest rig = rig_at_rest();
  const HoistingSpec& hoisting = rig.model->scene().rig.hoisting;
  const double load = rig.statics.top_force + standard_gravity * hoisting.block_mass;
  const double tension = load / (2.0 * hoisting.sheaves),
               expected = 0.5 * tension * tension * rig.state.hoist.line_length / hoisting.line_ea;
  EXPECT_NEAR(expected, stored(rig).line, 1e-6 * expected);
  const TopDriveSpec& drive = rig.model->scene().rig.top_drive;
  rig.state.drive.speed = 3.0;
  EXPECT_NEAR(4.5 * drive.inertia, stored(rig).rotor, 1e-6 * drive.inertia);
  rig.state.drive.meter_twist = 2e-3;
  EXPECT_NEAR(2e-6 * drive.meter_stiffness, stored(rig).meter, 2e-12 * drive.meter_stiffness);
  rig.state.drive.speed = 0.0;
  rig.state.drive.meter_twist = 0.0;
  rig.state.drive.gear_twist = 1e-5;
  EXPECT_NEAR(5e-4, stored(rig).gear, 1e-9);
  rig.state.hoist.rail_deflection = 1e-4;
  EXPECT_NEAR(0.5 * rail_stiffness * 1e-8, stored(rig).block, 1e-9);
}

// Powers of two: a term that is missing, stands twice or has the wrong sign shows in the sum.
TEST(Accounts, addUpEveryTermOnce)
{
  EnergyAccounts e;
  EXPECT_EQ(0.0, e.closure());
  EXPECT_EQ(0.0, e.numerical_share());
  EXPECT_EQ(0.0, e.numerical_of_losses());
  double next = 1.0;
  const auto fill = [&next](std::initializer_list<double*> terms)
  {
    double sum = 0.0;
    for (double* term : terms)
    {
      *term = next;
      sum += next;
      next *= 2.0;
    }
    return sum;
  };
  const double input = fill({&e.winch, &e.drive, &e.pump, &e.gravity, &e.handled});
  StoredEnergy &now = e.last, &before = e.first;
  const double held = fill({&now.kinetic, &now.turning, &now.rotor, &now.beams, &now.line, &now.meter, &now.gear, &now.block,
                            &now.wall, &now.bottom, &now.bristles, &now.bit_bristle, &now.stuck_point}) -
                      fill({&before.kinetic, &before.beams});
  const double lost = fill({&e.wall_friction, &e.wall_damping, &e.bottom_damping, &e.squeeze_film, &e.mud, &e.structural,
                            &e.block, &e.gearbox, &e.motor_slip, &e.stuck_point_released, &e.ledge, &e.added_mass});
  const double rock = fill({&e.rock_thrust, &e.rock_torque}), correction = fill({&e.correction});
  const double numerical = fill({&e.of_inertia, &e.of_beams, &e.of_contact, &e.of_line, &e.of_residual, &e.of_rebasing});
  now.weight = before.weight = 1e20;  // no store of its own
  EXPECT_EQ(input, e.input());
  EXPECT_EQ(held, e.stored());
  EXPECT_EQ(lost, e.dissipated());
  EXPECT_EQ(rock, e.broken_rock());
  EXPECT_EQ(numerical, e.numerical());
  EXPECT_EQ(input - held - lost - rock - correction - numerical, e.residual());
  EXPECT_EQ(input, e.throughput());
  e.drive = -e.drive;
  EXPECT_EQ(input, e.throughput()) << "magnitudes";
  e.drive = -e.drive;
  for (double* loss : {&e.mud, &e.wall_damping, &e.rock_torque}) *loss = -*loss;
  EXPECT_EQ(lost + rock, e.loss_magnitudes());
  for (double* loss : {&e.mud, &e.wall_damping, &e.rock_torque}) *loss = -*loss;
  EXPECT_EQ(std::abs(e.residual()) / input, e.closure());
  EXPECT_EQ(numerical / input, e.numerical_share());
  EXPECT_EQ(numerical / (lost + rock + numerical), e.numerical_of_losses());
  e.largest_kinetic = 2.0 * input;
  EXPECT_EQ(2.0 * input, e.throughput());
}
}  // namespace test_model_stored_energy
