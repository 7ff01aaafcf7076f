// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_MODEL_CUTTINGS_STATE_H
#define DRILL_RIG_SIM_MODEL_CUTTINGS_STATE_H

#include <vector>

namespace drill_rig_sim
{
/// Cuttings along the hole (model/hole_cleaning.h), by cells of one length from the rotary table down. Without mud.cuttings there
/// are no cells.
struct CuttingsState
{
  double cell_length = 0.0;       ///< [m]
  std::vector<double> suspended;  ///< volume of rock in the flow, by cell [m3]
  std::vector<double> bed;        ///< and in the bed [m3]
  std::vector<double> friction;   ///< factor of the bed on the wall's friction, by cell [-]
  bool drags = false;             ///< whether one of them is not 1
  double load = 0.0;              ///< weight of what is suspended, at the bit [Pa]
  double narrowing = 1.0;         ///< factor of the bed on the annulus's losses [-]
  double bed_height = 0.0;        ///< largest along the hole [m]
  double drilled = 0.0;           ///< volume of rock since the start [m3]
  double returned = 0.0;          ///< of it at the flow line [m3]
  // since the cells were last advanced
  double elapsed = 0.0;     ///< [s]
  double pumped = 0.0;      ///< volume of mud up the annulus [m3]
  double angle = 0.0;       ///< the drive's, then [rad]
  double hole_depth = 0.0;  ///< then [m]

  template <class V>
  void visit(V& v)
  {
    v("cell_length", cell_length);
    v("suspended", suspended);
    v("bed", bed);
    v("friction", friction);
    v("drags", drags);
    v("load", load);
    v("narrowing", narrowing);
    v("bed_height", bed_height);
    v("drilled", drilled);
    v("returned", returned);
    v("elapsed", elapsed);
    v("pumped", pumped);
    v("angle", angle);
    v("hole_depth", hole_depth);
  }
};

}  // namespace drill_rig_sim

#endif
