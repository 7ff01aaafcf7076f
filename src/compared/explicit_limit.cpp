// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/compared/explicit_limit.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "drill_rig_sim/contact/bit_cut.h"
#include "drill_rig_sim/model/forces/inertia.h"
#include "drill_rig_sim/model/forces/span_wall.h"
#include "drill_rig_sim/solve/methods/method.h"

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

/// Of the rock on the bit [N/m].
double bottom_stiffness(const Model& model)
{
  if (!model.regenerative()) return stiffness_of(model.bit().bottom);
  double stiffest = 0.0;
  for (const FormationLayer& rock : model.formation().layers())
  {
    const BitCutLaw law = bit_cut_law(model.bit().torque, rock);
    stiffest = std::max(stiffest, law.stiffness + law.flats / flats_height);
  }
  return stiffest;
}

void press_all(const Model& model, const Workspace& work, BlockTridiagonal& stiffness)
{
  for (int i = 0; i < model.top(); ++i)
    stiffness.diagonal(i).topLeftCorner<3, 3>().diagonal().array() += stiffness_of(model.mesh().nodes[i].contact);
  stiffness.diagonal(0).topLeftCorner<3, 3>().diagonal().array() += bottom_stiffness(model);
  Eigen::Matrix<double, 6, 6> block = Eigen::Matrix<double, 6, 6>::Zero();
  for (int e = 0; e < model.elements(); ++e)
  {
    block.topLeftCorner<3, 3>().diagonal().setConstant(stiffness_of(model.mesh().elements[static_cast<std::size_t>(e)].contact));
    add_at_ends(work.spans[static_cast<std::size_t>(e)], e, block, stiffness);
  }
}
}  // namespace

double explicit_step_limit(const Model& model, const State& state)
{
  const int n = model.nodes();
  Stage stage(model);
  Workspace work(model);
  begin_step(model, state, 0.0, Setpoints(), stage);
  prepare_start(state, stage);
  BlockTridiagonal stiffness;
  stiffness.resize(n);
  std::vector<double> x(6 * n), y(6 * n);
  evaluate(model, state, stage, x.data(), work, y.data(), &stiffness);
  press_all(model, work, stiffness);

  // power iteration from a vector that has a share of everything
  for (int k = 0; k < 6 * n; ++k) x[k] = std::sin(1.0 + 12.9898 * k);
  double square = 0.0;
  for (int k = 0; k < kIterations; ++k)
  {
    stiffness.multiply(x.data(), y.data());
    accelerate(model, stage, y.data(), work);
    double most = 0.0;
    for (int i = 0; i < n; ++i) most = std::max(most, work.nodes[i].acceleration.cwiseAbs().maxCoeff());
    if (!(most > 0.0)) break;
    square = most;
    for (int i = 0; i < n; ++i) Eigen::Map<Vector6d>(x.data() + 6 * i) = work.nodes[i].acceleration / most;
  }
  const double frequency = std::sqrt(square);
  const double damping = 0.5 * frequency * model.scene().numerics.structural_damping;
  return 2.0 / frequency * (std::sqrt(1.0 + damping * damping) - damping);
}

void check_explicit_step(const Model& model, const State& state)
{
  const double limit = explicit_step_limit(model, state), step = model.scene().numerics.step;
  if (step <= limit) return;
  std::ostringstream message;
  message << "numerics.step: " << step << " s is beyond the stability limit of the explicit method, " << limit
          << " s for this string";
  throw std::runtime_error(message.str());
}

}  // namespace drill_rig_sim
