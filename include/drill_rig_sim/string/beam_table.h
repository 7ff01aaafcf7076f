// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_STRING_BEAM_TABLE_H
#define DRILL_RIG_SIM_STRING_BEAM_TABLE_H

#include <vector>

#include "drill_rig_sim/string/beam_element.h"

namespace drill_rig_sim
{
/// What `numerics.element` can be; automatic is the first line of beam_table().
enum class ElementKind
{
  automatic,
  corotational,
  geometrically_exact,
  rotation_vector
};

/// A kind of beam element: forces, and forces with tangent, as in beam_element.h. A new kind is a file with these two functions,
/// a line in beam_table() and its word among the scene's keys.
struct BeamKind
{
  ElementKind kind;
  const char* name;
  const char* description;
  BeamForces (*forces)(const BeamSection&, const BeamPose&, const BeamDamping&, const Eigen::Vector3d& load,
                       BeamStrain&) noexcept;
  BeamForces (*forces_and_tangent)(const BeamSection&, const BeamPose&, const BeamDamping&, const Eigen::Vector3d& load,
                                   BeamStrain&, BeamTangent&) noexcept;
  /// U [J], whose gradient the forces are at no damping and no load.
  double (*energy)(const BeamSection&, const BeamPose&) noexcept;
  bool load_moments;  ///< a dead load has end moments, as in beam_element.h, not only its halves on the ends
};

/// To compare with (compared/rotation_vector_beam.h).
extern const BeamKind rotation_vector_beam;

const std::vector<BeamKind>& beam_table();
const BeamKind& find_beam(ElementKind kind) noexcept;

}  // namespace drill_rig_sim

#endif
