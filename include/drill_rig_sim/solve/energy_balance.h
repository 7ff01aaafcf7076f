#ifndef DRILL_RIG_SIM_SOLVE_ENERGY_BALANCE_H
#define DRILL_RIG_SIM_SOLVE_ENERGY_BALANCE_H

#include <vector>

#include "drill_rig_sim/rig/setpoints.h"
#include "drill_rig_sim/system/energy_accounts.h"
#include "drill_rig_sim/system/system.h"

namespace drill_rig_sim
{
/// Books the energy of every step of a fixed-step method (energy_accounts.h says how). It looks only: the run is the same with and without
/// it, at some three more residuals a step. Allocates on construction.
class EnergyBalance
{
public:
  /// Opens the balance for runs of `system` from `state`; `state` is not kept.
  EnergyBalance(System& system, const SystemState& state);

  /// Before System::begin() of a step from `state`. A step that is given up is begun again.
  void begin_step(const SystemState& state, const Setpoints& setpoints) noexcept;
  /// The step was solved: after System::settle() at its end and before System::finish().
  void end_step() noexcept;
  /// The next step does not start where the last one ended: opens the balance anew.
  void restart() noexcept;

  const EnergyAccounts& accounts() const noexcept { return accounts_; }

private:
  void book_jump() noexcept;
  void book_inputs() noexcept;
  void book_dissipation() noexcept;
  void book_numerical() noexcept;
  double work_in_time(NodeForce kind) const noexcept;
  double work_along(NodeForce kind) const noexcept;

  System& system_;
  EnergyAccounts accounts_;
  bool opened_ = false;
  StoredEnergy start_;     // of this step
  EnergySample before_;    // end of the last step
  EnergySample after_;     // end of this one
  std::vector<double> no_increment_;
};

}  // namespace drill_rig_sim

#endif
