#ifndef DRILL_RIG_SIM_STRING_BEAM_TABLE_H
#define DRILL_RIG_SIM_STRING_BEAM_TABLE_H

#include <string>
#include <vector>

#include "drill_rig_sim/string/beam_element.h"

namespace drill_rig_sim
{
/// A kind of beam element: forces, and forces with tangent, as in beam_element.h. A new kind is a file with these two functions and a
/// line in beam_table().
struct BeamKind
{
  const char* name;
  const char* description;
  BeamForces (*forces)(const BeamSection&, const BeamPose&, const BeamDamping&, const Eigen::Vector3d& load, BeamStrain&) noexcept;
  BeamForces (*forces_and_tangent)(const BeamSection&, const BeamPose&, const BeamDamping&, const Eigen::Vector3d& load, BeamStrain&,
                                   BeamTangent&) noexcept;
  /// U [J], whose gradient the forces are at no damping and no load.
  double (*energy)(const BeamSection&, const BeamPose&) noexcept;
  bool load_moments;  ///< a dead load has end moments, as in beam_element.h, not its halves on the ends alone
};

const std::vector<BeamKind>& beam_table();
/// Null for an unknown name; "auto" is the first line, the default.
const BeamKind* find_beam(const std::string& name);

}  // namespace drill_rig_sim

#endif
