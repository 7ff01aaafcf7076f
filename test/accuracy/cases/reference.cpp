// SPDX-License-Identifier: BSD-3-Clause
// The reference against motions known exactly, and the default stepper against the reference.
#include <cmath>

#include "index_three.h"
#include "drill_rig_sim/solve/stepper.h"
#include "groups.h"
#include "plucked_string.h"
#include "report.h"

namespace drill_rig_sim
{
namespace
{
constexpr double span = 0.4;  // nearly two of the slowest axial periods [s]
constexpr double interval = 0.005;

void plucked(Report& report, double tolerance, int order, double bound)
{
  const PluckedString string(tolerance, order);
  IdaIntegrator ida(string.rig.model);
  const State state = string.run(ida, span, interval);
  char setting[64];
  std::snprintf(setting, sizeof setting, " at tolerance %g and order %d", tolerance, order);
  const std::string source = "modes of the same masses and springs; relative to the pluck";
  report.add({std::string("plucked string by IDA: stretch") + setting + " [-]",
              (string.stretch_of(state) - string.exact_stretch(span)).cwiseAbs().maxCoeff() / 1e-3, 0.0, bound, source, true});
  report.add({std::string("plucked string by IDA: twist") + setting + " [-]",
              (string.twist_of(state) - string.exact_twist(span)).cwiseAbs().maxCoeff() / 1e-2, 0.0, bound, source, true});
  report.add({std::string("plucked string by IDA: violation of the joints") + setting + " [m or rad]", ida.reference()->drift,
              0.0, tolerance, "constraints g = 0", true});
}

void order_of_default(Report& report)
{
  const PluckedString string(1e-8, 5);
  IdaIntegrator ida(string.rig.model);
  const Eigen::VectorXd reference = string.stretch_of(string.run(ida, span, interval));
  const auto error = [&](double step)
  {
    Stepper stepper(string.rig.model, find_method(IntegratorKind::automatic));
    stepper.limits().tolerance = 1e-12;
    return (string.stretch_of(string.run(stepper, span, step)) - reference).norm();
  };
  report.add_band("order of the default stepper's error against IDA [-]", std::log2(error(0.0005) / error(0.00025)), 1.9, 2.1,
                  "second order");
}
}  // namespace

void reference_cases(Report& report)
{
  // the bound falls with the tolerance as the error of order two does: its square over the cube root's square
  plucked(report, 1e-6, 2, 5e-3);
  plucked(report, 1e-7, 2, 2e-3);
  plucked(report, 1e-8, 2, 5e-4);
  plucked(report, 1e-9, 5, 1e-4);
  order_of_default(report);
  for (const double step : {1e-4, 1e-6, 1e-8})
  {
    const DaeStepOutcome outcome = pendulum_with_step(step, Formulation::stabilised_index_2);
    char name[80];
    std::snprintf(name, sizeof name, "pendulum in stabilised index 2 at %g s: force of its joint [m g]", step);
    report.add(
        {name, outcome.reached ? outcome.multiplier_error : HUGE_VAL, 0.0, 1e-5, "balance and energy of the pendulum", true});
  }
}

}  // namespace drill_rig_sim
