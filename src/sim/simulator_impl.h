#ifndef DRILL_RIG_SIM_SRC_SIM_SIMULATOR_IMPL_H
#define DRILL_RIG_SIM_SRC_SIM_SIMULATOR_IMPL_H

#include "drill_rig_sim/crew/refusals.h"
#include "drill_rig_sim/sim/accuracy_watch.h"
#include "drill_rig_sim/sim/choice.h"
#include "drill_rig_sim/sim/level_watch.h"
#include "drill_rig_sim/sim/simulator.h"
#include "drill_rig_sim/sim/simulator_state.h"
#include "drill_rig_sim/sim/string_watch.h"
#include "drill_rig_sim/solve/energy_balance.h"
#include "drill_rig_sim/solve/integrator.h"
#include "drill_rig_sim/solve/start.h"
#include "frame_queue.h"

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
  std::uint64_t seed;
  std::string choice;  // why level auto is what it is; empty for other levels
  std::shared_ptr<const Model> model;
  SimulatorState state;
  std::unique_ptr<Integrator> integrator;
  std::unique_ptr<EnergyBalance> balance;
  std::unique_ptr<EnergyBalance> balance_before;  // as it was at the start of the stride under way
  StringWatch watch;
  LevelWatch levels;
  SimulatorStatistics statistics;
  const bool variable;  // steps, numerics.step 0
  // while a stride is under way: its end, and what the last frame shows
  State stride_end, between;
  RigForces end_forces, forces_between;
  int below_stand = -1;  // node at which the crew would take a stand away; -1: none
  double command_timeout = 0.0;
  const char* failure = "";
  std::vector<std::unique_ptr<Impl>> companions;  // other models of the same rig, led by this one; the first measures its error if numerics.companion asks for it
  CompanionPace pace = CompanionPace::in_turn;
  std::unique_ptr<FrameQueue> queue;    // of frames for them; null without any. Its thread ends before they do

  Impl(const Scene& s, std::uint64_t seed_of_noise) : Impl(s, seed_of_noise, build_at_rest(s)) {}
  Impl(const Scene& s, std::uint64_t seed_of_noise, RigAtRest&& rig);
  State& mechanics() { return state.mechanics; }
  /// What the last frame shows, in whose forces also.
  const State& shown() const noexcept { return state.stride.length > 0.0 ? between : state.mechanics; }
  const RigForces& shown_forces() const noexcept { return state.stride.length > 0.0 ? forces_between : state.forces; }
  double now() const noexcept { return state.mechanics.time + state.stride.played; }
  double hole_depth() const noexcept;
  bool compute_frame(double duration, const Setpoints& setpoints) noexcept;
  void count_frame() noexcept;
  bool advance_frame(double duration, const Setpoints& setpoints) noexcept;
  bool take_steps(double step, int steps, const Setpoints& setpoints) noexcept;
  bool advance_in_strides(double duration, const Setpoints& setpoints) noexcept;
  bool begin_stride(double duration) noexcept;
  bool solve_stride() noexcept;
  void show_stride() noexcept;
  bool settle() noexcept;
  template <class Setpoint>
  CommandResult command(const Setpoint& c, const char* lock) noexcept;
  /// Set points that act: those asked for, after their dead times, but for what the watchdog, interlocks and faults make of them.
  Setpoints in_force() const noexcept
  {
    return restrained(state.delay.is_on() ? state.delay.passed() : state.commands.in_force(), state.interlocks, state.mechanics.faults);
  }
  void shift_time(double now) noexcept;
  void steer() noexcept;
  void measure() noexcept;
  void measure_rig() noexcept;
  void measure_bit() noexcept;
  void measure_string() noexcept;
  void measure_block() noexcept;
  void measure_string_built() noexcept;
  double motor_pressure() const noexcept;
  SensorView sensor_view() const noexcept;
  /// What slips, connections and commands are refused by.
  StringAtTable at_table() const noexcept;
  bool broken_out_by_hand() const noexcept { return state.connection.under_way && state.crew.doing == CrewTask::none; }
  void tell_string_built() noexcept;
  const char* set_slips(int joint) noexcept;
  void grip(int joint) noexcept;
  void release_slips() noexcept;
  const char* pull_slips() noexcept;
  const char* make_connection(int joints, bool remove) noexcept;
  const char* try_connection(double length) noexcept;
  const char* begin_connection(double length);
  void end_connection();
  void take_string(std::shared_ptr<const Model> longer);
  std::shared_ptr<const Model> model_of(const StringBuilt& string) const;
  double free_length_of(const Model& longer) const noexcept;
  void find_stand();
  void note_ring();
  double rest_load() const noexcept;
  void begin_fault(const Fault& fault) noexcept;
  void end_fault(FaultKind kind) noexcept;
  bool tare() noexcept;
  bool tare_over(double duration, Zero& zero) noexcept;
  void take_zero(double hook_load) noexcept;
  bool restore(const SimulatorState& saved, bool keep_time);
  void collect_all() noexcept;
  void restore_companions(const SimulatorState& saved, bool keep_time);
  WinchSetpoint to_slack(double frame) const noexcept;
  void crew_begins() noexcept;
  void crew_works(double frame) noexcept;
  void crew_does(CrewTask task) noexcept;
  void crew_goes_on(double height) noexcept;
  bool crew_has_done(double frame, WinchSetpoint& winch) noexcept;
  SubView sub_view() const noexcept;
  /// The error is measured beside a companion that still goes along.
  bool measures() const noexcept { return measured_by_companion() && !state.companion_ended; }
  bool measured_by_companion() const noexcept { return scene.numerics.companion != CompanionKind::none && !companions.empty(); }
  /// Their thread was too slow, and frames are no longer ordered.
  bool companions_given_up() const noexcept { return state.companion_ended && pace == CompanionPace::own_thread_unwaited; }
  void order_frame(double duration, const Setpoints& setpoints) noexcept;
  void collect() noexcept;
  void judge(double duration) noexcept;
  void compare_frames() noexcept;
  void end_measurement(const char* reason) noexcept;
  Outputs judged() const noexcept;
  void companions_follow(FrameOrder& order) noexcept;
  /// Of a companion, for the run's statistics.
  CompanionStatistics as_companion() const noexcept { return {statistics.level, statistics.nodes, statistics.coordinates, statistics.costs.seconds()}; }
  void follow(const FrameOrder& order) noexcept;
  template <class Does>
  void lead(const Does& does) noexcept;
};

/// Does something to all companions that still go along, after the frames that they have to compute.
template <class Does>
void Simulator::Impl::lead(const Does& does) noexcept
{
  if (companions.empty() || companions_given_up()) return;
  queue->wait_for_all();
  for (const std::unique_ptr<Impl>& companion : companions)
    if (!*companion->failure) does(*companion);
}

}  // namespace drill_rig_sim

#endif
