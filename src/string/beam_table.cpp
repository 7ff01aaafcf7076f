// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/string/beam_table.h"

#include "drill_rig_sim/string/geometrically_exact_beam.h"

namespace drill_rig_sim
{
const std::vector<BeamKind>& beam_table()
{
  static const std::vector<BeamKind> table = {
      {ElementKind::corotational, "corotational", "cubic in a frame along the chord", beam_forces, beam_forces, beam_energy,
       true},
      {ElementKind::geometrically_exact, "geometrically_exact", "rigid-section strains, relative rotation interpolated",
       geometrically_exact_forces, geometrically_exact_forces, geometrically_exact_energy, false},
      rotation_vector_beam,
  };
  return table;
}

const BeamKind& find_beam(ElementKind kind) noexcept
{
  for (const BeamKind& beam : beam_table())
    if (kind == beam.kind) return beam;
  return beam_table().front();
}

}  // namespace drill_rig_sim
