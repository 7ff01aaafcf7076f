// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_TEST_BEAM_KINDS_H
#define DRILL_RIG_SIM_TEST_BEAM_KINDS_H

#include <Eigen/Core>

#include "drill_rig_sim/compared/rotation_vector_beam.h"
#include "drill_rig_sim/string/beam_table.h"
#include "beam_ends.h"

/// The kinds of beam element by name, a pipe to try them on, and what both of the rigid-section elements interpolate.
namespace drill_rig_sim
{
inline const BeamSection kPipe = tube_section(9.5, 0.127, 0.1086, 206e9, 0.3);
inline const BeamKind& kCorotational = find_beam(ElementKind::corotational);
inline const BeamKind& kExact = find_beam(ElementKind::geometrically_exact);
inline const BeamKind& kVector = find_beam(ElementKind::rotation_vector);

/// Axes of a chain for an element that counts its rotation from the vertical: x down.
inline Eigen::Matrix3d downwards()
{
  return Eigen::Matrix3d(ground_axes());
}

inline Eigen::Vector3d vector_of(const Eigen::Matrix3d& rotation)
{
  const Eigen::AngleAxisd a(rotation);
  return a.angle() * a.axis();
}

/// The rotation vector's section in the middle, and L times its curvature in its axes: by differences of the rotation itself, not
/// by the formula for J.
struct VectorMiddle
{
  Eigen::Matrix3d section;
  Eigen::Vector3d turn;
};

inline VectorMiddle vector_middle(const BeamEnds& s)
{
  const Eigen::Matrix3d ground(ground_axes());
  const Eigen::Vector3d psi1 = vector_of(Eigen::Matrix3d(s.q1) * ground.transpose()),
                        psi2 = vector_of(Eigen::Matrix3d(s.q2) * ground.transpose());
  auto at = [&](double x)
  {
    const Eigen::Vector3d psi = psi1 + x * (psi2 - psi1);
    return Eigen::Matrix3d(Eigen::AngleAxisd(psi.norm(), psi.normalized()).toRotationMatrix() * ground);
  };
  const double h = 1e-3;
  // fourth order: (8 turn(h) - turn(2 h))/(12 h), turns from -h to h and from -2 h to 2 h
  const Eigen::Vector3d near = vector_of(at(0.5 - h).transpose() * at(0.5 + h)),
                        far = vector_of(at(0.5 - 2.0 * h).transpose() * at(0.5 + 2.0 * h));
  return {at(0.5), (8.0 * near - far) / (12.0 * h)};
}

/// On the pipe, without load.
inline BeamForces forces(const BeamKind& kind, const BeamEnds& s, const BeamDamping& damping = {})
{
  BeamStrain strain;
  return kind.forces(kPipe, pose_of(s), damping, Eigen::Vector3d::Zero(), strain);
}

/// Ends near the ground's axes, turned by less than half a turn: any element is at its best there.
inline BeamEnds any_ends(std::mt19937& generator, double size)
{
  std::normal_distribution<double> g;
  const Eigen::Vector3d common = 0.7 * Eigen::Vector3d(g(generator), g(generator), g(generator));
  const double spin = 0.3 * g(generator);
  return random_ends(generator, kPipe.length, size, 3.0 * size, spin, rotation_from_vector(common) * ground_axes());
}

}  // namespace drill_rig_sim

#endif
