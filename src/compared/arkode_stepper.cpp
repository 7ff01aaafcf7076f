// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/compared/arkode_stepper.h"

#include <sunnonlinsol/sunnonlinsol_newton.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "drill_rig_sim/math/rotation.h"
#include "drill_rig_sim/model/evaluate.h"
#include "drill_rig_sim/model/forces/inertia.h"
#include "drill_rig_sim/model/forces/top_drive.h"
#include "drill_rig_sim/solve/methods/method.h"
#include "drill_rig_sim/solve/vector_operations.h"
#include "../solve/sundials.h"

#if SUNDIALS_VERSION_MAJOR >= 6
// SUNDIALS 7.1 has new names (ARKodeSet...) for these functions, and 6 has the old names only.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wdeprecated-declarations"

namespace drill_rig_sim
{
namespace
{
struct FreeArkode
{
  void operator()(void* memory) const { ARKStepFree(&memory); }
};
struct FreeTable
{
  void operator()(ARKodeButcherTable table) const { ARKodeButcherTable_Free(table); }
};

using Vector = Eigen::Map<Eigen::VectorXd>;
using ConstVector = Eigen::Map<const Eigen::VectorXd>;

/// What later stages need of a finished one.
struct StageRecord
{
  double time = 0.0;  ///< since the step's start [s]
  Eigen::VectorXd u, rate, acceleration;
  double drive_speed = 0.0, drive_acceleration = 0.0;
};
}  // namespace

class ArkodeStepper::Session
{
public:
  Session(const Model& model, Stage& stage, Workspace& work);
  /// The step's end in stage and workspace, ready for commit(). False: not solved.
  bool step(const State& state, double step, int budget);

  const Model& model;
  Stage& stage;
  Workspace& work;
  NewtonLimits limits;
  int iterations = 0;  // of the last step()
  const double* increments() const { return u_of(y_.get()); }

private:
  void create();
  void set_linear_solver();
  void take_start(const State& state);
  void prepare_stage();
  void set_stage(const double* y, double c) noexcept;
  int rates_at_start(const double* y, double* rate);
  int right_hand_side(const double* y, double* rate, double c, BlockTridiagonal* tangent) noexcept;
  void predict_stage(double* y);
  void record_stage(const double* y);
  int solve(const double* r, double* d) noexcept;
  int judge() noexcept;
  double* u_of(N_Vector y) const { return N_VGetArrayPointer(y); }
  int size() const { return 6 * model.nodes(); }

  const State* start_ = nullptr;
  double step_ = 0.0;
  int budget_ = 0;
  bool start_known_ = false;  // stages_[0] is complete
  int current_ = 0;           // stage
  double c_ = 0.0;            // 1/gamma
  std::vector<StageRecord> stages_;
  Eigen::VectorXd rate_sum_, acceleration_sum_;  // of the stages before, weighted by the table [1], [1/s]
  std::vector<double> residual_, right_;
  BlockTridiagonal tangent_;
  double increment_ = 0.0, increment_before_ = 0.0;
  // destroyed in the opposite order
  OwnedContext context_;
  std::unique_ptr<ARKodeButcherTableMem, FreeTable> table_;
  OwnedVector y_;
  OwnedLinearSolver linear_;
  OwnedNonlinearSolver nonlinear_;
  std::unique_ptr<void, FreeArkode> memory_;
};

ArkodeStepper::Session::Session(const Model& m, Stage& s, Workspace& w)
    : model(m), stage(s), work(w), residual_(6 * m.nodes()), right_(6 * m.nodes())
{
  tangent_.resize(model.nodes(), model.kernel());
  limits.tolerance = model.scene().numerics.newton_tolerance;
  context_ = new_context();
  if (!context_) throw std::runtime_error("ARKODE: SUNDIALS gives no context");
  table_.reset(ARKodeButcherTable_LoadDIRK(ARKODE_TRBDF2_3_3_2));
  y_ = new_vector(2 * size(), context_.get());
  if (!table_ || !y_) throw std::runtime_error("ARKODE: SUNDIALS gives no table or vector");
  stages_.resize(static_cast<std::size_t>(table_->stages));
  vectorise_operations(y_.get());
  N_VConst(0.0, y_.get());
  create();
}

void ArkodeStepper::Session::create()
{
  memory_.reset(ARKStepCreate(
      nullptr,
      [](double, N_Vector y, N_Vector rate, void* data)
      { return static_cast<Session*>(data)->rates_at_start(N_VGetArrayPointer(y), N_VGetArrayPointer(rate)); },
      0.0, y_.get(), context_.get()));
  void* const arkode = memory_.get();
  bool good = arkode != nullptr;
  auto set = [&good](int flag) { good = good && flag == ARK_SUCCESS; };
  silence_arkode(arkode);
  set(ARKStepSetUserData(arkode, this));
  set(ARKStepSetTables(arkode, table_->q, table_->p, table_.get(), nullptr));
  set(ARKStepSetInterpolantType(arkode, ARK_INTERP_LAGRANGE));  // Hermite's would take one more residual a step
  set(ARKStepSetDeduceImplicitRhs(arkode, SUNTRUE));            // and so would a stage's rates by evaluation
  set(ARKStepWFtolerances(arkode,
                          [](N_Vector, N_Vector weight, void*)
                          {
                            N_VConst(1.0, weight);  // not looked at: fixed step, own criterion
                            return 0;
                          }));
  set(ARKStepSetMaxNonlinIters(arkode, limits.max_iterations));
  nonlinear_.reset(SUNNonlinSol_Newton(y_.get(), context_.get()));
  set(ARKStepSetNonlinearSolver(arkode, nonlinear_.get()));
  set(SUNNonlinSolSetConvTestFn(
      nonlinear_.get(),
      [](SUNNonlinearSolver, N_Vector, N_Vector, double, N_Vector, void* data) { return static_cast<Session*>(data)->judge(); },
      this));
  set_linear_solver();
  set(ARKStepSetLinearSolver(arkode, linear_.get(), nullptr));
  set(ARKStepSetEpsLin(arkode, 1e-200));  // a right-hand side below it would count as solved without a look
  set(ARKStepSetNlsRhsFn(arkode,
                         [](double, N_Vector y, N_Vector rate, void* data)
                         {
                           auto* session = static_cast<Session*>(data);
                           return session->right_hand_side(N_VGetArrayPointer(y), N_VGetArrayPointer(rate), session->c_,
                                                           &session->tangent_);
                         }));
  set(ARKStepSetStagePredictFn(arkode,
                               [](double, N_Vector y, void* data)
                               {
                                 static_cast<Session*>(data)->predict_stage(N_VGetArrayPointer(y));
                                 return 0;
                               }));
  set(ARKStepSetPostprocessStageFn(arkode,
                                   [](double, N_Vector y, void* data)
                                   {
                                     static_cast<Session*>(data)->record_stage(N_VGetArrayPointer(y));
                                     return 0;
                                   }));
  if (!good) throw std::runtime_error("ARKODE: SUNDIALS refuses its settings");
}

/// Matrix-embedded: the tangent is there since Newton's residual at the same place.
void ArkodeStepper::Session::set_linear_solver()
{
  linear_ = new_linear_solver(context_.get());
  if (!linear_) throw std::runtime_error("ARKODE: SUNDIALS gives no linear solver");
  linear_->content = this;
  linear_->ops->gettype = [](SUNLinearSolver) { return SUNLINEARSOLVER_MATRIX_EMBEDDED; };
  linear_->ops->free = free_without_content;
  linear_->ops->getid = [](SUNLinearSolver) { return SUNLINEARSOLVER_CUSTOM; };
  linear_->ops->solve = [](SUNLinearSolver solver, SUNMatrix, N_Vector d, N_Vector r, double)
  { return static_cast<Session*>(solver->content)->solve(N_VGetArrayPointer(r), N_VGetArrayPointer(d)); };
}

void ArkodeStepper::Session::take_start(const State& state)
{
  start_ = &state;
  current_ = 0;
  start_known_ = false;
  StageRecord& first = stages_[0];
  first.rate.resize(size());
  for (int i = 0; i < model.nodes(); ++i)
    first.rate.segment<6>(6 * i) = in_step_axes(state.nodes[i].rate, x_axis(state.nodes[i].orientation));
  first.drive_speed = state.drive.speed;
  first.drive_acceleration = state.memory.past[last_acceleration].rotor;
  Vector(u_of(y_.get()), size()).setZero();
  Vector(u_of(y_.get()) + size(), size()) = first.rate;
}

bool ArkodeStepper::Session::step(const State& state, double step, int budget)
{
  step_ = step;
  budget_ = budget;
  iterations = 0;
  take_start(state);
  move_stage(model, state, 0.0, stage);
  prepare_start(state, stage);
  double reached = 0.0;
  void* const arkode = memory_.get();
  if (ARKStepReset(arkode, 0.0, y_.get()) != ARK_SUCCESS || ARKStepSetFixedStep(arkode, step) != ARK_SUCCESS) return false;
  if (ARKStepEvolve(arkode, step, y_.get(), &reached, ARK_ONE_STEP) < 0) return false;

  const double* y = u_of(y_.get());
  if (!ConstVector(y, 2 * size()).allFinite()) return false;
  set_stage(y, c_);
  for (int i = 0; i < model.nodes(); ++i) stage.acceleration[i] += stages_.back().acceleration.segment<6>(6 * i);
  update(model, state, stage, y, work);
  return true;
}

/// Relations of the stage that comes: rates are c (u - rate_sum_), accelerations c (rates - first rates - acceleration_sum_).
void ArkodeStepper::Session::prepare_stage()
{
  StageRecord& now = stages_[current_];
  const StageRecord& first = stages_[0];
  const double* weights = table_->A[current_];
  now.time = step_ * table_->c[current_];
  c_ = 1.0 / (step_ * weights[current_]);
  rate_sum_.setZero(size());
  acceleration_sum_.setZero(size());
  double speed_sum = 0.0, drive_sum = 0.0;
  for (int j = 0; j < current_; ++j)
  {
    const double weight = step_ * weights[j];
    rate_sum_ += weight * stages_[j].rate;
    acceleration_sum_ += weight * stages_[j].acceleration;
    speed_sum += weight * stages_[j].drive_speed;
    drive_sum += weight * stages_[j].drive_acceleration;
  }
  move_stage(model, *start_, now.time, stage);
  const double drive_rate = -c_ * speed_sum;
  stage.drive = {now.time, c_, c_ * c_, drive_rate, c_ * (drive_rate - first.drive_speed - drive_sum)};
}

/// First guess of a stage, with the rates that its relation gives.
void ArkodeStepper::Session::predict_stage(double* y)
{
  ++current_;
  prepare_stage();
  const StageRecord& before = stages_[current_ - 1];
  if (current_ == 1)
    predict(*start_, stages_[1].time, y);
  else  // the same mean rate again
    Vector(y, size()) = (stages_[current_].time / before.time) * before.u;
  Vector(y + size(), size()) = c_ * (ConstVector(y, size()) - rate_sum_);
  increment_before_ = 0.0;
}

void ArkodeStepper::Session::record_stage(const double* y)
{
  if (current_ == 0) return;
  StageRecord& now = stages_[current_];
  now.u = ConstVector(y, size());
  now.rate = ConstVector(y + size(), size());
  now.acceleration = c_ * (now.rate - stages_[0].rate - acceleration_sum_);
  const RotorStage& drive = stage.drive;
  const double turn = drive_increment(model, *start_, stage, y + 6 * model.top());
  now.drive_speed = drive.dv_du * turn + drive.rate_0;
  now.drive_acceleration = drive.da_du * turn + drive.acceleration_0;
}

/// Rates as in y and no accelerations; derivatives for rates that follow u by c.
void ArkodeStepper::Session::set_stage(const double* y, double c) noexcept
{
  stage.dv_du = c;
  stage.da_du = c * c;
  for (int i = 0; i < model.nodes(); ++i)
  {
    const Eigen::Map<const Vector6d> u(y + 6 * i), v(y + size() + 6 * i);
    stage.rate[i] = v - c * u;
    stage.acceleration[i] = -c * c * u;
  }
}

int ArkodeStepper::Session::right_hand_side(const double* y, double* rate, double c, BlockTridiagonal* tangent) noexcept
{
  set_stage(y, c);
  evaluate(model, *start_, stage, y, work, residual_.data(), tangent);
  accelerate(model, stage, residual_.data(), work);
  std::copy(y + size(), y + 2 * size(), rate);
  for (int i = 0; i < model.nodes(); ++i) Eigen::Map<Vector6d>(rate + size() + 6 * i) = work.nodes[i].acceleration;
  return ConstVector(rate, 2 * size()).allFinite() ? 0 : 1;
}

/// Asked for by SUNDIALS before the step and again for its first stage. The other stages' rates follow from their solutions.
int ArkodeStepper::Session::rates_at_start(const double* y, double* rate)
{
  StageRecord& first = stages_[0];
  if (start_known_)
  {
    Vector(rate, size()) = first.rate;
    Vector(rate + size(), size()) = first.acceleration;
    return 0;
  }
  const int flag = right_hand_side(y, rate, 0.0, nullptr);
  first.acceleration = ConstVector(rate + size(), size());
  start_known_ = flag == 0;
  return flag;
}

int ArkodeStepper::Session::solve(const double* r, double* d) noexcept
{
  ++iterations;
  Vector d_u(d, size()), d_v(d + size(), size());
  d_v = c_ * (ConstVector(r + size(), size()) + c_ * ConstVector(r, size()));
  multiply_mass(model, stage, d_v.data(), d_u.data());
  const bool solved = tangent_.solve(d_u.data());
  ++work.work.solves;
  work.profiler.lap(Cost::linear_solve);
  if (!solved || !d_u.allFinite()) return SUNLS_PACKAGE_FAIL_REC;
  increment_ = d_u.cwiseAbs().maxCoeff();
  if (increment_ > limits.max_increment) d_u *= limits.max_increment / increment_;
  d_v = c_ * (d_u - ConstVector(r, size()));
  return kSundialsSuccess;
}

int ArkodeStepper::Session::judge() noexcept
{
  const double increment = std::exchange(increment_, 0.0);  // no solution: the right-hand side was zero
  if (newton_converged(increment, increment_before_, limits)) return kSundialsSuccess;
  increment_before_ = increment;
  return iterations < budget_ ? SUN_NLS_CONTINUE : SUN_NLS_CONV_RECVR;
}

ArkodeStepper::ArkodeStepper(std::shared_ptr<const Model> model)
    : HalvingIntegrator(std::move(model)), session_(std::make_unique<Session>(*model_, stage_, work_))
{
}

ArkodeStepper::~ArkodeStepper() = default;

bool ArkodeStepper::available() noexcept
{
  return true;
}

NewtonLimits& ArkodeStepper::limits() noexcept
{
  return session_->limits;
}

StepResult ArkodeStepper::attempt(State& state, double step, const Setpoints& setpoints, int& budget, bool) noexcept
{
  open_books(state, setpoints);
  begin_step(*model_, state, step, setpoints, stage_);
  const bool solved = session_->step(state, step, budget);
  counters_.newton_iterations += static_cast<std::uint64_t>(session_->iterations);
  budget -= session_->iterations;
  if (!solved) return StepResult::not_converged;
  close_books(state, stage_, session_->increments());
  remember_last_rate(stage_, work_, state);
  remember(stage_, work_, accelerations, work_.result.drive_acceleration, state.memory.past[last_acceleration]);
  state.memory.last_step = step;
  commit(stage_, work_, state);
  advance_discrete(*model_, stage_, work_, state);
  ++counters_.steps;
  return StepResult::solved;
}

}  // namespace drill_rig_sim

#pragma GCC diagnostic pop

#endif
