// Generalised alpha (Chung and Hulbert, J. Appl. Mech. 60, 1993) in the form of Arnold and Bruels (Multibody Syst. Dyn. 18, 2007): the
// equations of motion hold at the ends of the steps, for the true acceleration; the rates follow from an averaged one, a:
//   (1 - am) a + am a_n = (1 - af) acceleration + af acceleration_n
//   u = h rate_n + h^2 ((1/2 - b) a_n + b a),   rate = rate_n + h ((1 - g) a_n + g a)
// am = (2 r - 1)/(r + 1), af = r/(r + 1), g = 1/2 + af - am, b = (g + 1/2)^2/4; r: spectral radius at infinite frequency.
#include "drill_rig_sim/math/rotation.h"
#include "drill_rig_sim/solve/stepper.h"

namespace drill_rig_sim
{
namespace
{
constexpr double kRadius = 0.5;  // contact and tool joints ring at 1e3 rad/s: they must die out
constexpr double kAm = (2.0 * kRadius - 1.0) / (kRadius + 1.0);
constexpr double kAf = kRadius / (kRadius + 1.0);
constexpr double kGamma = 0.5 + kAf - kAm;
constexpr double kBeta = 0.25 * (kGamma + 0.5) * (kGamma + 0.5);

/// rate_0 and acceleration_0 for numbers or vectors alike.
template <typename T>
void constants(double step, const T& rate_n, const T& a_n, const T& acceleration_n, T& rate_0, T& acceleration_0) noexcept
{
  const T free_flight = step * rate_n + (step * step * (0.5 - kBeta)) * a_n;  // u for a = 0
  rate_0 = rate_n + (step * (1.0 - kGamma)) * a_n - (kGamma / (kBeta * step)) * free_flight;
  acceleration_0 = (1.0 / (1.0 - kAf)) * (kAm * a_n - kAf * acceleration_n - ((1.0 - kAm) / (kBeta * step * step)) * free_flight);
}

NodeRate averaged(const NodeState& node, double step)
{
  auto next = [step](const auto& now, const auto& before, const auto& a)
  { return ((now - before) / step - (1.0 - kGamma) * a) / kGamma; };
  const Eigen::Vector3d n = x_axis(node.orientation);
  const Eigen::Vector3d old = node.averaged_acceleration.tilt;
  NodeRate out;
  out.velocity = next(node.rate.velocity, node.last_rate.velocity, node.averaged_acceleration.velocity);
  out.tilt = next(node.rate.tilt, node.last_rate.tilt, Eigen::Vector3d(old - n * n.dot(old)));
  out.spin = next(node.rate.spin, node.last_rate.spin, node.averaged_acceleration.spin);
  return out;
}
}  // namespace

bool step_generalised_alpha(StepContext& context) noexcept
{
  const SystemState& state = context.state;
  const double h = context.step;
  Stage& stage = context.system.stage();
  stage.dv_du = kGamma / (kBeta * h);
  stage.da_du = (1.0 - kAm) / ((1.0 - kAf) * kBeta * h * h);
  for (std::size_t i = 0; i < state.nodes.size(); ++i)
  {
    const NodeState& node = state.nodes[i];
    const Eigen::Vector3d n = x_axis(node.orientation);
    constants<Vector6d>(h, in_step_axes(node.rate, n), in_step_axes(node.averaged_acceleration, n), in_step_axes(node.acceleration, n),
                        stage.rate[i], stage.acceleration[i]);
  }
  stage.drive.dv_du = stage.dv_du;
  stage.drive.da_du = stage.da_du;
  constants(h, state.drive.speed, state.drive.averaged_acceleration, state.drive.acceleration, stage.drive.rate_0,
            stage.drive.acceleration_0);
  return context.solve();
}

void remember_generalised_alpha(SystemState& state, double step) noexcept
{
  for (NodeState& node : state.nodes) node.averaged_acceleration = averaged(node, step);
  DriveState& drive = state.drive;
  drive.averaged_acceleration = ((drive.speed - drive.last_speed) / step - (1.0 - kGamma) * drive.averaged_acceleration) / kGamma;
}
}  // namespace drill_rig_sim
