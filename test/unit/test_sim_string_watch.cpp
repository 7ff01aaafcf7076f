// SPDX-License-Identifier: BSD-3-Clause
// What the string's pipe bears: stress, connections, buckling, each by hand.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/sim/simulator.h"
#include "drill_rig_sim/sim/string_watch.h"
#include "drill_rig_sim/solve/start.h"
#include "test_scenes.h"

namespace test_sim_string_watch
{
using namespace drill_rig_sim;

namespace
{
constexpr std::size_t watched = 8;  // an element of drill pipe

/// No load but what a test puts in.
RigForces unloaded(const Model& model)
{
  RigForces forces;
  forces.tension.assign(model.mesh().elements.size(), 0.0);
  forces.torque = forces.tension;
  forces.bending_moment.assign(model.mesh().nodes.size(), 0.0);
  return forces;
}

double middle(const Mesh& mesh, std::size_t e)
{
  return 0.5 * (mesh.nodes[e].from_bit + mesh.nodes[e + 1].from_bit);
}
}  // namespace

// 5 in x 4.276 in: A = 3.404e-3 m2, W = 9.358e-5 m3, W_t twice that. 500 kN: 146.9 MPa; 10 kN m of bending: 106.9 MPa; 30 kN m of
// torque: 160.3 MPa; together sqrt(253.7^2 + 3 * 160.3^2) = 376.1 MPa of 724.
TEST(StringWatch, stressByHand)
{
  const RigAtRest rig = build_at_rest(vertical_scene(400.0, 290.0));
  const Mesh& mesh = rig.model->mesh();
  ASSERT_DOUBLE_EQ(rig.model->scene().string[static_cast<std::size_t>(mesh.elements[watched].part)].outer_diameter, 0.127);
  const StringWatch watch(*rig.model);
  RigForces forces = unloaded(*rig.model);
  EXPECT_EQ(watch.look(*rig.model, rig.state, forces).stress.share, 0.0);
  for (const double sign : {1.0, -1.0})
  {
    forces.tension[watched] = 500e3 * sign;
    forces.torque[watched] = -30e3 * sign;
    forces.bending_moment[watched + 1] = 10e3;
    const StringLoads loads = watch.look(*rig.model, rig.state, forces);
    EXPECT_NEAR(loads.stress.share, 376.1e6 / 724e6, 1e-3);
    EXPECT_EQ(loads.stress.from_bit, middle(mesh, watched));
    EXPECT_EQ(loads.torque.share, 0.0) << "not known";
  }
}

// The pipe of above: A Y = 3.404e-3 * 724e6 = 2465 kN. Without a load it bears that. With the loads of above in tension it bears
// A (sqrt(724^2 - 3 * 160.3^2) - 106.9) MPa = 1914 kN, of which 500 kN hang on it; compressed by them, 500 kN more than that.
TEST(StringWatch, pullToYieldByHand)
{
  const RigAtRest rig = build_at_rest(vertical_scene(400.0, 290.0));
  const StringWatch watch(*rig.model);
  RigForces forces = unloaded(*rig.model);
  EXPECT_NEAR(watch.look(*rig.model, rig.state, forces).pull_to_yield, 2465e3, 2e3) << "of the weakest";
  forces.torque[watched] = 30e3;
  forces.bending_moment[watched + 1] = 10e3;
  for (const double tension : {500e3, -500e3, 1914e3, 2000e3})
  {
    forces.tension[watched] = tension;
    const double wanted = std::min(1914e3 - tension, 2101e3);  // the moment bends the element above too: 724 MPa less 106.9
    EXPECT_NEAR(watch.look(*rig.model, rig.state, forces).pull_to_yield, wanted, 2e3) << tension;
  }
  forces.torque[watched] = 200e3;
  EXPECT_LT(watch.look(*rig.model, rig.state, forces).pull_to_yield, -2000e3) << "torque alone makes it yield";
}

TEST(StringWatch, connectionsByTheirMakeUpTorque)
{
  Scene scene = vertical_scene(400.0, 290.0);
  for (PartSpec& part : scene.string) part.make_up_torque = 41e3;
  const RigAtRest rig = build_at_rest(scene);
  RigForces forces = unloaded(*rig.model);
  forces.torque[watched] = -42e3;
  const LoadShare torque = StringWatch(*rig.model).look(*rig.model, rig.state, forces).torque;
  EXPECT_DOUBLE_EQ(torque.share, 42.0 / 41.0);
  EXPECT_EQ(torque.from_bit, middle(rig.model->mesh(), watched));
}

// E I = 206e9 * 5.942e-6 = 1.2241e6 N m2. Vertical: w in mud of the scene; inclined by 20 deg in a hole of 0.2159 m: the
// clearance is 44.45 mm.
TEST(StringWatch, bucklingOfAVerticalAndOfAnInclinedHole)
{
  const double stiffness = 206e9 * pi / 64.0 * (std::pow(0.127, 4) - std::pow(0.1086, 4));
  for (const bool inclined : {false, true})
  {
    const Scene scene = inclined ? slanted_scene(199.98, 0.2) : vertical_scene(400.0, 290.0);
    const RigAtRest rig = build_at_rest(scene);
    const Mesh& mesh = rig.model->mesh();
    const PartSpec& pipe = scene.string[static_cast<std::size_t>(mesh.elements[watched].part)];
    const double weight = standard_gravity * pipe.linear_mass * (1.0 - scene.mud.density / pipe.density);
    const double load = inclined ? 2.0 * std::sqrt(stiffness * weight * std::sin(20.0 * degree) / 0.04445)
                                 : 1.94 * std::cbrt(stiffness * weight * weight);
    RigForces forces = unloaded(*rig.model);
    forces.tension[watched] = -load;
    const LoadShare buckling = StringWatch(*rig.model).look(*rig.model, rig.state, forces).buckling;
    EXPECT_NEAR(buckling.share, 1.0, 2e-3) << inclined;
    EXPECT_EQ(buckling.from_bit, middle(mesh, watched));
    forces.tension[watched] = load;
    EXPECT_EQ(StringWatch(*rig.model).look(*rig.model, rig.state, forces).buckling.share, 0.0) << "pulled";
    // in the mast nothing of this holds
    forces.tension[watched] = 0.0;
    forces.tension.back() = -10.0 * load;
    EXPECT_EQ(StringWatch(*rig.model).look(*rig.model, rig.state, forces).buckling.share, 0.0);
  }
}

// Bends press compressed pipe outwards: down in a build, where the load itself holds the pipe, and up in a drop. At 200 kN, 10
// deg/30 m and 30 deg of inclination: w sin I 137 N/m, F k 1164 N/m.
TEST(StringWatch, bucklingWhereTheHoleBends)
{
  const double stiffness = 206e9 * pi / 64.0 * (std::pow(0.127, 4) - std::pow(0.1086, 4)), rate = 10.0 * degree / 30.0,
               force = 200e3;
  for (const double sign : {1.0, -1.0, 0.0})
  {
    std::vector<SurveyStation> survey;  // 0: at the same rate by azimuth alone
    for (int i = -2; i <= 2; ++i)
      survey.push_back({60.0 + 30.0 * i, 30.0 * degree + sign * 30.0 * i * rate,
                        sign == 0.0 ? 30.0 * i * rate / std::sin(30.0 * degree) : 0.5});
    Scene scene = scene_in(survey, 120.0, 119.0, 0.0);
    scene.numerics.element_length = 4.75;
    const RigAtRest rig = build_at_rest(scene);
    const Mesh& mesh = rig.model->mesh();
    std::size_t e = 0;
    while (rig.state.nodes[e].position.z() < 0.0 && 119.0 - mesh.middle(e) > 60.0) ++e;  // where it inclines by 30 deg
    const double inclination = 30.0 * degree + sign * rate * (119.0 - mesh.middle(e) - 60.0);
    const PartSpec& pipe = scene.string[1];
    const double weight = standard_gravity * pipe.linear_mass * (1.0 - scene.mud.density / pipe.density) * std::sin(inclination);
    const double pressed = sign == 0.0 ? std::hypot(weight, force * rate) : std::abs(weight + sign * force * rate);
    EXPECT_NEAR(buckling_share(*rig.model, rig.state, e, -force), force / (2.0 * std::sqrt(stiffness * pressed / 0.04445)), 0.005)
        << sign;
  }
}

// Set down on bottom with all that it weighs, the pipe buckles; hanging it did not. Over-pulled, it yields.
TEST(StringWatch, theTruthTellsAndTheReadingsDoNot)
{
  Scene scene = vertical_scene(400.0, 399.0);
  Simulator rig(scene);
  const auto play = [&rig](double seconds)
  {
    for (int k = 0; k < std::lround(seconds / 0.01); ++k) ASSERT_EQ(rig.frame(0.01), FrameStatus::running) << rig.failure();
  };
  play(0.1);
  EXPECT_FALSE(rig.truth().buckled);
  EXPECT_FALSE(rig.truth().over_stress);
  rig.command(WinchSetpoint{-0.5, false});
  play(12.0);
  EXPECT_TRUE(rig.truth().buckled);

  for (PartSpec& part : scene.string) part.yield_strength = 100e6;
  scene.rig.hoisting.max_hook_load = 4e6;
  Simulator weak(scene);
  ASSERT_TRUE(weak.stick_pipe(390.0));
  weak.command(WinchSetpoint{0.1, false});
  bool told = false;
  double hook_load = 0.0;
  for (int k = 0; k < 2000 && !told; ++k)
  {
    ASSERT_EQ(weak.frame(0.01), FrameStatus::running);
    told = weak.truth().over_stress;
    hook_load = weak.truth().hook_load_string;
  }
  EXPECT_TRUE(told);
  EXPECT_NEAR(hook_load, 100e6 * 0.25 * pi * (0.127 * 0.127 - 0.1086 * 0.1086), 60e3)
      << "by the pipe's area, where it is pulled most";
}
}  // namespace test_sim_string_watch
