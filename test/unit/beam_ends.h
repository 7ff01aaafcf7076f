// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_TEST_BEAM_ENDS_H
#define DRILL_RIG_SIM_TEST_BEAM_ENDS_H

#include <Eigen/Dense>
#include <cmath>
#include <random>

#include "drill_rig_sim/math/rotation.h"
#include "drill_rig_sim/string/beam_table.h"

/// One element and its two ends, to be moved about by hand.
namespace drill_rig_sim
{
/// 1 the upper end, 2 the lower.
struct BeamEnds
{
  Eigen::Vector3d x1, x2;
  Eigen::Quaterniond q1, q2;
};

inline BeamPose pose_of(const BeamEnds& s)
{
  return {s.x1, s.x2, x_axis(s.q1), x_axis(s.q2), twist_between(s.q1, s.q2), s.q1, s.q2};
}

/// Component k of the 12: x1, theta1, x2, theta2 moved by h.
inline BeamEnds moved(const BeamEnds& s, int k, double h)
{
  BeamEnds m = s;
  const Eigen::Vector3d v = h * Eigen::Vector3d::Unit(k % 3);
  if (k < 3) m.x1 += v;
  if (k >= 3 && k < 6) m.q1 = rotation_from_vector(v) * s.q1;
  if (k >= 6 && k < 9) m.x2 += v;
  if (k >= 9) m.q2 = rotation_from_vector(v) * s.q2;
  return m;
}

/// The rates of a move of component k at `rate`.
inline BeamDamping moving(int k, double rate, double time, double dv_du)
{
  BeamDamping damping;
  damping.time = time;
  damping.dv_du = dv_du;
  const Eigen::Vector3d v = rate * Eigen::Vector3d::Unit(k % 3);
  if (k < 3) damping.velocity = -v;
  if (k >= 3 && k < 6) damping.upper_turning = v;
  if (k >= 6 && k < 9) damping.velocity = v;
  if (k >= 9) damping.lower_turning = v;
  return damping;
}

inline BeamEnds turned(const BeamEnds& s, const Eigen::Quaterniond& q)
{
  return {q * s.x1, q * s.x2, q * s.q1, q * s.q2};
}

/// An element somewhere near the direction `common`, its ends tilted and twisted at random; common spin of many turns.
inline BeamEnds random_ends(std::mt19937& generator, double length, double tilt, double twist, double spin,
                            const Eigen::Quaterniond& common)
{
  std::normal_distribution<double> g;
  BeamEnds s;
  s.x1 = Eigen::Vector3d(g(generator), g(generator), g(generator));
  s.x2 = s.x1 + common * Eigen::Vector3d(length * (1.0 + 1e-3 * g(generator)), 0.0, 0.0);
  auto end = [&](double turn)
  {
    return Eigen::Quaterniond(common * rotation_from_vector(tilt * Eigen::Vector3d(0.0, g(generator), g(generator))) *
                              rotation_from_vector(Eigen::Vector3d(turn, 0.0, 0.0)));
  };
  s.q1 = end(spin);
  s.q2 = end(spin + twist * g(generator));
  return s;
}

using Vector12d = Eigen::Matrix<double, 12, 1>;
using Matrix12d = Eigen::Matrix<double, 12, 12>;

inline Vector12d stacked(const BeamForces& f)
{
  Vector12d v;
  v << -f.force, f.moment_upper, f.force, f.moment_lower;
  return v;
}

inline Matrix12d stacked(const BeamTangent& t)
{
  Matrix12d m;
  m << t.force_d, -t.force_upper, -t.force_d, -t.force_lower,  //
      -t.upper_d, t.upper_upper, t.upper_d, t.upper_lower,     //
      -t.force_d, t.force_upper, t.force_d, t.force_lower,     //
      -t.lower_d, t.lower_upper, t.lower_d, t.lower_lower;
  return m;
}

}  // namespace drill_rig_sim

#endif
