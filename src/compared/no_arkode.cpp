// SPDX-License-Identifier: BSD-3-Clause
// ArkodeStepper of a build whose SUNDIALS is older than 6: that ARKODE takes neither our first guess nor a solver without a
// matrix.
#include <stdexcept>

#include "drill_rig_sim/compared/arkode_stepper.h"
#include "../solve/sundials.h"

#if SUNDIALS_VERSION_MAJOR < 6
namespace drill_rig_sim
{
class ArkodeStepper::Session
{
public:
  NewtonLimits limits;
};

ArkodeStepper::ArkodeStepper(std::shared_ptr<const Model> model) : HalvingIntegrator(std::move(model))
{
  throw std::runtime_error(
      "numerics.integrator: arkode_dirk is not available in this build: it needs SUNDIALS 6 or newer (got " SUNDIALS_VERSION ")");
}

ArkodeStepper::~ArkodeStepper() = default;

bool ArkodeStepper::available() noexcept
{
  return false;
}

NewtonLimits& ArkodeStepper::limits() noexcept
{
  return session_->limits;
}

StepResult ArkodeStepper::attempt(State&, double, const Setpoints&, int&, bool) noexcept
{
  return StepResult::not_converged;
}

}  // namespace drill_rig_sim
#endif
