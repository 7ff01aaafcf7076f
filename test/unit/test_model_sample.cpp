// SPDX-License-Identifier: BSD-3-Clause
// The forces of a rig in which everything acts, told apart in three ways: by account, by stage and as a motion given outright.
// They must be the same.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "drill_rig_sim/math/rotation.h"
#include "drill_rig_sim/model/energy.h"
#include "drill_rig_sim/model/evaluate.h"
#include "drill_rig_sim/model/forces/beams.h"
#include "drill_rig_sim/model/forces/inertia.h"
#include "drill_rig_sim/model/forces/top_drive.h"
#include "drill_rig_sim/solve/methods/method.h"
#include "drill_rig_sim/solve/start.h"
#include "test_scenes.h"

namespace test_model_sample
{
using namespace drill_rig_sim;
using Eigen::Vector3d;

namespace
{
constexpr double step = 0.01;  // [s]

/// A bent motor that drills in an inclined hole, its string held fast at `stuck`; all nodes move, and those in the hole are
/// pushed into the low side. Elements whose weight acts at their ends alone, so that it is known by hand.
struct Drilling
{
  RigAtRest rig;
  Stage stage;
  Workspace work;
  std::vector<double> u;
  EnergySample sample;

  explicit Drilling(int stuck, bool tilting = true)
      : rig(placed()), stage(*rig.model), work(*rig.model), u(6 * rig.model->nodes(), 0.0)
  {
    State& state = rig.state;
    state.flow = 0.03;
    state.bit.motor_speed = 6.0;
    state.bit.twist = 1e-3;
    state.drive.speed = 3.0;
    state.drive.meter_twist += 1e-3;
    for (std::size_t i = 0; i < state.nodes.size(); ++i)
    {
      const double k = static_cast<double>(i);
      NodeState& node = state.nodes[i];
      const Vector3d n = x_axis(node.orientation);
      node.position.z() -= 3e-3 + 1e-4 * std::sin(k);
      const Vector3d tilt(0.02 * std::sin(3.0 * k), 0.03 * std::cos(k), 0.01);
      node.rate = {Vector3d(0.01 * std::cos(k), 0.02 * std::sin(k), -0.1), tilt - n * n.dot(tilt), 5.0 + std::sin(k)};
      node.bristle = 1e-5 * Vector3d(std::sin(k), 1.0, std::cos(k));
      if (i < state.spans.size()) state.spans[i].bristle = 1e-5 * Vector3d(1.0, std::cos(k), std::sin(k));
    }
    state.stuck_point = {stuck, state.nodes[stuck].position - Vector3d(1e-3, 2e-3, 3e-3), state.nodes[stuck].spin_angle - 0.01};
    Setpoints setpoints;
    setpoints.top_drive.speed = 4.0;
    setpoints.winch = {-0.05, false};
    begin_step(*rig.model, state, step, setpoints, stage);
    prepare_implicit_euler(state, step, stage);
    predict(state, step, u.data());
    for (std::size_t i = 0; i < state.nodes.size() && !tilting; ++i)
    {
      Eigen::Map<Vector3d> turn(u.data() + 6 * i + 3);
      turn = stage.normal[i] * stage.normal[i].dot(turn);
    }
    sample_energy(*rig.model, state, stage, u.data(), work, sample);
  }
  static RigAtRest placed()
  {
    RigAtRest rig = build_at_rest(scene());
    Scene scene = rig.model->scene();
    scene.numerics.element = ElementKind::rotation_vector;
    scene.well.hole_depth = bit_depth(*rig.model, rig.state) - 1e-3;  // the bit stands a millimetre in it
    rig.state.well = Wellbore(scene.well, scene.trajectory, rig.model->mesh().bit_radius);
    rig.model = std::make_shared<Model>(scene, rig.model->mesh());
    return rig;
  }
  static Scene scene()
  {
    Scene scene = scene_in({{0.0, 20.0 * degree, 1.0}, {200.0, 20.0 * degree, 1.0}}, 150.0, 149.0, 0.3);
    scene.string.insert(scene.string.begin() + 1, motor_part());
    scene.string[0].bit->squeeze_film_damping = 3000.0;
    scene.string[0].bit->gauge_length = 0.15;
    scene.contact.law.damping = 0.3;
    scene.string.back().pipe->tool_joint_diameter = 0.0;  // so that it touches between the nodes too
    return scene;
  }
  const Model& model() const { return *rig.model; }
  Vector6d part(NodeForce kind, int i) const
  {
    return Eigen::Map<const Vector6d>(sample.force[static_cast<std::size_t>(kind)].data() + 6 * i);
  }
  /// Of the elements, the bit and the block, as a force [N].
  Vector3d weight_of_elements(int i) const
  {
    Vector3d load = Vector3d::Zero();
    if (i > 0) load += 0.5 * stage.load[i - 1];
    if (i < model().top()) load += 0.5 * stage.load[i];
    return load;
  }
  Vector3d weight_of_bit() const
  {
    const Mesh& mesh = model().mesh();
    return Vector3d(0.0, 0.0, -standard_gravity * (mesh.bit_mass - model().scene().mud.density * mesh.bit_displaced));
  }
  /// What contacts, rock, film and stuck point want on a node; without the bit's weight.
  Vector6d contact(int i) const
  {
    Vector6d out = part(NodeForce::wall, i) + part(NodeForce::wall_damping, i) + part(NodeForce::friction, i) +
                   part(NodeForce::ledge, i) + part(NodeForce::squeeze_film, i) + part(NodeForce::stuck_point, i);
    if (i > 0) return out;
    out.head<3>() += sample.bottom + sample.bottom_damping;
    out.tail<3>() += sample.bit_torque * work.nodes[0].axis;
    return out;
  }
  Vector6d string(int i) const
  {
    Vector6d out = part(NodeForce::beams, i) + part(NodeForce::structural, i) + part(NodeForce::mud, i);
    out.head<3>() -= weight_of_elements(i);
    return out;
  }
};
}  // namespace

// Each force has its account, and weight, line and drive theirs: nothing is counted that does not act, nothing acts that is not
// counted.
TEST(Sample, itsPartsAddUpToTheResidual)
{
  for (const int stuck : {0, 3})
  {
    const Drilling d(stuck);
    int touching = 0, between = 0;
    for (const SpanMotion& span : d.work.spans) between += span.touches;
    EXPECT_GT(between, 5);
    double friction = 0.0, damping = 0.0;  // [N]
    for (int i = 0; i < d.model().nodes(); ++i)
    {
      const NodeMotion& node = d.work.nodes[i];
      touching += node.touches;
      friction += d.part(NodeForce::friction, i).head<3>().norm();
      damping += d.part(NodeForce::wall_damping, i).norm();
      Vector6d sum = d.contact(i) + d.string(i) + d.part(NodeForce::inertia, i);
      // the gyroscopic moment does no work and is in no account
      const Vector3d w = node.rate.tail<3>();
      sum.tail<3>() += node_body(d.model(), d.stage, i).spin_inertia * w.dot(node.axis) * w.cross(node.axis);
      if (i == 0) sum.head<3>() -= d.weight_of_bit();
      if (i == d.model().top())
      {
        sum[2] += standard_gravity * d.model().scene().rig.hoisting.block_mass - d.sample.hook_force - d.sample.line_damping -
                  d.sample.block_resistance;
        sum[5] += d.model().scene().rig.top_drive.meter_stiffness *
                  (d.rig.state.drive.meter_twist + d.sample.rotor_increment - node.spin);
        for (const int k : {0, 1, 3, 4}) sum[k] = 0.0;
      }
      const Vector6d residual = d.part(NodeForce::unsolved, i);
      EXPECT_LT((residual - sum).norm(), 1e-7 * (1e4 + residual.norm())) << i << ", stuck at " << stuck;
      EXPECT_EQ(d.part(NodeForce::stuck_point, i).norm() > 0.0, i == stuck) << i;
    }
    EXPECT_GT(touching, 5);
    EXPECT_GT(friction, 100.0);
    EXPECT_GT(damping, 100.0);
    EXPECT_GT(d.part(NodeForce::structural, 2).norm(), 0.1);
    EXPECT_GT(d.part(NodeForce::squeeze_film, 0).norm(), 1.0);
  }
}

// J w' = T_motor + friction - T_meter; the rotor's rates are those of its increment; what the rig does is what its forces say.
TEST(Sample, rigAndBitAreThoseOfTheStep)
{
  const Drilling d(3);
  const EnergySample& s = d.sample;
  const Scene& scene = d.model().scene();
  const RigForces& forces = d.work.result.forces;
  EXPECT_NEAR(s.rotor_inertia, s.drive_torque + s.gear_friction - forces.meter_torque, 1e-6 * std::abs(s.drive_torque));
  EXPECT_NEAR(s.rotor_speed, s.rotor_increment / step, 1e-9);
  EXPECT_EQ(s.rotor_increment, drive_increment(d.model(), d.rig.state, d.stage, d.u.data() + 6 * d.model().top()));
  EXPECT_EQ(s.hook_force + s.line_damping, forces.hook_load);
  EXPECT_GT(std::abs(s.line_damping), 100.0);
  EXPECT_EQ(s.winch_speed, d.stage.hoist.winch_speed);
  EXPECT_EQ(s.block_resistance, forces.block_resistance);
  EXPECT_EQ(s.step, step);
  const double tension = s.hook_force / 10.0;  // of ten lines
  EXPECT_NEAR(s.line_price, tension + tension * tension / (2.0 * scene.rig.hoisting.line_ea), 1e-6 * tension);
  EXPECT_NEAR(s.line_paid_out, d.stage.hoist.line_length - d.rig.state.hoist.line_length, 1e-12);
  // stretched line runs at ten times the block's speed
  const double speed = d.stage.hoist.winch_speed;
  ASSERT_LT(speed, -1e-4);
  EXPECT_NEAR(s.pay_out, -10.0 * speed / (1.0 + tension / scene.rig.hoisting.line_ea), 1e-6 * std::abs(speed));
  EXPECT_NEAR(s.bit_speed, d.work.nodes[0].rate.tail<3>().dot(d.work.nodes[0].axis) + 6.0, 1e-12);
  EXPECT_EQ(s.motor_speed, 6.0);
  EXPECT_NEAR(s.motor_flow_speed, 2.0 * pi * 0.03 / 0.024, 1e-12);
  EXPECT_NEAR(s.bottom_elastic + s.bottom_damped, forces.wob, 1e-9 * forces.wob);
  ASSERT_GT(forces.wob, 1e3);
  for (int i = 0; i < d.model().nodes(); ++i)
    EXPECT_LT((Eigen::Map<const Vector6d>(s.rate.data() + 6 * i) - Eigen::Map<const Vector6d>(s.increment.data() + 6 * i) / step)
                  .norm(),
              1e-9)
        << i;
}

// At the same places and rates, by any integrator: the string's forces, and those at its contacts, the bit's as a body of
// its own.
TEST(Sample, aMotionGivenOutrightMeetsTheSameForces)
{
  const Drilling d(3, false);  // where nothing has tilted the section's old axis is its present one
  GivenMotion motion;
  for (const NodeMotion& node : d.work.nodes)
    motion.nodes.push_back({node.position, node.orientation, node.increment, node.rate});
  motion.bit = motion.nodes[0];
  Workspace work(d.model());
  const std::size_t n = d.u.size();
  std::vector<double> string(n, 1.0), contact(n, 1.0);
  evaluate_motion(d.model(), d.rig.state, d.stage, motion, work, string.data(), contact.data(), nullptr, nullptr);
  for (int i = 0; i < d.model().top(); ++i)
  {
    Vector6d expected = d.contact(i) + d.string(i);
    if (i == 0) expected.head<3>() -= d.weight_of_bit();
    const Vector6d both = Eigen::Map<const Vector6d>(contact.data() + 6 * i) + Eigen::Map<const Vector6d>(string.data() + 6 * i);
    EXPECT_LT((both - expected).norm(), 1e-7 * (1e5 + expected.norm())) << i;
  }
  Workspace again(d.model());
  const Vector6d alone = evaluate_bit_motion(d.model(), d.rig.state, d.stage, motion.bit, again);
  EXPECT_LT((alone - Eigen::Map<const Vector6d>(contact.data())).norm(), 1e-9 * alone.norm());
  EXPECT_EQ(work.work.residuals, 1u);
  EXPECT_EQ(work.work.tangents, 0u);
  EXPECT_EQ(work.result.forces.bit_torque, d.work.result.forces.bit_torque);
}

// Below the bend the section points elsewhere: moment is torque about its axis and bending across it, nothing is in both.
TEST(Sample, bendingMomentsAreAcrossTheBentSection)
{
  const Drilling d(3);
  Workspace work(d.model());
  std::vector<double> residual(d.u.size());
  evaluate(d.model(), d.rig.state, d.stage, d.u.data(), work, residual.data(), nullptr);
  find_string_forces(d.model(), d.rig.state, d.stage, work);
  int bends = 0;
  for (int e = 0; e < d.model().elements(); ++e)
  {
    const MeshElement& element = d.model().mesh().elements[e];
    const BeamForces f = element_forces({d.model(), d.rig.state, d.stage, work}, e);
    const NodeMotion& upper = work.nodes[e + 1];
    const Vector3d axis = (upper.orientation * element.upper_end) * Vector3d::UnitX();
    const double bending = f.moment_upper.cross(axis).norm();
    EXPECT_NEAR(work.result.forces.bending_moment[e + 1], bending, 1e-9 * (1.0 + bending)) << e;
    EXPECT_EQ(work.result.forces.torque[e], -f.torque) << e;
    EXPECT_EQ(work.result.forces.tension[e], f.tension) << e;
    if (element.bend == 0.0) continue;
    ++bends;
    EXPECT_GT(std::abs(f.moment_upper.cross(upper.normal).norm() - bending), 1e-3) << "with the node's own axis it is another";
  }
  EXPECT_EQ(bends, 1);
}
}  // namespace test_model_sample
