// SPDX-License-Identifier: BSD-3-Clause
// Fuzz target: bytes as a survey file. Either one line a problem comes back, or a survey from which a well can be built; the
// path, the search for the closest point and the extension of the hole then stay finite wherever they are asked.
#include "drill_rig_sim/well/survey.h"

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "counters.h"
#include "drill_rig_sim/scene/read_scene.h"
#include "drill_rig_sim/scene/survey_file.h"
#include "drill_rig_sim/well/well_checks.h"
#include "drill_rig_sim/well/wellbore.h"
#include "random.h"

namespace drill_rig_sim
{
namespace fuzz
{
namespace
{
using Eigen::Vector3d;
constexpr double far_away = 1e6;  // [m]; a point farther off need not be located
constexpr int room_for_drilled = 16;

/// A file in memory that the reader can open by its name.
class MemoryFile
{
public:
  MemoryFile() : file_(memfd_create("survey", 0)) { check(file_ >= 0, "there is no file in memory"); }
  void write(const std::uint8_t* data, std::size_t size)
  {
    const bool written = ftruncate(file_, 0) == 0 && pwrite(file_, data, size, 0) == static_cast<ssize_t>(size);
    check(written, "the file in memory cannot be written");
  }
  std::string name() const { return "/proc/self/fd/" + std::to_string(file_); }

private:
  int file_;
};

std::optional<SurveyTable> read(const std::string& file)
{
  try
  {
    return read_survey_file(file);
  }
  catch (const SceneError& error)
  {
    check(!error.problems().empty(), "refused without a problem");
    for (const std::string& problem : error.problems()) check_refusal(problem);
    return std::nullopt;
  }
}

bool is_unit(const Vector3d& v)
{
  return std::abs(v.norm() - 1.0) < 1e-6;
}

Vector3d wild_vector(double scale, Random& random)
{
  return {random.wild(scale), random.wild(scale), random.wild(scale)};
}

void check_path(const Survey& survey, Random& random)
{
  for (int k = 0; k < 8; ++k)
  {
    const PathPoint p = survey.at(random.between(-10.0, 1.1 * survey.last_md()));
    check(p.position.allFinite() && is_unit(p.tangent), "a point on the survey's path is not finite");
  }
  for (int i = 0; i + 1 < survey.size(); ++i)
    check(std::isfinite(survey.dogleg_severity(i)) && std::isfinite(survey.curvature(i)), "a curvature is not finite");
}

void check_closest(const Wellbore& well, Random& random)
{
  const Vector3d near = well.at(random.between(-50.0, 1.01 * well.hole_depth())).position;
  const Vector3d point = random.one_in(2) ? Vector3d(near + wild_vector(0.3, random)) : wild_vector(1e4, random);
  const int hint = static_cast<int>(random.below(well.node_count() + 8)) - 4;
  const ClosestPoint found = well.locate(point, hint);
  if (!point.allFinite() || point.norm() > far_away) return;
  check(std::isfinite(found.md) && found.centre.allFinite() && is_unit(found.tangent), "the closest point is not finite");
  check(found.md_gradient.allFinite() && std::isfinite(found.radius_slope), "the closest point's slopes are not finite");
  check(found.radius > 0.0 && found.friction >= 0.0, "the closest point has no hole around it");
  check(found.segment >= 0 && found.segment <= well.node_count(), "the closest point is in no segment");
}

void check_bottom(const Wellbore& well)
{
  check(std::isfinite(well.hole_depth()) && well.bottom_position().allFinite(), "the hole's bottom is not finite");
  check(is_unit(well.bottom_normal()) && is_unit(well.raw_tangent()) && is_unit(well.end_direction()),
        "a direction at the bottom has no length 1");
  check(std::isfinite(well.drilled_path_length()), "the drilled length is not finite");
}

/// The bit's: along the hole, anywhere, or no number.
Vector3d random_axis(const Wellbore& well, Random& random)
{
  if (!random.one_in(4)) return well.end_direction();
  if (random.one_in(4)) return Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
  return Vector3d(random.between(-1.0, 1.0), random.between(-1.0, 1.0), random.between(-1.0, 1.0)).normalized();
}

void drill(Wellbore& well, Random& random)
{
  const double step = std::pow(10.0, random.between(-9.0, 0.0));
  for (int k = 0; k < 20; ++k)
  {
    const Vector3d displacement =
        random.one_in(8) ? wild_vector(1.0, random) : Vector3d(step * (well.end_direction() + wild_vector(0.3, random)));
    const Vector3d axis = random_axis(well, random);
    const Vector3d before = well.bottom_position();
    const bool taken = well.extend(displacement, axis);
    check(taken || well.bottom_position() == before, "a refused extension moved the bottom");
    check(!taken || (displacement.allFinite() && axis.allFinite()), "an extension that is no number was taken");
    check_bottom(well);
    check_closest(well, random);
  }
}

/// Drilled, taken back and drilled again: the same bits. False: the hole is too short for two sections.
bool check_well(const std::vector<SurveyStation>& stations, Random random)
{
  WellSpec spec;
  spec.survey = stations;
  spec.hole_depth = stations.back().md;
  spec.sections = {{0.5 * spec.hole_depth, 0.3204, 0.2}, {spec.hole_depth, 0.2159, 0.3}};
  if (!well_problems(spec).empty()) return false;
  TrajectorySpec trajectory;
  trajectory.stage_two_length = std::pow(10.0, random.between(-3.0, 1.0));
  if (random.one_in(4)) trajectory.stage_two_steps = 1 + static_cast<int>(random.below(20));
  Wellbore well(spec, trajectory, 0.1, {}, room_for_drilled);
  check_bottom(well);
  for (int k = 0; k < 16; ++k) check_closest(well, random);
  const Wellbore before = well;
  const Random again = random;
  drill(well, random);
  const Vector3d bottom = well.bottom_position();
  const std::uint64_t version = well.version();
  well = before;
  random = again;
  drill(well, random);
  check(well.bottom_position() == bottom && well.version() == version, "a well that was taken back is drilled otherwise");
  return true;
}
}  // namespace

void take(const std::uint8_t* data, std::size_t size)
{
  static MemoryFile file;
  ++counters().inputs;
  file.write(data, size);
  auto table = read(file.name());
  if (!table)
  {
    ++counters().refused;
    return;
  }
  Random random(seed_of(std::string(reinterpret_cast<const char*>(data), size)));
  check_path(Survey(table->stations, table->tie_in), random);
  if (table->stations.front().md > 0.0)
  {
    const std::string problem = tie_survey_in(*table->tie_in, table->stations);
    if (!problem.empty())
    {
      check_refusal(problem);
      ++counters().unbuildable;
      return;
    }
    check(survey_problems(table->stations).empty(), "a survey that was tied in is not sound");
  }
  ++(check_well(table->stations, random) ? counters().accepted : counters().unbuildable);
}
}  // namespace fuzz
}  // namespace drill_rig_sim

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  drill_rig_sim::fuzz::take(data, size);
  return 0;
}
