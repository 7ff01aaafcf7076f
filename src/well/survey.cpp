#include "drill_rig_sim/well/survey.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace drill_rig_sim
{
namespace
{
constexpr double largest_dogleg = 179.9 * degree;

// sin(x)/x; the series' next term is below round-off at the switch.
double sinc(double x) noexcept
{
  const double x2 = x * x;
  return x2 < 1e-4 ? 1.0 - x2 / 6.0 * (1.0 - x2 / 20.0 * (1.0 - x2 / 42.0)) : std::sin(x) / x;
}

[[noreturn]] void refuse(std::size_t station, double md, const std::string& what)
{
  std::ostringstream text;
  text << "survey station " << station + 1 << " (md " << md << " m): " << what;
  throw std::invalid_argument(text.str());
}

void check(const std::vector<SurveyStation>& stations)
{
  if (stations.size() < 2) throw std::invalid_argument("survey: has fewer than two stations, allowed are two or more");
  for (std::size_t i = 0; i < stations.size(); ++i)
  {
    const SurveyStation& s = stations[i];
    if (!std::isfinite(s.md) || !std::isfinite(s.inclination) || !std::isfinite(s.azimuth))
      refuse(i, s.md, "not a finite number");
    if (s.inclination < 0.0 || s.inclination > pi) refuse(i, s.md, "inclination outside 0 to 180 deg");
    if (i > 0 && !(s.md > stations[i - 1].md)) refuse(i, s.md, "md does not increase, it must be strictly increasing");
  }
}
}  // namespace

Survey::Survey(const std::vector<SurveyStation>& stations)
{
  check(stations);
  points_.reserve(stations.size());
  arcs_.reserve(stations.size() - 1);
  points_.push_back({stations[0].md, Eigen::Vector3d::Zero(), tangent_from(stations[0].inclination, stations[0].azimuth)});
  for (std::size_t i = 1; i < stations.size(); ++i)
  {
    const PathPoint from = points_.back();
    const Eigen::Vector3d tangent = tangent_from(stations[i].inclination, stations[i].azimuth);
    Arc arc;
    arc.length = stations[i].md - from.md;
    arc.turn = tangent - from.tangent;
    arc.bisector = tangent + from.tangent;
    arc.dogleg = 2.0 * std::atan2(arc.turn.norm(), arc.bisector.norm());
    if (arc.dogleg > largest_dogleg) refuse(i, stations[i].md, "turns back on the station above, less than 179.9 deg is allowed");
    arc.bisector.normalize();
    arc.inverse_sinc = 1.0 / sinc(0.5 * arc.dogleg);
    // r(1) of the class's formula
    points_.push_back({stations[i].md, from.position + arc.length * sinc(0.5 * arc.dogleg) * arc.bisector, tangent});
    arcs_.push_back(arc);
  }
}

double Survey::curvature(int i) const noexcept
{
  const Arc& arc = arcs_[static_cast<std::size_t>(i)];
  return arc.dogleg / arc.length;
}

double Survey::dogleg_severity(int i) const noexcept
{
  return 30.0 * curvature(i);
}

int Survey::arc_at(double md) const noexcept
{
  const auto above = std::upper_bound(points_.begin(), points_.end(), md, [](double m, const PathPoint& p) { return m < p.md; });
  const int i = static_cast<int>(above - points_.begin()) - 1;
  return std::clamp(i, 0, size() - 2);
}

PathPoint Survey::at(double md) const noexcept
{
  if (md <= first_md())
    return {md, points_.front().position + (md - first_md()) * points_.front().tangent, points_.front().tangent};
  if (md >= last_md()) return {md, points_.back().position + (md - last_md()) * points_.back().tangent, points_.back().tangent};
  const int i = arc_at(md);
  const PathPoint& from = station(i);
  const Arc& arc = arcs_[static_cast<std::size_t>(i)];
  const double u = (md - from.md) / arc.length;
  const double half = 0.5 * arc.dogleg;
  const double s1 = sinc(u * half);
  const double s2 = sinc((1.0 - u) * half);
  PathPoint p;
  p.md = md;
  p.position = from.position + arc.length * (u * s1 * std::cos((1.0 - u) * half) * arc.bisector -
                                             0.5 * u * (1.0 - u) * s1 * s2 * arc.inverse_sinc * arc.turn);
  const double phi = (u - 0.5) * arc.dogleg;
  p.tangent = std::cos(phi) * arc.bisector + (u - 0.5) * sinc(phi) * arc.inverse_sinc * arc.turn;
  return p;
}

}  // namespace drill_rig_sim
