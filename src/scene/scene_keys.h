// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_SCENE_SCENE_KEYS_H
#define DRILL_RIG_SIM_SRC_SCENE_SCENE_KEYS_H

#include "drill_rig_sim/scene/scene.h"
#include "drill_rig_sim/scene/survey_format.h"
#include "drill_rig_sim/well/tie_in.h"
#include "key_table.h"

/// THE table of the scene file: key, unit, field (its initialiser in scene.h is the default), allowed range, meaning.
/// It drives the reader's checks, the defaults and the scene reference of config/README.md.
namespace drill_rig_sim
{
/// Bit of a kind for the columns `required` and `kinds`.
template <class Enum>
constexpr unsigned kind(Enum e)
{
  return 1u << static_cast<unsigned>(e);
}

/// The words of an enumeration in the order of its enumerators.
extern const std::vector<const char*> part_type_words;
extern const std::vector<const char*> bit_torque_words;
extern const std::vector<const char*> need_words;
extern const std::vector<const char*> level_words;
extern const std::vector<const char*> integrator_words;
extern const std::vector<const char*> element_words;
extern const std::vector<const char*> kernel_words;
extern const std::vector<const char*> stribeck_curve_words;
extern const std::vector<const char*> hook_load_place_words;
extern const std::vector<const char*> rheology_words;
extern const std::vector<const char*> operation_words;

/// The unit of a gauge's signal.
const char* unit_of(Gauge gauge) noexcept;
/// The unit of a fault's magnitude, of the gauge where it is a sensor's; "": it is a factor, or there is none.
std::string unit_of(FaultKind fault, Gauge gauge);
/// The same by the words of a program's line: its fault and the gauge that it is of; "" where the fault is not known.
std::string unit_of(const std::string& fault, const std::string& gauge);

extern const Table<Scene> scene_keys;
extern const Table<WellSpec> well_keys;
/// The kinds of survey_keys: a scene names its survey's file, the command line has it by itself.
constexpr unsigned survey_of_scene = 1u, survey_of_command = 2u;
extern const Table<SurveyFormat> survey_keys;
extern const Table<SurveyFormat> survey_columns_keys;
extern const Table<SurveyColumn> survey_column_keys;
extern const Table<SurveyQuality> survey_quality_keys;
extern const Table<TieIn> tie_in_keys;
extern const Table<HoleSection> section_keys;
extern const Table<FormationLayer> layer_keys;
extern const Table<MudSpec> mud_keys;
extern const Table<RheologySpec> rheology_keys;
extern const Table<CuttingsSpec> cuttings_keys;
extern const Table<PressureWavesSpec> pressure_waves_keys;
extern const Table<MudTemperatureSpec> temperature_keys;
extern const Table<PartSpec> part_keys;
extern const Table<ContactLaw> part_contact_keys;
extern const Table<ContactLaw> bit_bottom_keys;
extern const Table<BitTorqueSpec> bit_torque_keys;
extern const Table<RigSpec> rig_keys;
extern const Table<HoistingSpec> hoisting_keys;
extern const Table<TopDriveSpec> top_drive_keys;
extern const Table<DriveImpedance> soft_torque_keys;
extern const Table<DriveImpedance> z_torque_keys;
extern const Table<MudPumpSpec> mud_pump_keys;
extern const Table<HeaveSpec> heave_keys;
extern const Table<ContactSpec> contact_keys;
extern const Table<TrajectorySpec> trajectory_keys;
extern const Table<StartSpec> start_keys;
extern const Table<NumericsSpec> numerics_keys;
extern const Table<InstrumentsSpec> instruments_keys;
extern const Table<MwdSpec> mwd_keys;
extern const Table<ToolfaceSpec> toolface_keys;
extern const Table<DynamicsSpec> dynamics_keys;
extern const Table<InstrumentsSpec> surface_keys;
extern const Table<HookLoadSpec> hook_load_keys;
extern const Table<PressureSpec> pressure_keys;
extern const Table<SensorSpec> sensor_keys;
/// The keys of a gauge.
inline const Table<HookLoadSpec>& keys_of(const HookLoadSpec&)
{
  return hook_load_keys;
}
inline const Table<PressureSpec>& keys_of(const PressureSpec&)
{
  return pressure_keys;
}
inline const Table<SensorSpec>& keys_of(const SensorSpec&)
{
  return sensor_keys;
}
extern const Table<ProgramStep> program_keys;
extern const Table<Operation> operation_keys;

}  // namespace drill_rig_sim

#endif
