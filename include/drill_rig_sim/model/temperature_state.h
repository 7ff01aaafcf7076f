// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_MODEL_TEMPERATURE_STATE_H
#define DRILL_RIG_SIM_MODEL_TEMPERATURE_STATE_H

#include <vector>

#include "drill_rig_sim/hydraulics/hydraulics.h"
#include "drill_rig_sim/hydraulics/mud_heat.h"

namespace drill_rig_sim
{
/// Sums along a section of bore or annulus.
struct SectionMean
{
  double length = 0.0;   ///< [m]
  double factor = 0.0;   ///< on the flow curve, times length [m]
  double density = 0.0;  ///< over the reference's, times length [m]

  template <class V>
  void visit(V& v)
  {
    v("length", length);
    v("factor", factor);
    v("density", density);
  }
};

/// Temperature along the hole (model/mud_temperature.h), by cells of one length from the rotary table down. Without
/// mud.temperature there are no cells.
struct TemperatureState
{
  double cell_length = 0.0;  ///< [m]
  HeatState heat;
  int opened = 0;                                ///< cells that the hole has reached
  std::vector<SectionMean> in_bore, in_annulus;  ///< by section of the losses
  LossPlaces losses;                             ///< what it makes of the losses
  WarmHeads heads;                               ///< and of the mud's weight
  double bit = 0.0;                              ///< of the mud around the bit [degC]
  double flow_line = 0.0;                        ///< of the mud that returns [degC]
  // since the cells were last advanced
  double elapsed = 0.0;  ///< [s]
  double pumped = 0.0;   ///< volume of mud through the bit [m3]

  bool any() const noexcept { return opened > 0; }
  /// For MudWays.
  const LossPlaces* places() const noexcept { return any() ? &losses : nullptr; }

  template <class V>
  void visit(V& v)
  {
    v("cell_length", cell_length);
    v("heat", heat);
    v("opened", opened);
    v("in_bore", in_bore);
    v("in_annulus", in_annulus);
    v("losses", losses);
    v("heads", heads);
    v("bit", bit);
    v("flow_line", flow_line);
    v("elapsed", elapsed);
    v("pumped", pumped);
  }
};

}  // namespace drill_rig_sim

#endif
