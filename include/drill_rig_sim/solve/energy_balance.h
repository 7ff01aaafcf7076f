// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SOLVE_ENERGY_BALANCE_H
#define DRILL_RIG_SIM_SOLVE_ENERGY_BALANCE_H

#include <memory>
#include <vector>

#include "drill_rig_sim/model/energy_accounts.h"
#include "drill_rig_sim/model/stage.h"
#include "drill_rig_sim/model/workspace.h"

namespace drill_rig_sim
{
/// Books the energy of every step of a method (energy_accounts.h says how). It looks only: the run is the same with and without
/// it, at some three more residuals a step. Allocates on construction.
class EnergyBalance
{
public:
  explicit EnergyBalance(std::shared_ptr<const Model> model);

  /// Before a step from `state`. A step that is given up is begun again.
  void begin_step(const State& state, const Setpoints& setpoints) noexcept;
  /// The step from `start` was solved by the increments u (6 per node) of `stage`, its last; not committed yet. A method that
  /// takes steps of its own within this one calls it after each of them, the increments always since `start`.
  void end_step(const State& start, const Stage& stage, const double* u) noexcept;
  /// The next step does not start where the last one ended: opens the balance anew.
  void restart() noexcept;

  /// Continues the accounts of another string. The energy difference at the next start is booked as `handled` (pipe added or
  /// removed).
  void go_on_from(const EnergyBalance& before) noexcept;

  const EnergyAccounts& accounts() const noexcept { return accounts_; }

private:
  void open(const State& state) noexcept;
  void begin_accounts() noexcept;
  void find_reshaped(const State& state) noexcept;
  void find_loads(const State& state) noexcept;
  void count_from_last_part() noexcept;
  void book_jump() noexcept;
  void book_loads() noexcept;
  void book_inputs() noexcept;
  void book_dissipation() noexcept;
  void book_numerical() noexcept;
  double work_in_time(NodeForce kind) const noexcept;
  double work_of_step(NodeForce kind) const noexcept;
  double work_along(NodeForce kind) const noexcept;
  double work_at_pivot(Eigen::Vector3d ShaftSample::*moment) const noexcept;

  std::shared_ptr<const Model> model_;
  Stage stage_;
  Workspace work_;
  EnergyAccounts accounts_;
  bool opened_ = false;
  bool goes_on_ = false;  // opened with accounts of a string before
  StoredEnergy start_;    // of this step
  EnergySample before_;   // end of the last step
  EnergySample after_;    // end of this one
  // what the step has come to at the last call of end_step()
  struct Part
  {
    double time = 0.0, line_paid_out = 0.0, floor_moved = 0.0, rotor_increment = 0.0, rock_advance = 0.0;
    Eigen::Vector3d shaft_turn = Eigen::Vector3d::Zero();
    std::vector<double> increment;
  };
  Part part_;
  // what acts on an element and is constant in a step: weight in mud [N], and what the annulus's pressure lifts it by, world axes
  // [N]
  struct ElementLoad
  {
    double weight = 0.0;
    Eigen::Vector3d lift = Eigen::Vector3d::Zero();
  };
  std::vector<ElementLoad> loads_before_, loads_;
  std::vector<double> no_increment_;
  std::vector<double> pressure_;  // of the elements: stretch that the pump's pressure made of them in the last step [-]
  double reshaped_ = 0.0;         // lost by the beams since then for other reasons [J]
};

}  // namespace drill_rig_sim

#endif
