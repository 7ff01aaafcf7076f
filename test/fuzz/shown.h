// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_TEST_FUZZ_SHOWN_H
#define DRILL_RIG_SIM_TEST_FUZZ_SHOWN_H

#include <cmath>
#include <string>
#include <vector>

#include "../unit/sim_numbers.h"
#include "counters.h"
#include "drill_rig_sim/sim/simulator.h"
#include "drill_rig_sim/sim/simulator_state.h"

/// Everything that a simulator reports, and that all of it is finite.
namespace drill_rig_sim
{
namespace fuzz
{
inline void append(std::vector<double>& out, const std::vector<double>& more)
{
  out.insert(out.end(), more.begin(), more.end());
}

inline void append(std::vector<double>& out, const std::vector<Eigen::Vector3d>& more)
{
  for (const Eigen::Vector3d& v : more) out.insert(out.end(), v.data(), v.data() + 3);
}

/// Quantities along the string, one vector after the other.
inline std::vector<double> numbers_along(const Simulator& rig)
{
  StringProfile p;
  rig.profile(p);
  std::vector<double> out;
  for (const std::vector<double>* v : {&p.md, &p.from_bit, &p.tension, &p.true_axial_force, &p.torque, &p.bending_moment,
                                       &p.contact_force, &p.contact_side, &p.spin_speed, &p.radius})
    append(out, *v);
  for (const std::vector<Eigen::Vector3d>* v : {&p.position, &p.contact_vector}) append(out, *v);
  return out;
}

inline std::vector<double> numbers_of_parts(const Simulator& rig)
{
  std::vector<PartPose> parts;
  rig.part_poses(2, parts);
  std::vector<double> out;
  for (const PartPose& part : parts)
  {
    out.insert(out.end(), part.position.data(), part.position.data() + 3);
    const Eigen::Vector4d turn = part.orientation.coeffs();
    out.insert(out.end(), turn.data(), turn.data() + 4);
  }
  return out;
}

/// The last frame's truth and readings are finite.
inline void check_signals(const Simulator& rig)
{
  check(all_finite(numbers_of(rig.truth())), "the truth is not finite");
  check(all_finite(numbers_of(rig.readings())), "a reading is not finite");
  check(std::abs(rig.truth().bit_orientation.norm() - 1.0) < 1e-6, "the bit's orientation is no rotation");
}

/// What is reported less often is finite too: along the string, of its parts, of the path, and of what the next frame starts
/// from.
inline void check_reports(const Simulator& rig)
{
  check(all_finite(numbers_along(rig)), "the profile is not finite");
  check(all_finite(numbers_of_parts(rig)), "a part's pose is not finite");
  std::vector<Eigen::Vector3d> path;
  rig.raw_path(path);
  std::vector<double> numbers;
  append(numbers, path);
  check(all_finite(numbers), "the raw path is not finite");
  check(all_finite(numbers_of(rig.save()->mechanics)), "the state is not finite");
  check(std::isfinite(rig.statistics().last_error_estimate), "the error estimate is not finite");
}

/// All that is compared bit by bit after a snapshot was restored.
inline std::vector<double> everything(const Simulator& rig)
{
  std::vector<double> out = numbers_of(rig.truth());
  append(out, numbers_of(rig.readings()));
  append(out, numbers_of(rig.save()->mechanics));
  append(out, numbers_along(rig));
  append(out, numbers_of_parts(rig));
  return out;
}

}  // namespace fuzz
}  // namespace drill_rig_sim

#endif
