// SPDX-License-Identifier: BSD-3-Clause
// Every kind of beam element in the table: tangent, energy, rigid motion, patches, order; what the total rotation vector cannot
// do.
#include <gtest/gtest.h>

#include <cmath>
#include <ctime>
#include <random>

#include "beam_ends.h"
#include "beam_kinds.h"
#include "beam_problems.h"
#include "in_source.h"
#include "drill_rig_sim/scene/read_scene.h"

namespace test_string_beam_kinds
{
using namespace drill_rig_sim;
using Eigen::AngleAxisd;
using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

namespace
{
Quaterniond turn_about(const Vector3d& axis, double angle)
{
  return Quaterniond(AngleAxisd(angle, axis.normalized()));
}

/// Energy of rigid-section strains in the middle of an element [J].
double section_energy(const Matrix3d& middle, const Vector3d& turn, const BeamEnds& s)
{
  const Vector3d gamma = middle.transpose() * (s.x2 - s.x1) / kPipe.length - Vector3d::UnitX();
  const Vector3d stretch(kPipe.axial, kPipe.shear, kPipe.shear), bend(kPipe.torsion * kPipe.length, kPipe.bending, kPipe.bending);
  return 0.5 * kPipe.length * gamma.cwiseProduct(stretch).dot(gamma) + 0.5 / kPipe.length * turn.cwiseProduct(bend).dot(turn);
}

double exact_energy(const BeamEnds& s)
{
  const Matrix3d r1(s.q1), r2(s.q2);
  const Vector3d phi = vector_of(r1.transpose() * r2);
  return section_energy(r1 * AngleAxisd(0.5 * phi.norm(), phi.normalized()).toRotationMatrix(), phi, s);
}

double vector_energy(const BeamEnds& s)
{
  const VectorMiddle middle = vector_middle(s);
  return section_energy(middle.section, middle.turn, s);
}

/// Largest difference of the forces, relative, when the element is turned as a rigid body.
double change_by_turning(const BeamKind& kind, const BeamEnds& s, const Quaterniond& q)
{
  BeamForces f = forces(kind, s);
  for (Vector3d* v : {&f.force, &f.moment_upper, &f.moment_lower}) *v = q * *v;
  const Vector12d before = stacked(f), after = stacked(forces(kind, turned(s, q)));
  return std::max((after - before).head<3>().norm() / before.head<3>().norm(),
                  (after - before).tail<3>().norm() / before.tail<3>().norm());
}

/// A hanging element bent by `angle` between its ends and twisted by half as much, its stretch 1e-4.
BeamEnds bent_ends(double angle)
{
  BeamEnds s;
  s.q1 = turn_about(Vector3d::UnitY(), 0.5 * angle) * ground_axes();
  s.q2 = turn_about(Vector3d::UnitY(), -0.5 * angle) * ground_axes() * turn_about(Vector3d::UnitX(), 0.5 * angle);
  s.x1 = Vector3d::Zero();
  s.x2 = Vector3d(0.0, 0.0, -1.0001 * kPipe.length);
  return s;
}
}  // namespace

TEST(BeamKinds, theFirstIsTheDefault)
{
  EXPECT_EQ(&find_beam(ElementKind::automatic), &kCorotational);
}

TEST(BeamKinds, everyKindIsAWordOfTheSceneFile)
{
  const std::string quick = in_source("config/scenes/quick.yaml");
  for (const BeamKind& kind : beam_table())
    EXPECT_EQ(read_scene(quick, {std::string("numerics.element=") + kind.name}).numerics.element, kind.kind) << kind.name;
}

// Without tension at its free stretch, and elastic about it: forces are the gradient of the energy there, the tangent that of the
// forces.
TEST(BeamKinds, freeStretchIsWhereThereIsNoTension)
{
  std::mt19937 generator(7);
  for (const BeamKind& kind : beam_table())
  {
    const BeamEnds s = any_ends(generator, 0.03);
    const auto with = [](const BeamEnds& ends)
    {
      BeamPose pose = pose_of(ends);
      pose.free_stretch = 2e-3;
      return pose;
    };
    const auto at = [&](const BeamEnds& ends)
    {
      BeamStrain strain;
      return kind.forces(kPipe, with(ends), {}, Vector3d::Zero(), strain);
    };
    BeamStrain strain;
    BeamTangent t;
    const BeamForces f = kind.forces_and_tangent(kPipe, with(s), {}, Vector3d::Zero(), strain, t);
    EXPECT_NEAR(f.tension, forces(kind, s).tension - 2e-3 * kPipe.axial, 1e-9 * kPipe.axial) << kind.name;
    const Matrix12d tangent = stacked(t);
    for (int k = 0; k < 12; ++k)
    {
      const double h = 1e-5;
      EXPECT_NEAR(stacked(f)[k],
                  (kind.energy(kPipe, with(moved(s, k, h))) - kind.energy(kPipe, with(moved(s, k, -h)))) / (2.0 * h),
                  1e-5 * stacked(f).norm())
          << kind.name << " " << k;
      const Vector12d column = (stacked(at(moved(s, k, 0.1 * h))) - stacked(at(moved(s, k, -0.1 * h)))) / (0.2 * h);
      EXPECT_LT((tangent.col(k) - column).norm(), 1e-6 * tangent.norm()) << kind.name << " " << k;
    }
  }
}

TEST(BeamKinds, tangentIsTheDerivativeOfTheForces)
{
  for (const BeamKind& kind : beam_table())
    for (double size : {1e-3, 0.03, 0.1, 0.3, 0.6})
    {
      std::mt19937 generator(2);
      for (int i = 0; i < 20; ++i)
      {
        const BeamEnds s = any_ends(generator, size);
        const double time = i % 2 * 0.005, dv_du = 140.0, h = 1e-6;  // [s], [1/s], [m, rad]
        const Vector3d load(100.0, -200.0, -2500.0);
        BeamStrain strain;
        BeamTangent t;
        kind.forces_and_tangent(kPipe, pose_of(s), moving(0, 0.0, time, dv_du), load, strain, t);
        const Matrix12d k_matrix = stacked(t);
        for (int k = 0; k < 12; ++k)
        {
          // at rest where the tangent is taken: the rates are those of the move alone
          auto at = [&](double move)
          { return stacked(kind.forces(kPipe, pose_of(moved(s, k, move)), moving(k, dv_du * move, time, dv_du), load, strain)); };
          const Vector12d column = (at(h) - at(-h)) / (2.0 * h);
          EXPECT_LT((column - k_matrix.col(k)).norm(), 1e-6 * k_matrix.norm())
              << kind.name << ", size " << size << ", column " << k;
          // rotations on their own: axial stiffness must not hide an error in the bending terms
          EXPECT_LT((column - k_matrix.col(k)).tail<3>().norm(), 1e-6 * t.lower_lower.norm())
              << kind.name << ", size " << size << ", column " << k;
        }
      }
    }
}

TEST(BeamKinds, forcesAreTheGradientOfTheRigidSectionsEnergy)
{
  const std::pair<const BeamKind*, double (*)(const BeamEnds&)> cases[] = {{&kExact, exact_energy}, {&kVector, vector_energy}};
  for (const auto& c : cases)
    for (double size : {0.03, 0.3})
    {
      std::mt19937 generator(1);
      for (int i = 0; i < 20; ++i)
      {
        const BeamEnds s = any_ends(generator, size);
        const Vector12d f = stacked(forces(*c.first, s));
        for (int k = 0; k < 12; ++k)
        {
          const double h = 1e-4;
          const double slope = (8.0 * (c.second(moved(s, k, h)) - c.second(moved(s, k, -h))) -
                                (c.second(moved(s, k, 2.0 * h)) - c.second(moved(s, k, -2.0 * h)))) /
                               (12.0 * h);
          EXPECT_NEAR(f[k], slope, 2e-6 * f.norm()) << c.first->name << " component " << k;
        }
      }
    }
}

// What the dashpots take in is E A L t (stretch rate)^2 + G J/L t (twist rate)^2, whatever the pose.
// What an energy balance asks the elements for.
TEST(BeamKinds, theyTellTheSameEnergy)
{
  std::mt19937 generator(8);
  for (int i = 0; i < 20; ++i)
  {
    const BeamEnds s = any_ends(generator, 0.1);
    EXPECT_NEAR(kExact.energy(kPipe, pose_of(s)), exact_energy(s), 1e-9 * exact_energy(s));
    EXPECT_NEAR(kVector.energy(kPipe, pose_of(s)), vector_energy(s), 1e-6 * vector_energy(s));
  }
}

TEST(BeamKinds, rigidMotionTurnsTheForcesOfObjectiveElements)
{
  std::mt19937 generator(3);
  for (const BeamKind* kind : {&kCorotational, &kExact})
    for (int i = 0; i < 20; ++i)
    {
      const BeamEnds s = any_ends(generator, 0.1);
      EXPECT_LT(change_by_turning(*kind, s, turn_about(Vector3d(1.0, 2.0, -0.5), 2.5)), 1e-9) << kind->name;
      EXPECT_LT(change_by_turning(*kind, s, turn_about(Vector3d::UnitZ(), 2.0 * pi)), 1e-9) << kind->name;
    }
}

// A hanging, bent element: as the string turns about the vertical, the strain that the total rotation vectors see changes
// although nothing bends. The change is of second order in the bend, and grows without bound towards the full turn.
TEST(BeamKinds, rigidMotionChangesTheStrainOfTotalRotationVectors)
{
  auto false_shear = [](double bend, double angle)
  {
    const BeamEnds s = bent_ends(bend);
    const Quaterniond q = rotation_from_vector(Vector3d(0.0, 0.0, -angle));
    return (forces(kVector, turned(s, q)).force - q * forces(kVector, s).force).norm() / kPipe.shear;
  };
  const double bend = 0.02;
  double last = 0.0;
  for (double angle : {0.5 * pi, pi, 1.5 * pi, 1.9 * pi})
  {
    const double shear = false_shear(bend, angle);
    std::printf("rotation_vector, bent by %g rad, turned by %.0f deg: false shear of %.1e rad, %.4f of the bend\n", bend,
                angle / degree, shear, shear / bend);
    EXPECT_GT(shear, last);
    EXPECT_NEAR(std::log2(shear / false_shear(0.5 * bend, angle)), 2.0, 0.1);
    last = shear;
  }
  EXPECT_GT(last, 1e-4);  // as much as 13 kN of shear force makes
}

TEST(BeamKinds, totalRotationVectorsRefuseTheFullTurn)
{
  const BeamEnds s = bent_ends(0.02);
  EXPECT_TRUE(
      forces(kVector, turned(s, rotation_from_vector(Vector3d(0.0, 0.0, 2.0 * pi - full_turn_margin - 0.05)))).force.allFinite());
  for (double angle : {2.0 * pi - full_turn_margin + 0.05, 2.0 * pi, 2.0 * pi + 0.05})
  {
    const BeamEnds around = turned(s, rotation_from_vector(Vector3d(0.0, 0.0, angle)));
    EXPECT_FALSE(forces(kVector, around).force.allFinite()) << angle;
    EXPECT_TRUE(forces(kExact, around).force.allFinite()) << angle;
  }
}

TEST(BeamKinds, forcesAndMomentsBalance)
{
  for (const BeamKind* kind : {&kCorotational, &kExact})
  {
    std::mt19937 generator(4);
    for (int i = 0; i < 20; ++i)
    {
      const BeamEnds s = any_ends(generator, 0.1);
      const BeamForces f = forces(*kind, s);
      const Vector3d rest = f.moment_upper + f.moment_lower + (s.x2 - s.x1).cross(f.force);
      EXPECT_LT(rest.norm(), 1e-9 * (f.force.norm() * kPipe.length + f.moment_upper.norm())) << kind->name;
    }
  }
}

TEST(BeamKinds, cantileverConvergesAtSecondOrder)
{
  const double load = 5.0, length = 10.0, bending = 1e6;
  const Elastica exact = elastica(load);
  for (const BeamKind& kind : beam_table())
  {
    std::vector<double> error;
    for (int count : {8, 16, 32, 64})
    {
      // stretch and shear below 1e-6 of the deflection
      const double axial = 1e6 * load * bending / (length * length);
      BeamChain chain = BeamChain::cantilever(count, section_of(length / count, axial, bending, 1e6, axial));
      chain.kind = &kind;
      chain.attitude = downwards();
      load_in_steps(chain, 20, [&](BeamChain& c, double part) { c.tip().force.y() = part * load * bending / (length * length); });
      const Vector3d tip = chain.tip().position / length;
      error.push_back(std::hypot(tip.y() - exact.drop, 1.0 - tip.x() - exact.shortening));
    }
    std::printf("%s, cantilever under 5 E I/L^2: tip off by %.2e %.2e %.2e %.2e L with 8, 16, 32, 64 elements\n", kind.name,
                error[0], error[1], error[2], error[3]);
    for (int k = 1; k < 3; ++k) EXPECT_NEAR(std::log2(error[k] / error[k + 1]), 2.0, 0.2) << kind.name;
  }
}

// A hanging string of ten joints under its own weight, its top turned slowly by two turns, its bit free: it just turns.
TEST(BeamKinds, topTurnedSlowlyTakesObjectiveElementsAlongAndStopsTotalRotationVectors)
{
  auto turns_made = [](const BeamKind& kind)
  {
    BeamChain chain = BeamChain::cantilever(10, kPipe);
    chain.kind = &kind;
    chain.attitude = downwards();
    for (auto& e : chain.elements)
    {
      e.load.x() = 300.0 * kPipe.length;  // 300 N/m
      e.load.y() = 0.5 * kPipe.length;    // leans a little, as in a well out of the vertical
    }
    if (!chain.solve()) return -1.0;
    const int steps = 36;
    for (int k = 1; k <= 2 * steps; ++k)
    {
      const Quaterniond turn = rotation_from_vector(Vector3d(2.0 * pi / steps, 0.0, 0.0));
      chain.nodes[0].orientation = turn * chain.nodes[0].orientation;
      if (!chain.solve()) return static_cast<double>(k - 1) / steps;
    }
    return 2.0;
  };
  EXPECT_EQ(turns_made(kCorotational), 2.0);
  EXPECT_EQ(turns_made(kExact), 2.0);
  const double made = turns_made(kVector);
  std::printf("rotation_vector: equilibrium up to %.2f turns of the top\n", made);
  EXPECT_GT(made, 0.5);
  EXPECT_LT(made, 1.0);
}

// Not a check but a measurement: processor time of one element, warm.
TEST(BeamKinds, costOfAnElement)
{
  std::mt19937 generator(6);
  std::vector<BeamPose> poses;
  for (int i = 0; i < 64; ++i) poses.push_back(pose_of(any_ends(generator, 0.01)));
  for (const BeamKind& kind : beam_table())
    for (bool with_tangent : {false, true})
    {
      BeamStrain strain;
      BeamTangent t;
      BeamDamping damping;
      damping.time = 1e-4;
      double sum = 0.0, best = 1e9;
      for (int round = 0; round < 5; ++round)
      {
        const std::clock_t start = std::clock();
        for (int k = 0; k < 200; ++k)
          for (const BeamPose& pose : poses)
            sum += with_tangent ? kind.forces_and_tangent(kPipe, pose, damping, Vector3d::Zero(), strain, t).tension
                                : kind.forces(kPipe, pose, damping, Vector3d::Zero(), strain).tension;
        best = std::min(best, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC / (200.0 * poses.size()));
      }
      EXPECT_TRUE(std::isfinite(sum));
      std::printf("%s, %s: %.0f ns\n", kind.name, with_tangent ? "residual and tangent" : "residual", 1e9 * best);
    }
}
}  // namespace test_string_beam_kinds
