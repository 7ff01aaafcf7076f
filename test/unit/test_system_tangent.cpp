// The tangent of the whole system against finite differences of its residual, in every situation that has terms of its own.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "drill_rig_sim/math/rotation.h"
#include "drill_rig_sim/solve/start.h"
#include "drill_rig_sim/solve/stepper.h"
#include "test_scenes.h"

using namespace drill_rig_sim;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace
{
constexpr double kStep = 0.005;
constexpr double kDifference = 1e-6;  // [m, rad]: penetrations are some 1e-4, round-off of a place 1e-13

/// A rig in a situation, and how many nodes touch the wall in it.
struct Rig
{
  RigAtRest rest;
  Stepper stepper;
  Setpoints setpoints;

  explicit Rig(const Scene& scene) : rest(build_at_rest(scene)), stepper(*rest.system, find_method(IntegratorKind::automatic))
  {
    stepper.limits().tolerance = 1e-9;  // on the residual's solution, so that only the tangent is on trial
  }
  void run(double seconds)
  {
    for (int k = 0; k < std::lround(seconds / kStep); ++k) ASSERT_TRUE(stepper.advance(rest.state, kStep, setpoints));
  }
  int contacts() const
  {
    const auto& contact = rest.system->forces().contact;
    return static_cast<int>(std::count_if(contact.begin(), contact.end(), [](double f) { return f > 0.0; }));
  }
};

/// The step's tangent at increments u, as a dense matrix.
MatrixXd dense_tangent(System& system, const VectorXd& u)
{
  const int n = system.nodes();
  BlockTridiagonal t;
  t.resize(n);
  VectorXd residual(6 * n);
  system.evaluate(u.data(), residual.data(), &t);
  MatrixXd dense = MatrixXd::Zero(6 * n, 6 * n);
  for (int i = 0; i < n; ++i)
  {
    dense.block<6, 6>(6 * i, 6 * i) = t.diagonal(i);
    if (i + 1 == n) continue;
    dense.block<6, 6>(6 * i, 6 * i + 6) = t.upper(i);
    dense.block<6, 6>(6 * i + 6, 6 * i) = t.lower(i);
  }
  return dense;
}

/// Central difference, fourth order, so that the step can stay far above round-off.
VectorXd difference(System& system, const VectorXd& u, int column, double h)
{
  VectorXd out = VectorXd::Zero(u.size()), residual(u.size());
  const double at[4] = {-2.0, -1.0, 1.0, 2.0}, weight[4] = {1.0, -8.0, 8.0, -1.0};
  for (int k = 0; k < 4; ++k)
  {
    VectorXd moved = u;
    moved[column] += at[k] * h;
    system.evaluate(moved.data(), residual.data(), nullptr);
    out += weight[k] / (12.0 * h) * residual;
  }
  return out;
}

/// Largest relative error of a column, over all columns but those of the held top.
double worst_column(System& system, const VectorXd& u, double h)
{
  const MatrixXd tangent = dense_tangent(system, u);
  const int top = 6 * (system.nodes() - 1);
  double worst = 0.0;
  for (int c = 0; c < u.size(); ++c)
  {
    if (c >= top && c != top + 2 && c != top + 5) continue;
    const VectorXd reference = difference(system, u, c, h);
    worst = std::max(worst, (tangent.col(c) - reference).norm() / tangent.col(c).norm());
  }
  return worst;
}

/// The next step's increments as predicted; tilts are left out: rotations are exp(tilt) exp(spin n), and the tangent is that of
/// rotations about the place itself, the derivative wherever the step's tilt is zero.
VectorXd increments_without_tilt(Rig& rig)
{
  System& system = *rig.rest.system;
  system.begin(rig.rest.state, kStep, rig.setpoints);
  prepare_bdf2(rig.rest.state, kStep, system.stage());
  VectorXd u(6 * system.nodes());
  predict(rig.rest.state, kStep, u.data());
  for (int i = 0; i < system.nodes(); ++i)
  {
    const Vector3d n = x_axis(rig.rest.state.nodes[i].orientation);
    u.segment<3>(6 * i + 3) = n * n.dot(u.segment<3>(6 * i + 3));
  }
  return u;
}

void expect_exact(Rig& rig)
{
  const VectorXd u = increments_without_tilt(rig);
  EXPECT_LT(worst_column(*rig.rest.system, u, kDifference), 1e-6);
}

/// The bit's gauge clear of the hole: centred without clearance it stands on the contact's switch.
Scene drilling_clear()
{
  Scene scene = drilling_scene(0.002);
  scene.string[0].bit->diameter = 0.21;
  return scene;
}

/// Built evenly all the way.
Scene built()
{
  return scene_in(build_and_hold(0.0, 0.1 * degree, 40.0 * degree, 2.0, 400.0), 400.0, 300.0, 0.3);
}
}  // namespace

TEST(SystemTangent, hangingFreeAndTurning)
{
  Scene scene = vertical_scene(100.0, 60.0);
  scene.string[0].bit->diameter = 0.21;
  Rig rig(scene);
  rig.setpoints.top_drive.speed = 60.0 * rpm;
  rig.run(2.0);
  EXPECT_EQ(rig.contacts(), 0);
  expect_exact(rig);
}

TEST(SystemTangent, inContactAndSticking)
{
  Rig rig(slanted_scene(60.0, 0.5));
  rig.run(3.0);
  EXPECT_GT(rig.contacts(), 4);
  double slip = 0.0;
  for (const NodeState& node : rig.rest.state.nodes) slip = std::max(slip, node.rate.velocity.norm());
  EXPECT_LT(slip, 1e-3) << "is at rest";
  expect_exact(rig);
}

TEST(SystemTangent, inContactAndSlidingDown)
{
  Rig rig(slanted_scene(60.0, 0.3));
  rig.setpoints.winch = {-0.2, false};
  rig.run(3.0);
  EXPECT_GT(rig.contacts(), 4);
  expect_exact(rig);
}

TEST(SystemTangent, inContactSlidingAndTurningWithStribeckFriction)
{
  Scene scene = slanted_scene(60.0, 0.3);
  scene.contact.static_ratio = 1.3;
  scene.contact.stribeck_speed = 0.3;
  Rig rig(scene);
  rig.setpoints.winch = {-0.1, false};
  rig.setpoints.top_drive.speed = 20.0 * rpm;
  rig.run(6.0);
  EXPECT_GT(rig.contacts(), 4);
  expect_exact(rig);
}

TEST(SystemTangent, inACurvedHole)
{
  Rig rig(built());
  rig.setpoints.winch = {-0.2, false};
  rig.setpoints.top_drive.speed = 60.0 * rpm;
  rig.run(3.0);
  EXPECT_GT(rig.contacts(), 10);
  expect_exact(rig);
}

TEST(SystemTangent, drillingOnBottom)
{
  for (const BitTorqueModel model : {BitTorqueModel::stribeck, BitTorqueModel::detournay})
  {
    Scene scene = drilling_clear();
    scene.string[0].bit->torque.model = model;
    scene.formation[0].weight_exponent = 1.3;
    scene.formation[0].drillability = 3e-9;
    Rig rig(scene);
    rig.setpoints.top_drive.speed = 90.0 * rpm;
    rig.run(1.0);
    rig.setpoints.winch = {-0.012, false};
    rig.run(7.0);  // drills less than the bit is high: the hole about it stays wider than the gauge
    EXPECT_GT(rig.rest.system->forces().wob, 1000.0);
    expect_exact(rig);
  }
}

TEST(SystemTangent, bitStuckInTheRock)
{
  Rig rig(drilling_clear());
  rig.setpoints.winch = {-0.012, false};
  rig.run(5.0);
  EXPECT_GT(rig.rest.system->forces().wob, 1000.0);
  expect_exact(rig);
}

TEST(SystemTangent, motorTurningBehindABentHousing)
{
  Rig rig(motor_drilling_scene(0.002));
  rig.setpoints.top_drive.speed = 50.0 * rpm;
  rig.rest.state.flow = 0.03;
  rig.run(1.0);
  rig.setpoints.winch = {-0.012, false};
  rig.run(6.0);
  EXPECT_GT(rig.rest.state.bit.motor_speed, 1.0);
  EXPECT_GT(rig.contacts(), 0);
  expect_exact(rig);
}

TEST(SystemTangent, stuckPoint)
{
  Rig rig(slanted_scene(60.0, 0.3));
  rig.run(1.0);
  NodeState& held = rig.rest.state.nodes[3];
  rig.rest.state.stuck_point = {3, held.position, held.spin_angle};
  rig.setpoints.winch = {0.1, false};
  rig.setpoints.top_drive.speed = 30.0 * rpm;
  rig.run(1.5);
  expect_exact(rig);
}

TEST(SystemTangent, statics)
{
  for (const FrictionMode mode : {FrictionMode::none, FrictionMode::up, FrictionMode::rotate})
  {
    RigAtRest rig = build_at_rest(built());
    rig.system->begin_static(rig.state, mode);
    const VectorXd u = VectorXd::Zero(6 * rig.system->nodes());
    // both of the top's coordinates are held here
    const MatrixXd tangent = dense_tangent(*rig.system, u);
    for (int c = 0; c < u.size() - 6; ++c)
      EXPECT_LT((tangent.col(c) - difference(*rig.system, u, c, kDifference)).norm(), 1e-6 * tangent.col(c).norm())
          << "column " << c;
  }
}

// A motion given outright meets the same forces as the same motion through a stage, but for the rig's on the top node.
TEST(SystemTangent, aMotionGivenOutrightMeetsTheSameForces)
{
  Rig rig(slanted_scene(60.0, 0.3));
  rig.setpoints.winch = {-0.2, false};
  rig.run(3.0);
  System& system = *rig.rest.system;
  const SystemState& state = rig.rest.state;
  system.begin(state, kStep, rig.setpoints);
  prepare_start(state, system.stage());
  const int n = system.nodes();
  VectorXd by_stage(6 * n), outright(6 * n), contact(6 * n);
  const VectorXd u = VectorXd::Zero(6 * n);
  system.evaluate(u.data(), by_stage.data(), nullptr);
  GivenMotion motion;
  for (int i = 0; i < n; ++i)
  {
    const NodeState& node = state.nodes[i];
    motion.nodes.push_back({node.position, node.orientation, Vector6d::Zero(), in_step_axes(node.rate, x_axis(node.orientation))});
  }
  motion.time = kStep;
  motion.bit = motion.nodes.front();
  motion.motor_speed = state.bit.motor_speed;
  motion.motor_turn = kStep * state.bit.motor_speed;
  system.evaluate_motion(motion, outright.data(), contact.data(), nullptr, nullptr);
  outright += contact;
  const double scale = outright.head(6 * (n - 1)).cwiseAbs().maxCoeff();
  EXPECT_GT(scale, 100.0);
  // what a stage adds: the gyroscopic moment of tilting while turning, 1e-4 N m here
  EXPECT_LT((by_stage - outright).head(6 * (n - 1)).cwiseAbs().maxCoeff(), 1e-3);
}

// Within a step the tilt is small, and the tangent's error with it: the axis of spin leans by the tilt, so that the column of
// spin gets that share of the bending stiffness, 4 E I/(G J) = 4 (1 + nu) = 5.2 times the torsional one.
TEST(SystemTangent, errorGrowsNoFasterThanTheTiltOfTheStep)
{
  Rig rig(drilling_clear());
  rig.run(0.1);
  VectorXd u = increments_without_tilt(rig);
  std::mt19937 random(1);
  std::normal_distribution<double> g;
  const double tilt = 1e-4;
  for (int i = 0; i + 1 < rig.rest.system->nodes(); ++i)
  {
    const Vector3d n = x_axis(rig.rest.state.nodes[i].orientation);
    const Vector3d v(g(random), g(random), g(random));
    u.segment<3>(6 * i + 3) += tilt * (v - n * n.dot(v)).normalized();
  }
  EXPECT_LT(worst_column(*rig.rest.system, u, kDifference), 5.2 * tilt);
}

int main(int argc, char** argv)
{
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
