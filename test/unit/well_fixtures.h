// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_TEST_WELL_FIXTURES_H
#define DRILL_RIG_SIM_TEST_WELL_FIXTURES_H

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <random>
#include <vector>

#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/well/directions.h"
#include "drill_rig_sim/well/wellbore.h"

/// Wells that several tests drill.
namespace drill_rig_sim
{
/// The main job's well: vertical to 200 m, 3 deg/30 m to 51 deg at 710 m, held to 730 m, azimuth 297 deg.
inline WellSpec bohai_well()
{
  WellSpec well;
  well.survey = {{0.0, 0.0, 0.0}, {200.0, 0.0, 1.0}};
  for (int i = 1; i <= 17; ++i) well.survey.push_back({200.0 + 30.0 * i, 3.0 * i * degree, 297.0 * degree});
  well.survey.push_back({730.0, 51.0 * degree, 297.0 * degree});
  well.hole_depth = 730.0;
  well.sections = {{200.0, 0.3204, 0.20}, {800.0, 0.3112, 0.28}};
  return well;
}

/// Straight down along one inclination and azimuth.
inline WellSpec straight_well(double depth, double inclination = 0.0, double azimuth = 0.0)
{
  WellSpec well;
  well.survey = {{0.0, inclination, azimuth}, {depth, inclination, azimuth}};
  well.hole_depth = depth;
  well.sections = {{depth + 1000.0, 0.3112, 0.25}};
  return well;
}

/// Turns and builds: 12 deg/30 m, up past the horizontal.
inline WellSpec crooked_well()
{
  WellSpec well;
  double md = 0.0;
  for (int i = 0; i <= 60; ++i, md += 27.0)
    well.survey.push_back({md, std::min(1.8 * i, 100.0) * degree, (7 * i % 360) * degree});
  well.hole_depth = 1600.0;
  well.sections = {{500.0, 0.4445, 0.2}, {1100.0, 0.3112, 0.3}, {1600.0, 0.2159, 0.25}};
  return well;
}

/// Measured depths from `from` to `to` in equal steps.
inline std::vector<double> depths(double from, double to, double step)
{
  std::vector<double> all;
  const int count = static_cast<int>((to - from) / step);
  for (int i = 0; i <= count; ++i) all.push_back(from + i * step);
  return all;
}

/// Two unit vectors perpendicular to t and to each other.
inline void cross_section(const Eigen::Vector3d& t, Eigen::Vector3d& u, Eigen::Vector3d& v)
{
  u = t.unitOrthogonal();
  v = t.cross(u);
}

/// A random point within `reach` of the axis, anywhere along the hole.
inline Eigen::Vector3d point_near(const Wellbore& hole, double reach, std::mt19937& random)
{
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  const WellNode axis = hole.at(uniform(random) * hole.hole_depth());
  Eigen::Vector3d u, v;
  cross_section(axis.tangent, u, v);
  const double angle = 2.0 * pi * uniform(random);
  return axis.position + reach * uniform(random) * (std::cos(angle) * u + std::sin(angle) * v);
}

/// A bit that goes round while it drills: displacement number `step` of a helix about `axis`, so long per step along it.
class HelixDriller
{
public:
  HelixDriller(const Eigen::Vector3d& axis, double pitch, double radius, double advance)
      : axis_(axis), wave_number_(2.0 * pi / pitch), radius_(radius), advance_(advance)
  {
    cross_section(axis_, u_, v_);
  }
  Eigen::Vector3d next()
  {
    const Eigen::Vector3d before = at(travelled_);
    travelled_ += advance_;
    return at(travelled_) - before;
  }

private:
  Eigen::Vector3d at(double z) const
  {
    return axis_ * z + radius_ * (std::cos(wave_number_ * z) * u_ + std::sin(wave_number_ * z) * v_);
  }
  Eigen::Vector3d axis_, u_, v_;
  double wave_number_, radius_, advance_;
  double travelled_ = 0.0;
};

}  // namespace drill_rig_sim

#endif
