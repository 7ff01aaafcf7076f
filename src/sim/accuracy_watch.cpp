#include "drill_rig_sim/sim/accuracy_watch.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "drill_rig_sim/math/rotation.h"
#include "drill_rig_sim/math/running_mean.h"
#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/model/extend_hole.h"
#include "drill_rig_sim/sim/string_watch.h"

namespace drill_rig_sim
{
namespace
{
constexpr std::uint64_t every = 10;          // frames
constexpr std::uint64_t passed_over = 3;     // steps of several frames between two that are booked: such a one costs twice as much
constexpr double memory_time = 10.0;         // [s]
constexpr double short_memory = 3.0;         // [s]
constexpr double most_confined = 0.8;        // of the load at which pipe buckles
constexpr double most_twist = 1.0;           // [rad]
constexpr double least_clearance = 2e-3;     // [m]
constexpr double most_refused = 0.2;
constexpr double most_dissipation = 0.05;
constexpr double most_blades = 0.01;         // passed a step
constexpr double least_throughput = 1e3;     // [W]
constexpr double most_jerks = 0.08;          // [1/s]
constexpr double least_contact = 5e3;        // [N]
constexpr double most_blows = 0.5;           // [1/s]
constexpr double least_blow = 1e3;           // what a hook-load cell resolves [N]
constexpr double most_damping = 0.1;         // [1/s]
constexpr double least_torque = 100.0, least_load = 1e3;  // what meter and cell resolve [N m, N]
constexpr double most_blur = 0.02, most_load_blur = 0.1;  // of the signal's range; of hook loads the estimate is two to seven times too large
constexpr double rests = 0.1, turns = 1.0;   // [rad/s]
constexpr double stands = 0.2, creeps = 0.3;  // a lower end that has just stuck quivers [rad/s]
constexpr double least_held = 1.0;           // [s]
constexpr double most_wound = 10.0;          // [turns]
constexpr double least_slip = 2e-3;          // of a contact that slides [m/s]
constexpr double least_surface_speed = 0.1;  // of turning pipe [m/s]
constexpr double most_rolling = 0.1;         // of pure rolling
constexpr double least_whirled = 8.0;        // pipe that begins to turn rolls up its wall until it slips [s]
constexpr double most_slant = 10.0 * degree;

/// Towards `value`, which stands for `duration` [s], over the last `over` [s].
void average(double value, double duration, double& mean, double over = memory_time) noexcept
{
  drill_rig_sim::average(value, duration, over, mean);
}

double along(const NodeState& node) noexcept
{
  return node.rate.velocity.dot(x_axis(node.orientation));
}

/// Of the force on walls that have friction, the share where it sticks or creeps [-].
double share_that_sticks(const Mesh& mesh, const State& state, const RigForces& forces) noexcept
{
  double all = 0.0, sticks = 0.0;
  const auto add = [&](double force, double rest, const NodeState& node, double radius)
  {
    if (force <= 0.0 || state.well.locate(node.position, node.segment).friction <= 0.0) return;
    all += force;
    if (rest > 0.0 || std::hypot(along(node), node.rate.spin * radius) < least_slip) sticks += force;
  };
  for (std::size_t i = 0; i < forces.contact.size(); ++i) add(forces.contact[i], state.nodes[i].rest, state.nodes[i], mesh.nodes[i].contact_radius);
  for (std::size_t e = 0; e < forces.span_contact.size(); ++e)
    add(forces.span_contact[e], state.spans[e].rest, state.nodes[e], 0.5 * mesh.elements[e].outer_diameter);
  return sticks / std::max(all, least_contact);
}

/// How fast the string moves sideways, and its surface about its axis: means by mass, below the rotary table.
void note_whirl(const Mesh& mesh, const State& state, double since, AccuracyMemory& memory) noexcept
{
  double mass = 0.0, sideways = 0.0, surface = 0.0;
  for (std::size_t i = 0; i < mesh.nodes.size() && state.nodes[i].position.z() <= 0.0; ++i)
  {
    const NodeState& node = state.nodes[i];
    const double m = mesh.nodes[i].mass;
    mass += m;
    sideways += m * (node.rate.velocity - along(node) * x_axis(node.orientation)).norm();
    surface += m * std::abs(node.rate.spin) * mesh.nodes[i].contact_radius;
  }
  average(sideways / std::max(mass, 1.0), since, memory.sideways, short_memory);
  average(surface / std::max(mass, 1.0), since, memory.surface, short_memory);
  const bool rolls = memory.surface > least_surface_speed && memory.sideways > most_rolling * memory.surface;
  memory.whirled = rolls ? memory.whirled + since : 0.0;
}

/// `sticking`: of the walls' force, `since` the last time [s]. A whole jerk lets go and takes hold.
void note_jerks(double sticking, double since, AccuracyMemory& memory) noexcept
{
  average(0.5 * std::abs(sticking - memory.sticking) / since, since, memory.jerks);
  memory.sticking = sticking;
}

/// A bit that comes down gently may leave and touch the bottom a while, with newtons: no blows.
void note_blows(double wob, double duration, AccuracyMemory& memory) noexcept
{
  const bool on_bottom = memory.on_bottom ? wob > 0.0 : wob >= least_blow;
  average(on_bottom && !memory.on_bottom ? 1.0 / duration : 0.0, duration, memory.blows, short_memory);
  memory.on_bottom = on_bottom;
}

/// By how many turns the string was wound up when its lower end came loose just now; 0: it did not.
double came_loose(const Model& model, const State& state, double duration, AccuracyMemory& memory) noexcept
{
  const NodeState& lower = state.nodes[0];
  const double speed = std::abs(lower.rate.spin);
  if (speed < rests) memory.held += duration;
  if (speed < turns) return 0.0;
  const bool was_held = memory.held > least_held;
  memory.held = 0.0;
  return was_held ? std::abs(state.nodes[static_cast<std::size_t>(model.top())].spin_angle - lower.spin_angle) / (2.0 * pi) : 0.0;
}

/// Blades that pass by a place of the bottom in a step [-].
double blades_passed(const Model& model, const RigForces& forces, double step) noexcept
{
  if (!model.regenerative() || forces.wob <= 0.0) return 0.0;
  return std::abs(forces.bit_speed) * step * model.bit().torque.blades / (2.0 * pi);
}

/// What BDF2 of `step` [s] takes of the waves of three times the frequency at which a bent motor turns [1/s]; 0 without one.
double damping_of_shaking(const Model& model, double turning, double step) noexcept
{
  if (!model.motor() || model.motor()->bend == 0.0) return 0.0;
  return damping_of_wave(3.0 * turning, step);
}

/// The speed that the lower end had reached when it stuck again, where it had not run as the drive does; 0: it did not.
double hesitated(const State& state, AccuracyMemory& memory) noexcept
{
  const double speed = std::abs(state.nodes[0].rate.spin), reached = memory.ran;
  memory.ran = speed < stands ? 0.0 : std::max(memory.ran, speed);
  return speed < stands && reached > creeps && reached < std::abs(state.drive.speed) ? reached : 0.0;
}

/// Variable steps are tried by their errors: that one was too long says nothing of those that were taken.
std::uint64_t attempts_of(const StepperCounters& c, const NumericsSpec& numerics) noexcept
{
  return c.steps + c.convergence_failures + (numerics.has_variable_steps() ? 0 : c.error_test_failures);
}
}  // namespace

AccuracyWatch::AccuracyWatch(std::shared_ptr<const Model> model) : model_(std::move(model)), balance_(model_), life_(WaveLife(*model_).in_mud()) {}

void AccuracyWatch::begin_frame(Integrator& integrator, const Setpoints& setpoints, bool steps, AccuracyMemory& memory) noexcept
{
  const bool commanded = !(setpoints == memory.setpoints);
  memory.setpoints = setpoints;
  if (commanded) ++memory.commanded;
  steps_ = integrator.counters().steps;
  attempts_ = attempts_of(integrator.counters(), model_->scene().numerics);
  if (memory.frames % every == 0) memory.due = true;
  booked_ = memory.due && steps && memory.spared == 0 && !integrator.reference();
  if (steps && memory.spared > 0) --memory.spared;
  if (booked_)
  {
    balance_.restart();
    stands_for_ = commanded ? memory.commanded : every - std::min(every, memory.commanded);
    memory.commanded = 0;
    memory.spared = passed_over;
    memory.due = false;
  }
  integrator.sample_balance(booked_ ? &balance_ : nullptr);
}

void AccuracyWatch::end_first_step(Integrator& integrator, double step, AccuracyMemory& memory) noexcept
{
  if (!booked_) return;
  integrator.sample_balance(nullptr);
  const double stands_for = static_cast<double>(stands_for_) * step;
  const EnergyAccounts& accounts = balance_.accounts();
  average(std::max(accounts.input_magnitudes(), accounts.loss_magnitudes()) / step, stands_for, memory.throughput);
  average(accounts.numerical_magnitudes() / step, stands_for, memory.dissipated);
}

void AccuracyWatch::end_frame(const Integrator& integrator, const State& state, const RigForces& forces, double duration, bool measured,
                              AccuracyMemory& memory) noexcept
{
  const double steps = static_cast<double>(integrator.counters().steps - steps_);
  const double attempts = static_cast<double>(attempts_of(integrator.counters(), model_->scene().numerics) - attempts_);
  average(attempts > 0.0 ? 1.0 - steps / attempts : 0.0, duration, memory.refused);
  note_blows(forces.wob, duration, memory);
  const bool stepped = !integrator.reference() && steps > 0.0;
  const double step = model_->scene().numerics.has_variable_steps() ? state.memory.last_step : stepped ? duration / steps : 0.0;
  memory.torque.note(forces.meter_torque, duration, step, life_.about);
  memory.hook_load.note(forces.hook_load, duration, step, life_.along);
  memory.hesitated = std::max(memory.hesitated, hesitated(state, memory));
  memory.stands_for = std::max(0.0, memory.stands_for - duration);
  if (memory.stands_for == 0.0) memory.report = AccuracyReport();
  if (memory.frames++ % every != 0) return;
  const double looked = static_cast<double>(every) * duration;
  note_jerks(share_that_sticks(model_->mesh(), state, forces), looked, memory);
  average(std::abs(state.nodes[0].rate.spin), looked, memory.turning, short_memory);
  note_whirl(model_->mesh(), state, looked, memory);
  const double wound = came_loose(*model_, state, looked, memory);
  AccuracyReport found = doubt_of_string(*model_, state, forces);
  const auto doubt = [&found, measured](AccuracyDoubt kind, double measure, bool raised)
  {
    if (found.doubt == AccuracyDoubt::none && raised && !measured) found = {kind, measure, 0.0, 0.0, 0.0};
  };
  if (found.doubt == AccuracyDoubt::none) found = doubt_of_turn(*model_, state, forces);
  const double share = memory.dissipated / std::max(memory.throughput, least_throughput);
  const double blades = blades_passed(*model_, forces, step);
  const double damping = damping_of_shaking(*model_, memory.turning, step);
  const double of_torque = memory.torque.blur(step, least_torque), of_load = memory.hook_load.blur(step, least_load);
  doubt(AccuracyDoubt::refused_steps, memory.refused, memory.refused > most_refused);
  doubt(AccuracyDoubt::dissipation, share, share > most_dissipation);
  doubt(AccuracyDoubt::cut, blades, blades > most_blades);
  doubt(AccuracyDoubt::shaking, damping, damping > most_damping);
  doubt(AccuracyDoubt::waves, of_torque, of_torque > most_blur);
  doubt(AccuracyDoubt::load_waves, of_load, of_load > most_load_blur);
  doubt(AccuracyDoubt::blows, memory.blows, memory.blows > most_blows);
  doubt(AccuracyDoubt::loose, wound, wound > most_wound);
  doubt(AccuracyDoubt::hesitation, memory.hesitated, memory.hesitated > 0.0);
  memory.hesitated = 0.0;
  doubt(AccuracyDoubt::whirl, memory.sideways / std::max(memory.surface, least_surface_speed), memory.whirled > least_whirled);
  doubt(AccuracyDoubt::jerks, memory.jerks, memory.jerks > most_jerks);
  if (found.doubt == AccuracyDoubt::none) found = doubt_of_hole(state);
  if (found.doubt == AccuracyDoubt::none) found = doubt_of_level(model_->scene(), state);
  if (found.doubt == AccuracyDoubt::none) return;
  memory.report = found;
  memory.stands_for = memory_time;
}

AccuracyReport doubt_of_level(const Scene& scene, const State& state) noexcept
{
  constexpr unsigned of_free_nodes = need_direction | need_contact | need_buckling;
  constexpr unsigned of_waves = need_torque | need_bit_speed;
  const unsigned no_bending = state.nodes.front().guided ? of_free_nodes : 0u, no_waves = scene.numerics.level == Level::rigid ? of_waves : 0u;
  const unsigned left_out = scene.needs & (no_bending | no_waves);
  return left_out ? AccuracyReport{AccuracyDoubt::level, static_cast<double>(left_out), 0.0, 0.0, 0.0} : AccuracyReport();
}

AccuracyReport doubt_of_hole(const State& state) noexcept
{
  const double slant = std::acos(std::clamp(-state.well.node(0).tangent.z(), -1.0, 1.0));
  return slant > most_slant ? AccuracyReport{AccuracyDoubt::slant, slant, 0.0, 0.0, 0.0} : AccuracyReport();
}

AccuracyReport doubt_of_turn(const Model& model, const State& state, const RigForces& forces) noexcept
{
  const double turn = refused_turn(model, state, forces);
  return turn > 0.0 ? AccuracyReport{AccuracyDoubt::turn, turn, 0.0, 0.0, model.turn_limit().curvature} : AccuracyReport();
}

AccuracyReport doubt_of_string(const Model& model, const State& state, const RigForces& forces) noexcept
{
  AccuracyReport report;
  const Mesh& mesh = model.mesh();
  const auto take = [&report](AccuracyDoubt doubt, double measure, double from_bit, double length)
  {
    const bool before = report.doubt == AccuracyDoubt::none || doubt < report.doubt;
    if (before || (doubt == report.doubt && measure > report.measure)) report = {doubt, measure, from_bit, length, 0.0};
  };
  for (std::size_t e = 0; e < mesh.elements.size(); ++e)
  {
    const BeamSection& s = mesh.elements[e].section;
    const double share = -forces.tension[e] * s.length * s.length / (0.5 * pi * pi * s.bending);
    const double twist = std::abs(forces.torque[e]) / s.torsion;
    const bool guided = state.nodes[e].guided && state.nodes[e + 1].guided;
    const double buckles = guided ? buckling_share(model, state, e, forces.tension[e]) : 0.0;
    if (buckles > most_confined) take(AccuracyDoubt::confined, buckles, mesh.middle(e), s.length);
    if (share > 1.0 && !guided) take(AccuracyDoubt::compression, share, mesh.middle(e), s.length);
    if (twist > most_twist) take(AccuracyDoubt::twist, twist, mesh.middle(e), s.length);
  }
  for (int i = 0; i < model.top(); ++i)
  {
    const MeshNode& node = mesh.nodes[static_cast<std::size_t>(i)];
    const double force = forces.contact[static_cast<std::size_t>(i)];
    if (state.nodes[static_cast<std::size_t>(i)].guided) continue;
    if (force <= elastic_force(node.contact, least_clearance)) continue;
    const double depth = std::pow(force / node.contact.stiffness, 1.0 / node.contact.exponent);
    const NodeState& at = state.nodes[static_cast<std::size_t>(i)];
    if (depth > state.well.radius_near(at.position, at.segment) - node.contact_radius)
      take(AccuracyDoubt::embedding, depth, node.from_bit, 0.0);
  }
  return report;
}

}  // namespace drill_rig_sim
