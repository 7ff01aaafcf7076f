#ifndef DRILL_RIG_SIM_SCENE_INSTRUMENTS_SPEC_H
#define DRILL_RIG_SIM_SCENE_INSTRUMENTS_SPEC_H

namespace drill_rig_sim
{
struct SensorSpec
{
  double noise = 0.0;        ///< standard deviation [unit of the signal]
  double bias = 0.0;         ///< [unit of the signal]
  double delay = 0.0;        ///< [s]
  double filter_time = 0.0;  ///< first-order time constant [s]
  double resolution = 0.0;   ///< steps in which it shows [unit of the signal]; 0 = none
};

/// Where the hook load is measured.
enum class HookLoadPlace
{
  block,     ///< between block and lines: the load itself
  dead_line  ///< at the dead line's anchor: the friction of the sheaves is in it
};

struct HookLoadSpec : SensorSpec
{
  HookLoadPlace place = HookLoadPlace::dead_line;
};

/// Readings on their way from the tool to the surface at most: more are lost, as where telemetry is saturated.
constexpr int most_on_the_way = 32;

struct MwdSpec
{
  double period = 30.0;                 ///< between surveys [s]; 0 = only after a pumps-off/on cycle
  double latency = 8.0;                 ///< measurement to surface [s]
  double inclination_resolution = 0.0;  ///< [rad]
  double noise = 0.0;                   ///< standard deviation of inclination and azimuth [rad]
  double scribe_offset = 0.0;           ///< added to the sensor's toolface to name the bend's [rad]
};

struct ToolfaceSpec
{
  double period = 10.0;  ///< [s]
  double latency = 4.0;  ///< [s]
};

struct InstrumentsSpec
{
  MwdSpec mwd;
  ToolfaceSpec toolface;
  HookLoadSpec hook_load;          ///< [N]
  SensorSpec torque;               ///< torque meter [N m]
  SensorSpec stand_pipe_pressure;  ///< [Pa]
  SensorSpec flow;                 ///< [m3/s]
  SensorSpec block_height;         ///< [m]
};

}  // namespace drill_rig_sim

#endif
