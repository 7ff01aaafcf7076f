#ifndef DRILL_RIG_SIM_TEST_BEAM_KINDS_H
#define DRILL_RIG_SIM_TEST_BEAM_KINDS_H

#include <Eigen/Core>

#include "drill_rig_sim/string/beam_table.h"
#include "drill_rig_sim/string/rotation_vector_beam.h"

/// The kinds of beam element by name, and a pipe to try them on.
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

}  // namespace drill_rig_sim

#endif
