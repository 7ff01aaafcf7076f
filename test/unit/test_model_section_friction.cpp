// SPDX-License-Identifier: BSD-3-Clause
// Static ratio and Stribeck speed of a hole section: a bit pressed into the wall there slides by them, elsewhere by the scene's.
#include <gtest/gtest.h>

#include <cmath>

#include "lone_bit.h"
#include "one_step.h"

namespace test_model_section_friction
{
using namespace drill_rig_sim;

namespace
{
constexpr double step = 0.01, pressed = 1e-3, radius = 0.05;  // [s], [m], [m]
constexpr double motor = 8.0, speed = radius * motor;         // of the bit about its axis, of its gauge [rad/s], [m/s]

/// mu_k (1 + (ratio - 1) exp(-(v / v_s)^2)).
double mu(double kinetic, double ratio, double stribeck)
{
  return kinetic * (1.0 + (ratio - 1.0) * std::exp(-std::pow(speed / stribeck, 2)));
}

/// Friction over normal force of the bit's gauge sliding at `speed`; `own`: of the section that the bit is in.
double felt(const HoleSection& own)
{
  Scene scene = lone_bit_scene();
  const double depth = scene.well.sections.back().to;
  scene.contact.static_ratio = 1.5;
  scene.contact.stribeck_speed = 0.8;
  scene.string = {bit_part(2.0 * radius), pipe_part(0, 4.0, plain_pipe_mass, pipe_outer)};
  HoleSection above = scene.well.sections[0];
  above.to = 0.1;
  above.friction = 0.9;
  scene.well.sections = {above, own};
  scene.well.sections[1].to = depth;
  scene.well.sections[1].diameter = above.diameter;
  RigAtRest rig = build_at_rest(scene);
  rig.state.nodes[0].position.x() = 0.5 * above.diameter - radius + pressed;
  rig.state.bit.motor_speed = motor;
  Workspace work(*rig.model);
  evaluate_one_step(rig, step, {}, work);
  return work.result.forces.wall[0].y() / work.result.forces.contact[0];
}

HoleSection section(double kinetic, double ratio, double stribeck)
{
  HoleSection s;
  s.friction = kinetic;
  s.static_ratio = ratio;
  s.stribeck_speed = stribeck;
  return s;
}
}  // namespace

TEST(SectionFriction, bitSlidesByItsSectionsLaw)
{
  const double unset = HoleSection::unset;
  EXPECT_NEAR(felt(section(0.3, unset, unset)), mu(0.3, 1.5, 0.8), 1e-9);
  EXPECT_NEAR(felt(section(0.3, 1.9, unset)), mu(0.3, 1.9, 0.8), 1e-9);
  EXPECT_NEAR(felt(section(0.3, unset, 0.2)), mu(0.3, 1.5, 0.2), 1e-9);
  EXPECT_NEAR(felt(section(0.2, 2.5, 0.4)), mu(0.2, 2.5, 0.4), 1e-9);
}

TEST(SectionFriction, changesInAStraightLineBetweenSections)
{
  ContactSpec contact;
  contact.static_ratio = 1.4;
  contact.stribeck_speed = 0.1;
  const SectionFriction friction(contact, {section(0.2, 1.2, HoleSection::unset), section(0.3, HoleSection::unset, 0.3)});
  const auto at = [&](double place)
  {
    WallLaw law;
    friction.apply(place, law);
    return law;
  };
  EXPECT_EQ(at(0.0).static_ratio, 1.2);
  EXPECT_EQ(at(0.0).stribeck_speed, 0.1);
  EXPECT_NEAR(at(0.25).static_ratio, 1.25, 1e-15);
  EXPECT_NEAR(at(0.25).stribeck_speed, 0.15, 1e-15);
  EXPECT_EQ(at(1.0).static_ratio, 1.4);
  EXPECT_EQ(at(1.0).stribeck_speed, 0.3);
  for (const double outside : {1.5, 1e9}) EXPECT_EQ(at(outside).stribeck_speed, 0.3);
  for (const double outside : {-1.0, std::nan("")}) EXPECT_EQ(at(outside).static_ratio, 1.2);
}

TEST(SectionFriction, leavesTheLawAloneWhereNoSectionHasItsOwn)
{
  WallLaw law;
  law.static_ratio = 3.0;
  SectionFriction(ContactSpec(), {section(0.2, HoleSection::unset, HoleSection::unset)}).apply(0.0, law);
  EXPECT_EQ(law.static_ratio, 3.0);
}
}  // namespace test_model_section_friction
