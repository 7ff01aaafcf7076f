#ifndef DRILL_RIG_SIM_SRC_SIM_SIMULATOR_IMPL_H
#define DRILL_RIG_SIM_SRC_SIM_SIMULATOR_IMPL_H

#include "drill_rig_sim/sim/accuracy_watch.h"
#include "drill_rig_sim/sim/level_watch.h"
#include "drill_rig_sim/sim/simulator.h"
#include "drill_rig_sim/sim/simulator_state.h"
#include "drill_rig_sim/sim/string_watch.h"
#include "drill_rig_sim/solve/energy_balance.h"
#include "drill_rig_sim/solve/integrator.h"
#include "drill_rig_sim/solve/start.h"

namespace drill_rig_sim
{
/// Place between two nodes at an unstretched distance from the bit's face.
struct Between
{
  int lower;
  double share;  // 0 at the lower node, 1 at the next one up
};
Between find_between(const Mesh& mesh, double from_bit) noexcept;

/// Throws std::runtime_error with one line if the scene asks for what is not available.
const Scene& available(const Scene& scene);

struct Simulator::Impl
{
  Scene scene;
  std::shared_ptr<const Model> model;
  SimulatorState state;
  std::unique_ptr<Integrator> integrator;
  std::unique_ptr<EnergyBalance> balance;
  StringWatch watch;
  AccuracyWatch accuracy;
  LevelWatch levels;
  SimulatorStatistics statistics;
  double command_timeout = 0.0;
  const char* failure = "";

  Impl(const Scene& s, std::uint64_t seed) : Impl(s, seed, build_at_rest(available(s))) {}
  Impl(const Scene& s, std::uint64_t seed, RigAtRest&& rig);
  State& mechanics() { return state.mechanics; }
  template <class Setpoint>
  CommandResult command(const Setpoint& c) noexcept;
  void shift_time(double now) noexcept;
  void measure() noexcept;
  void measure_rig() noexcept;
  void measure_bit() noexcept;
  void measure_string() noexcept;
  double motor_pressure() const noexcept;
  void pump(double commanded, double step) noexcept;
  SensorView sensor_view() const noexcept;
};

}  // namespace drill_rig_sim

#endif
