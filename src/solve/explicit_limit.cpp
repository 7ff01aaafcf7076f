#include "drill_rig_sim/solve/explicit_limit.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "drill_rig_sim/solve/stepper.h"

namespace drill_rig_sim
{
namespace
{
constexpr double kPressed = 1e-3;  // penetration taken for the contact's stiffness [m]
constexpr int kIterations = 300;

/// d/d delta of k delta^e [N/m].
double stiffness_of(const ContactLaw& law)
{
  return law.exponent * law.stiffness * std::pow(kPressed, law.exponent - 1.0);
}

void press_all_nodes(const System& system, BlockTridiagonal& stiffness)
{
  for (int i = 0; i + 1 < system.nodes(); ++i)
    stiffness.diagonal(i).topLeftCorner<3, 3>().diagonal().array() += stiffness_of(system.mesh().nodes[i].contact);
  stiffness.diagonal(0).topLeftCorner<3, 3>().diagonal().array() += stiffness_of(system.scene().string.front().bit->bottom);
}
}  // namespace

double explicit_step_limit(System& system, const SystemState& state)
{
  const int n = system.nodes();
  system.begin(state, 0.0, Setpoints());
  prepare_start(state, system.stage());
  BlockTridiagonal stiffness;
  stiffness.resize(n);
  std::vector<double> x(6 * n), y(6 * n);
  system.evaluate(x.data(), y.data(), &stiffness);
  press_all_nodes(system, stiffness);

  // power iteration from a vector that has a share of everything
  for (int k = 0; k < 6 * n; ++k) x[k] = std::sin(1.0 + 12.9898 * k);
  double square = 0.0;
  for (int k = 0; k < kIterations; ++k)
  {
    stiffness.multiply(x.data(), y.data());
    system.accelerate(y.data());
    double most = 0.0;
    for (int i = 0; i < n; ++i) most = std::max(most, system.acceleration(i).cwiseAbs().maxCoeff());
    if (!(most > 0.0)) break;
    square = most;
    for (int i = 0; i < n; ++i) Eigen::Map<Vector6d>(x.data() + 6 * i) = system.acceleration(i) / most;
  }
  const double frequency = std::sqrt(square);
  const double damping = 0.5 * frequency * system.scene().numerics.structural_damping;
  return 2.0 / frequency * (std::sqrt(1.0 + damping * damping) - damping);
}

void check_explicit_step(System& system, const SystemState& state)
{
  const double limit = explicit_step_limit(system, state), step = system.scene().numerics.step;
  if (step <= limit) return;
  std::ostringstream message;
  message << "numerics.step: " << step << " s is beyond the stability limit of the explicit method, " << limit << " s for this string";
  throw std::runtime_error(message.str());
}

}  // namespace drill_rig_sim
