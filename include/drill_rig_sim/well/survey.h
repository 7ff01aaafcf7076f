// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_WELL_SURVEY_H
#define DRILL_RIG_SIM_WELL_SURVEY_H

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "drill_rig_sim/well/well_spec.h"
#include "drill_rig_sim/well/directions.h"
#include "drill_rig_sim/well/tie_in.h"

namespace drill_rig_sim
{
/// A place on a well's path.
struct PathPoint
{
  double md = 0.0;                                      ///< measured depth [m]
  Eigen::Vector3d position = Eigen::Vector3d::Zero();   ///< [m]
  Eigen::Vector3d tangent = -Eigen::Vector3d::UnitZ();  ///< unit, down the hole
};

/// A well's path through its survey stations by the method of minimum curvature: circular arcs of constant curvature that
/// share their tangents at the stations (Sawaryn & Thorogood, "A compendium of directional calculations based on the minimum
/// curvature method", SPE Drilling & Completion, March 2005). The first station is the origin, or
/// lies where a tie-in has it.
///
/// With t1, t2 the tangents at an arc's ends, D its length, alpha = 2 atan2(|t2 - t1|, |t2 + t1|) its dogleg,
/// b = (t1 + t2)/|t1 + t2|, S(x) = sin(x)/x and u = (md - md1)/D:
///   r(u) = r1 + D [u S(u alpha/2) cos((1-u) alpha/2) b  -  u (1-u)/2 S(u alpha/2) S((1-u) alpha/2)/S(alpha/2) (t2 - t1)]
///   t(u) = cos((u-1/2) alpha) b  +  (u-1/2) S((u-1/2) alpha)/S(alpha/2) (t2 - t1)
/// No term divides by sin(alpha): the forms hold from alpha = 0 (S by its series) to alpha near pi. At alpha = pi the plane of
/// the arc is undefined. An azimuth enters only through the tangent, so it does not matter at inclination 0.
class Survey
{
public:
  /// Throws std::invalid_argument with one line that names the station if survey_problems() (well_checks.h) finds anything.
  explicit Survey(const std::vector<SurveyStation>& stations, const std::optional<TieIn>& tie_in = std::nullopt);

  int size() const noexcept { return static_cast<int>(points_.size()); }
  /// Station i, 0 <= i < size().
  const PathPoint& station(int i) const noexcept { return points_[static_cast<std::size_t>(i)]; }
  double first_md() const noexcept { return points_.front().md; }
  double last_md() const noexcept { return points_.back().md; }

  /// Angle between the tangents at stations i and i + 1 [rad], 0 <= i < size() - 1.
  double dogleg(int i) const noexcept { return arcs_[static_cast<std::size_t>(i)].dogleg; }
  /// Dogleg severity between stations i and i + 1 [rad per 30 m].
  double dogleg_severity(int i) const noexcept;
  /// Curvature between stations i and i + 1 [1/m].
  double curvature(int i) const noexcept;

  /// The point on the arcs at measured depth `md`; beyond the first and last station the path runs on straight.
  PathPoint at(double md) const noexcept;
  /// Index i of the arc from station i to i + 1 that holds `md`; the first or last one outside the survey.
  int arc_at(double md) const noexcept;

private:
  struct Arc
  {
    double length;             // D
    double dogleg;             // alpha
    Eigen::Vector3d bisector;  // b
    Eigen::Vector3d turn;      // t2 - t1
    double inverse_sinc;       // 1 / S(alpha/2)
  };

  std::vector<PathPoint> points_;
  std::vector<Arc> arcs_;
};

}  // namespace drill_rig_sim

#endif
