// SPDX-License-Identifier: BSD-3-Clause
// Where drilling with the regenerative law begins to shake, against linear theory: small disturbances of a steady cut follow
//   1 + (1 - exp(-s tau)) [K/(s Z_a) - n a (W - W_f)/(4 pi zeta s Z_t)] = 0,   tau = 2 pi/(n Omega),
// K = n a zeta epsilon the cut's stiffness, Z_a and Z_t force over velocity and torque over spin of the string at the bit.
// Aarsnes and Aamo, Linear stability analysis of self-excited vibrations in drilling using an infinite dimensional model, J.
// Sound Vib. 360 (2016), 239-259. The impedances are of the string's own ladder of masses and springs; the rest of the comparison
// is the simulator's.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <iostream>
#include <vector>

#include "drill_rig_sim/contact/bit_cut.h"
#include "drill_rig_sim/rig/hoisting.h"
#include "drill_rig_sim/solve/start.h"
#include "drill_rig_sim/solve/stepper.h"
#include "test_scenes.h"

namespace test_solve_onset
{
using namespace drill_rig_sim;
using Complex = std::complex<double>;

namespace
{
constexpr int kBlades = 5;
constexpr double kDiameter = 0.2159, kFlats = 2e3;  // [m], [N]
constexpr double kStep = 1e-3;                      // [s]

/// A steady cut: speed [rad/s], stiffness K [N/m], weight of the cutters W - W_f [N].
struct Cut
{
  double speed, stiffness, weight;

  double delay() const { return 2.0 * pi / (kBlades * speed); }
  double feed() const { return weight / (stiffness * delay()); }
  double torque() const { return 0.25 * kDiameter / cutter_inclination * weight; }
};

/// 200 m of pipe in a hole that does not rub. `along`: damping by the mud [N s/m per m]; `structural` [s].
Scene string_of_pipe(double along, double structural)
{
  Scene scene = without_damping(vertical_scene(200.0, 200.0));
  scene.string = {bit_part(kDiameter), pipe_part(0, 9.5, plain_pipe_mass)};
  scene.string[0].bit->side_cutting = 0.0;
  scene.string[0].bit->torque.model = BitTorqueModel::regenerative;
  scene.string[0].bit->torque.blades = kBlades;
  scene.string[0].bit->torque.wear_weight = kFlats;
  scene.formation[0].threshold = kFlats;
  scene.mud.axial_damping = along;
  scene.numerics.structural_damping = structural;
  scene.rig.top_drive.gearbox_friction = scene.rig.top_drive.brake_torque = 0.0;
  return scene;
}

Scene under(Scene scene, const Cut& cut)
{
  scene.formation[0].drillability = kBlades / (2.0 * pi * cut.stiffness);
  scene.start.weight_on_bit = cut.weight + kFlats;
  scene.start.torque_on_bit = 0.999 * cut.torque();
  return scene;
}

/// The string, seen from the bit.
class Ladder
{
public:
  explicit Ladder(const RigAtRest& rig) : scene_(rig.model->scene()), mesh_(rig.model->mesh())
  {
    const HoistingSpec& hoisting = scene_.rig.hoisting;
    line_ = std::pow(2.0 * hoisting.sheaves, 2) * hoisting.line_ea / rig.state.hoist.line_length;
    damper_ = 2.0 * hoisting.line_damping * std::sqrt(line_ * hoisting.block_mass);
    for (const NodeState& node : rig.state.nodes) wet_.push_back(node.position.z() < 0.0 ? 1.0 : 0.0);
  }
  Complex axial(Complex s) const
  {
    Complex z = s * scene_.rig.hoisting.block_mass + damper_ + line_ / s + node(s, mesh_.nodes.size() - 1);
    for (std::size_t e = mesh_.elements.size(); e-- > 0;)
    {
      const BeamSection& section = mesh_.elements[e].section;
      z = 1.0 / (1.0 / z + s / (section.axial / section.length * loss(s))) + node(s, e);
    }
    return z;
  }
  Complex torsional(Complex s) const
  {
    const TopDriveSpec& drive = scene_.rig.top_drive;
    const Complex rotor = drive.inertia * s + drive.proportional_gain + drive.integral_gain / s;
    Complex z = 1.0 / (1.0 / rotor + s / drive.meter_stiffness) + spun(s, mesh_.nodes.size() - 1);
    for (std::size_t e = mesh_.elements.size(); e-- > 0;)
      z = 1.0 / (1.0 / z + s / (mesh_.elements[e].section.torsion * loss(s))) + spun(s, e);
    return z;
  }

private:
  Complex loss(Complex s) const { return 1.0 + scene_.numerics.structural_damping * s; }
  Complex node(Complex s, std::size_t i) const
  {
    return s * mesh_.nodes[i].mass + wet_[i] * scene_.mud.axial_damping * mesh_.nodes[i].length;
  }
  Complex spun(Complex s, std::size_t i) const { return s * mesh_.nodes[i].spin_inertia; }

  const Scene& scene_;
  const Mesh& mesh_;
  double line_ = 0.0, damper_ = 0.0;  // [N/m], [N s/m]
  std::vector<double> wet_;
};

/// The least parameter > 0 at which a root of 1 + ... crosses the imaginary axis, and where [rad/s].
struct Onset
{
  double value = INFINITY, frequency = 0.0;
};

/// `value_at(i omega)`: the parameter, complex, that makes i omega a root.
template <class F>
Onset least_onset(const F& value_at)
{
  Onset out;
  constexpr double d = 0.01;
  Complex before = value_at(Complex(0.0, d));
  for (double w = 2.0 * d; w < 400.0; w += d)
  {
    const Complex now = value_at(Complex(0.0, w));
    const double share = before.imag() / (before.imag() - now.imag());
    const double value = before.real() + share * (now.real() - before.real());
    const bool crosses = (before.imag() < 0.0) != (now.imag() < 0.0) && std::abs(now - before) < 0.1 * std::abs(now);
    if (crosses && value > 0.0 && value < out.value) out = {value, w - d + share * d};
    before = now;
  }
  return out;
}

double twisting(double speed_of_sinking)
{
  return 0.5 * kDiameter * kBlades * speed_of_sinking / (4.0 * pi * cutter_inclination);
}

/// The complex K that makes s a root, fed by `feed` [m/s] at `speed` [rad/s].
Complex axial_parameter(const Ladder& string, double speed, double feed, Complex s)
{
  const double delay = 2.0 * pi / (kBlades * speed);
  return -1.0 /
         ((1.0 - std::exp(-s * delay)) * (1.0 / (s * string.axial(s)) - twisting(feed * delay) / (s * string.torsional(s))));
}

/// The complex W - W_f, at `speed` in rock of stiffness K.
Complex torsional_parameter(const Ladder& string, double speed, double stiffness, Complex s)
{
  const Complex memory = 1.0 - std::exp(-s * 2.0 * pi / (kBlades * speed));
  return (1.0 + memory * stiffness / (s * string.axial(s))) / (memory * twisting(1.0) / (s * string.torsional(s)));
}

/// The root that is on the axis at the onset, at `share` of the onset's parameter: its growth [1/s], by secants.
template <class F>
double root_growth(const F& value_at, const Onset& onset, double share)
{
  Complex before(0.0, onset.frequency), s = before + 0.1;
  Complex miss = value_at(before) - share * onset.value;
  for (int k = 0; k < 20; ++k)
  {
    const Complex now = value_at(s) - share * onset.value;
    if (now == miss) break;
    const Complex next = s - now * (s - before) / (now - miss);
    before = s, miss = now, s = next;
    if (std::abs(s - before) < 1e-12) break;
  }
  return s.real();
}

/// The rig as it drills steadily, in its full turn and under its cut.
void set_going(const Cut& cut, RigAtRest& rig)
{
  for (NodeState& node : rig.state.nodes)
  {
    node.rate.velocity.z() = -cut.feed();
    node.rate.spin = cut.speed;
  }
  rig.state.drive.speed = cut.speed;
  rig.state.hoist.winch_speed = -cut.feed();
  CutGround& ground = rig.state.ground;
  ground.pending = ground.height;
  const double depth = cut.weight / cut.stiffness;
  for (int i = 0; i < CutGround::cells; ++i) ground.heights[i] = ground.height - depth + depth * i / CutGround::cells;
}

/// What swings: weight or bit speed.
enum class Swing
{
  weight,
  speed
};

/// The rig some seconds after it has come, slowly, from a lesser feed to the steady cut and been knocked on at the bit: the
/// signal [N or rad/s].
std::vector<double> swings(const Scene& string, const Cut& cut, Swing what)
{
  constexpr double coming = 8.0, other_modes = 4.0, span = 10.0, least = 0.8;  // [s], [s], [s], [-]
  const Cut first{cut.speed, cut.stiffness, least * cut.weight};
  RigAtRest rig = build_at_rest(under(string, first));
  set_going(first, rig);
  Setpoints setpoints;
  setpoints.top_drive.speed = cut.speed;
  Stepper stepper(rig.model, find_method(IntegratorKind::automatic));
  std::vector<double> signal;
  const long knock = std::lround(coming / kStep), from = std::lround((coming + other_modes) / kStep);
  for (long k = 0; k < from + std::lround(span / kStep); ++k)
  {
    setpoints.winch = {-cut.feed() * std::min(1.0, least + (1.0 - least) * k / knock), false};
    NodeRate& bit = rig.state.nodes[0].rate;
    if (k == knock) (what == Swing::weight ? bit.velocity.z() : bit.spin) *= 1.02;
    EXPECT_TRUE(stepper.advance(rig.state, kStep, setpoints));
    const RigForces& forces = stepper.find_forces(rig.state);
    if (k >= from) signal.push_back(what == Swing::weight ? forces.wob : forces.bit_speed);
  }
  return signal;
}

/// How fast a swing of `frequency` [rad/s] grows: by its rms in windows of two periods [1/s].
double growth(const std::vector<double>& signal, double frequency)
{
  const auto window = static_cast<std::size_t>(std::lround(4.0 * pi / frequency / kStep));
  std::vector<double> logs;
  for (std::size_t from = 0; from + window <= signal.size(); from += window)
  {
    double sum = 0.0, squares = 0.0;
    for (std::size_t k = from; k < from + window; ++k) sum += signal[k];
    for (std::size_t k = from; k < from + window; ++k) squares += std::pow(signal[k] - sum / window, 2);
    logs.push_back(0.5 * std::log(squares / window));
  }
  double up = 0.0, down = 0.0;  // straight line through the logarithms
  const double middle = 0.5 * (logs.size() - 1.0);
  for (std::size_t k = 0; k < logs.size(); ++k) up += (k - middle) * logs[k], down += (k - middle) * (k - middle);
  return up / down / (window * kStep);
}

/// The simulated growths 5 % below and above the onset against the roots of the characteristic equation; the simulated onset lies
/// between.
template <class F, class G>
void compare(double speed, const F& value_at, const G& simulated)
{
  const Onset onset = least_onset(value_at);
  const double below = simulated(0.95, onset), above = simulated(1.05, onset);
  const double root_below = root_growth(value_at, onset, 0.95), root_above = root_growth(value_at, onset, 1.05);
  std::cout << speed / rpm << " rpm: onset at " << onset.value << ", " << onset.frequency / (2.0 * pi)
            << " Hz; growth [1/s] at 95 %: " << below << ", linear theory " << root_below << "; at 105 %: " << above << ", "
            << root_above << "; simulated onset " << 0.95 + 0.1 * below / (below - above) << " of it\n";
  EXPECT_LT(below, 0.0);
  EXPECT_GT(above, 0.0);
  EXPECT_NEAR(below, root_below, 0.2 * std::abs(root_below));
  EXPECT_NEAR(above, root_above, 0.2 * std::abs(root_above));
}
}  // namespace

// In soft rock: with quick.yaml's, 6e6 N/m and more, the string would be beyond its onset.
TEST(Onset, axialInStiffnessAndSpeed)
{
  Scene string = string_of_pipe(0.0, 5e-3);
  string.rig.hoisting.line_damping = 0.1;
  const double feed = 0.01;
  for (const double speed : {60.0 * rpm, 97.0 * rpm, 150.0 * rpm})
  {
    const RigAtRest rest = build_at_rest(under(string, {speed, 5e5, 3e3}));
    const Ladder ladder(rest);
    compare(
        speed, [&](Complex s) { return axial_parameter(ladder, speed, feed, s); },
        [&](double share, const Onset& onset)
        {
          const double stiffness = share * onset.value;
          return growth(swings(string, {speed, stiffness, stiffness * feed * 2.0 * pi / (kBlades * speed)}, Swing::weight),
                        onset.frequency);
        });
  }
}

// The mud holds the string along its axis, so that it is the twist that shakes. W_f carries weight, but does not count.
TEST(Onset, torsionalInWeightAndSpeed)
{
  const Scene string = string_of_pipe(3e3, 5e-3);
  const double stiffness = 5e6;
  for (const double speed : {60.0 * rpm, 97.0 * rpm, 150.0 * rpm})
  {
    const RigAtRest rest = build_at_rest(under(string, {speed, stiffness, 5e3}));
    const Ladder ladder(rest);
    compare(
        speed, [&](Complex s) { return torsional_parameter(ladder, speed, stiffness, s); },
        [&](double share, const Onset& onset) {
          return growth(swings(string, {speed, stiffness, share * onset.value}, Swing::speed), onset.frequency);
        });
  }
}
}  // namespace test_solve_onset
