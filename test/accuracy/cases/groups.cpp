#include "groups.h"

#include "report.h"

namespace drill_rig_sim
{
const std::vector<CaseGroup>& case_groups()
{
  static const std::vector<CaseGroup> groups = {
      {"surveys", true, survey_cases},
      {"torque_and_drag", true, torque_and_drag_cases},
      {"vibrations", true, vibration_cases},
      {"detournay", true, detournay_cases},
      {"whirl", true, whirl_cases},
      {"stick_slip", true, stick_slip_cases},
      {"buckling", true, buckling_cases},
      {"bent_motor", true, bent_motor_cases},
      {"stick_slip_well_a", false, stick_slip_well_a_cases},
      {"beams", true, beam_cases},
      {"reference", true, reference_cases},
      {"energy_small", true, small_energy_cases},
      {"energy", false, energy_cases},
  };
  return groups;
}

}  // namespace drill_rig_sim
