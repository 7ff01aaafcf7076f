// SPDX-License-Identifier: BSD-3-Clause
#include "groups.h"

#include "report.h"

namespace drill_rig_sim
{
const std::vector<CaseGroup>& case_groups()
{
  static const std::vector<CaseGroup> groups = {
      {"surveys", When::fast_with_data, survey_cases},
      {"torque_and_drag", When::fast, torque_and_drag_cases},
      {"vibrations", When::fast, vibration_cases},
      {"detournay", When::fast, detournay_cases},
      {"whirl", When::fast, whirl_cases},
      {"stick_slip", When::fast, stick_slip_cases},
      {"buckling", When::fast, buckling_cases},
      {"bent_motor", When::fast_with_data, bent_motor_cases},
      {"sliding", When::slow, sliding_cases},
      {"stick_slip_well_a", When::slow, stick_slip_well_a_cases},
      {"beams", When::fast, beam_cases},
      {"reference", When::fast, reference_cases},
      {"energy_small", When::fast, small_energy_cases},
      {"energy", When::slow, energy_cases},
  };
  return groups;
}

}  // namespace drill_rig_sim
