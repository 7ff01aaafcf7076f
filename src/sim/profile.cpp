// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/sim/profile.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "drill_rig_sim/math/rotation.h"
#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/model/bore_fill.h"
#include "drill_rig_sim/model/evaluate.h"
#include "drill_rig_sim/model/guides.h"
#include "drill_rig_sim/scene/scene_mesh.h"
#include "drill_rig_sim/sim/accuracy_watch.h"
#include "drill_rig_sim/solve/length_search.h"
#include "drill_rig_sim/solve/start.h"
#include "drill_rig_sim/well/directions.h"

namespace drill_rig_sim
{
namespace
{
/// Effective tension to true axial force: the mud's pressures in the bore and outside, hydrostatic and of the pump, at an element
/// [Pa].
double true_axial_force(double effective, const MeshElement& e, double bore, double annulus) noexcept
{
  return effective + bore * e.bore_area - annulus * e.outer_area;
}

/// An element's quantity at node i: the mean of the elements that meet there.
double at_node(const std::vector<double>& elements, std::size_t i) noexcept
{
  if (i == 0) return elements.front();
  if (i == elements.size()) return elements.back();
  return 0.5 * (elements[i - 1] + elements[i]);
}

/// Half of what an element's weight in mud adds to the tension from its lower end to its upper one [N].
double half_rise(const Model& model, const State& s, std::size_t e) noexcept
{
  const double lower = s.nodes[e].position.z(), upper = s.nodes[e + 1].position.z();
  const double cosine = (upper - lower) / model.mesh().elements[e].section.length;
  return 0.5 * model.element_weight(static_cast<int>(e), lower, upper, s.hydraulics.bore_top) * cosine;
}

/// Effective tension at node i: of the elements that meet there the mean, each brought from its middle to its end.
double tension_at(const Model& model, const State& s, const std::vector<double>& tension, std::size_t i) noexcept
{
  const std::size_t last = tension.size() - 1;
  const auto top_of = [&](std::size_t e) { return tension[e] + half_rise(model, s, e); };
  const auto foot_of = [&](std::size_t e) { return tension[e] - half_rise(model, s, e); };
  if (i == 0) return foot_of(0);
  if (i > last) return top_of(last);
  return 0.5 * (top_of(i - 1) + foot_of(i));
}

/// What may be spent on raising the friction, so that a string that does not rest is refused after some 15 s: a third by the
/// scene's elements, the rest by shorter ones.
constexpr double most_work = 10e6, first_work = 3e6;  // [nodes times iterations]
/// The same on bringing the scene's weight back to the bit, of all meshes together.
constexpr double most_weight_work = 5e6;

/// How the string moves, and whether the mud drags on it at that speed.
struct StringMotion
{
  SlidingMotion sliding;
  bool in_mud = false;
};

StaticOutcome solve_within(double& work, const StringMotion& motion, RigAtRest& rig, double first_share,
                           int most_iterations = most_static_iterations)
{
  const double most = std::clamp(work / rig.model->nodes(), 1.0, 1.0 * most_iterations);
  StaticOutcome outcome = solve_static(*rig.model, rig.state, motion.sliding, static_cast<int>(most), first_share, motion.in_mud);
  work -= 1.0 * outcome.iterations * rig.model->nodes();
  return outcome;
}

/// What the bit carries beside the scene's weight, and how far it is from where it should be, as string too much [m].
double weight_error(const Scene& scene, const RigAtRest& rig, double weight)
{
  const StartSpec& start = scene.start;
  const double error = (weight - start.weight_on_bit) * string_compliance(rig.model->mesh());
  if (start.weight_on_bit > 0.0 && weight > 0.0) return error;
  return error + bit_depth(*rig.model, rig.state) - (start.weight_on_bit > 0.0 ? scene.well.hole_depth : start.bit_depth);
}

/// [m] above the table
void put_top(double height, State& state) noexcept
{
  NodeState& top = state.nodes.back();
  top.position.z() = height;
  if (top.guided) settle_in_hole(state, state.nodes.size() - 1);
}

/// Full slip from the frictionless start. Pipe that is pushed into a helix at once may rest with fewer turns than one that is
/// slacked off: where there is a helix, the friction is raised by and by, if it then rests at all. `first_share`: of the friction
/// that is tried first.
StaticOutcome slide(const StringMotion& motion, double first_share, double& work, RigAtRest& rig)
{
  const State start = rig.state;
  StaticOutcome at_once = solve_within(work, motion, rig, first_share);
  if (!at_once.converged || at_once.gradual || buckled_pipe(*rig.model, rig.state, at_once.forces).helical == 0.0) return at_once;
  const State found = rig.state;
  rig.state = start;
  StaticOutcome gradual = solve_within(work, motion, rig, gradual_share);
  if (gradual.converged) return gradual;
  rig.state = found;
  return at_once;
}

/// What is left of the work.
struct StaticWork
{
  double friction = 0.0, weight = most_weight_work;
};

/// Slips the string on until the bit carries the scene's weight again, or none as in the scene, which friction has changed: by
/// secants, for friction holds part of what is slipped on, and by halves where so much at once finds no equilibrium.
StaticOutcome hold_weight(const Scene& scene, const StringMotion& motion, double first_share, StaticWork& work, RigAtRest& rig)
{
  constexpr int most_rounds = 20, most_tried = 500;
  constexpr double least_slip = 1e-3;                                                         // [m]
  const double wanted = scene.start.weight_on_bit, tolerance = std::max(1e-4 * wanted, 1.0);  // [N]
  StaticOutcome outcome = slide(motion, first_share, work.friction, rig);
  if (!outcome.converged) return outcome;
  double weight = outcome.forces.wob;  // of the last equilibrium
  LengthSearch slipped_on;             // of the top, down from the table: what is slipped on comes to the bit as weight
  for (int round = 0; round < most_rounds && work.weight > 0.0; ++round)
  {
    weight = outcome.forces.wob;
    if (std::abs(weight - wanted) < tolerance) return outcome;
    const State found = rig.state;
    const double top = found.nodes.back().position.z();
    double slip = slipped_on.next(-top, weight_error(scene, rig, outcome.forces.wob)) + top;
    do
    {
      rig.state = found;
      put_top(top - slip, rig.state);
      outcome = solve_within(work.weight, motion, rig, 1.0, most_tried);
      slip *= 0.5;
    } while (!outcome.converged && std::abs(slip) > least_slip && work.weight > 0.0);
    if (outcome.converged || work.weight <= 0.0) continue;
    rig.state = found;
    put_top(top - 2.0 * slip, rig.state);
    return solve_within(work.weight, motion, rig, 1.0);
  }
  if (outcome.converged && std::abs(outcome.forces.wob - wanted) < tolerance) return outcome;
  std::ostringstream message;
  message << "static: no equilibrium found with the scene's weight on bit for this motion: " << weight << " N instead of "
          << wanted << " N";
  throw std::runtime_error(message.str());
}

/// Says how far the friction could be raised, and what the string is like there.
[[noreturn]] void refuse(const StaticReport& report)
{
  std::ostringstream message;
  message.precision(3);
  message << "static: no equilibrium found for this motion with more than " << 100.0 * report.outcome.share
          << " % of the friction";
  const LoadShare& buckling = report.loads.buckling;
  if (buckling.share > 1.0)
    message << "; at that friction the pipe " << std::lround(buckling.from_bit) << " m above the bit carries " << buckling.share
            << " times its critical buckling load";
  if (report.outcome.share > 0.0 && report.outcome.top_force < 0.0)
    message << "; even then the string must be pushed in at the top with " << -report.outcome.top_force / 1e3 << " kN";
  const std::string doubt = text_of(report.accuracy);
  if (!doubt.empty()) message << "; " << doubt;
  throw std::runtime_error(message.str());
}

/// Stress of an element's outer fibre by a bending moment of its ends: M D / (2 I), with I of the tube that its diameters say
/// [Pa].
double bending_stress(const Model& model, std::size_t e, double moment) noexcept
{
  const MeshElement& element = model.mesh().elements[e];
  const PartSpec& part = model.scene().string[static_cast<std::size_t>(element.part)];
  const double inertia = element.section.bending / part.young_modulus;
  return inertia > 0.0 ? 0.5 * moment * part.outer_diameter / inertia : 0.0;
}

/// The larger of the elements that meet at node i.
template <class Of>
double larger_at(std::size_t elements, std::size_t i, Of of)
{
  if (i == 0) return of(0);
  return i == elements ? of(i - 1) : std::max(of(i - 1), of(i));
}

/// A node's share of what the elements beside it have at their middles.
template <class T>
T half_of_spans(const std::vector<T>& spans, std::size_t i, T sum)
{
  if (i > 0) sum += 0.5 * spans[i - 1];
  if (i < spans.size()) sum += 0.5 * spans[i];
  return sum;
}
}  // namespace

void fill_profile(const Model& model, const State& s, const RigForces& forces, StringProfile& out)
{
  const Mesh& mesh = model.mesh();
  const std::size_t n = s.nodes.size();
  const MudPressures pressures = pressures_in_mud(model, s);
  const double per_metre = model.scene().mud.density * standard_gravity, surface = mud_surface(model, s);
  for (auto* values : {&out.md, &out.from_bit, &out.tension, &out.true_axial_force, &out.torque, &out.bending_moment,
                       &out.contact_force, &out.contact_side, &out.spin_speed, &out.radius, &out.bending_stress, &out.buckling})
    values->resize(n);
  out.position.resize(n);
  out.contact_vector.resize(n);
  out.guided.resize(n);
  for (std::size_t i = 0; i < n; ++i)
  {
    const NodeState& node = s.nodes[i];
    const ClosestPoint closest = s.well.locate(node.position, node.segment);
    const std::size_t e = std::min(i, mesh.elements.size() - 1);
    const MeshElement& element = mesh.elements[e];
    const double under_table = per_metre * std::max(-node.position.z(), 0.0);
    const double in_bore =
        mesh.nodes[i].from_bit < s.hydraulics.bore_top ? per_metre * std::max(surface - node.position.z(), 0.0) : 0.0;
    out.md[i] = closest.md;
    out.from_bit[i] = mesh.nodes[i].from_bit;
    out.position[i] = node.position;
    out.tension[i] = tension_at(model, s, forces.tension, i);
    out.true_axial_force[i] = true_axial_force(out.tension[i], element, in_bore + pressures.in_bore(model.mud(), e),
                                               under_table + pressures.in_annulus(model.mud(), e));
    out.torque[i] = at_node(forces.torque, i);
    out.bending_moment[i] = forces.bending_moment[i];
    out.contact_force[i] = forces.contact[i] + half_of_spans(forces.span_contact, i, 0.0);
    out.contact_vector[i] = forces.wall[i] + half_of_spans(forces.span_wall, i, Eigen::Vector3d(0.0, 0.0, 0.0));
    out.contact_side[i] = out.contact_force[i] > 0.0
                              ? angle_about(closest.tangent, high_side(closest.tangent), node.position - closest.centre)
                              : 0.0;
    out.spin_speed[i] = node.rate.spin;
    out.radius[i] = 0.5 * element.outer_diameter;
    out.bending_stress[i] =
        larger_at(mesh.elements.size(), i, [&](std::size_t k) { return bending_stress(model, k, forces.bending_moment[i]); });
    out.buckling[i] =
        larger_at(mesh.elements.size(), i, [&](std::size_t k) { return buckling_share(model, s, k, forces.tension[k]); });
    out.guided[i] = node.guided ? 1 : 0;
  }
}

namespace
{
/// The mud's pressures in steady flow, by the laws of a run: in steps that outlast all that changes with time.
void settle_mud(const SlidingMotion& sliding, const MovingMud& mud, RigAtRest& rig)
{
  constexpr int most_steps = 20;
  constexpr double long_step = 1e4, same = 0.1;  // [s], [Pa]
  State& state = rig.state;
  const std::vector<NodeState> at_rest = state.nodes;
  if (mud.by_string)
  {
    for (NodeState& node : state.nodes) node.rate.velocity = sliding.axial_speed * x_axis(node.orientation);
    state.drive.speed = sliding.spin_speed;
  }
  double change = HUGE_VAL;
  for (int k = 0; k < most_steps && std::abs(change) > same; ++k)
  {
    const double before = state.hydraulics.annulus_pressure;
    advance_mud(*rig.model, mud.flow, long_step, state);
    change = state.hydraulics.annulus_pressure - before;
  }
  state.nodes = at_rest;
  state.drive.speed = 0.0;
}

/// Only loads and warnings, where there is no equilibrium.
StaticReport report_on(const Scene& scene, const SlidingMotion& sliding, const MovingMud& mud, double first_share,
                       StaticWork& work)
{
  RigAtRest rig = build_at_rest(scene);
  const double pressure_at_rest = pressures_in_mud(*rig.model, rig.state).annulus;
  if (mud.moves()) settle_mud(sliding, mud, rig);
  StaticReport report;
  report.annulus_pressure = pressures_in_mud(*rig.model, rig.state).annulus - pressure_at_rest;
  report.outcome =
      sliding.still() && !mud.moves() ? rig.statics : hold_weight(scene, {sliding, mud.by_string}, first_share, work, rig);
  report.loads = StringWatch(*rig.model).look(*rig.model, rig.state, report.outcome.forces);
  report.buckled = buckled_pipe(*rig.model, rig.state, report.outcome.forces);
  report.accuracy = doubt_of_string(*rig.model, rig.state, report.outcome.forces);
  report.tight = tight_assembly(*rig.model, rig.statics.forces);
  if (!report.outcome.converged) return report;
  if (report.accuracy.doubt == AccuracyDoubt::none) report.accuracy = doubt_of_hole(rig.state);
  if (report.accuracy.doubt == AccuracyDoubt::none) report.accuracy = doubt_of_level(scene, rig.state);
  fill_profile(*rig.model, rig.state, report.outcome.forces, report.profile);
  report.hook_load_string = report.outcome.top_force;
  report.hook_load = report.hook_load_string + standard_gravity * scene.rig.hoisting.block_mass;
  report.gauges =
      steady_hook_load(scene.rig.hoisting, report.hook_load, (sliding.axial_speed < 0.0) - (sliding.axial_speed > 0.0));
  report.hook_load_gauge =
      scene.instruments.hook_load.place == HookLoadPlace::block ? report.gauges.at_block : report.gauges.at_dead_line;
  report.torque = report.outcome.top_torque;
  report.bit_side_force = report.outcome.forces.contact.front();
  report.bit_side_direction = report.profile.contact_side.front();
  const NodeState& bit = rig.state.nodes.front();
  const ClosestPoint closest = rig.state.well.locate(bit.position, bit.segment);
  const Eigen::Vector3d axis = x_axis(bit.orientation);
  report.bit_tilt = std::atan2(axis.cross(closest.tangent).norm(), axis.dot(closest.tangent));
  return report;
}

/// More must push the string in than block and top drive weigh, though not all of the friction acts: what is found with all of it
/// does not matter.
bool outweighs_block(const Scene& scene, const StaticOutcome& outcome) noexcept
{
  return !outcome.converged && outcome.share > 0.0 && outcome.top_force + standard_gravity * scene.rig.hoisting.block_mass < 0.0;
}

/// Halves the elements where friction pushes pipe, or all of them where none does. False: they are as short as they may be.
bool refine(NumericsSpec& numerics, bool pushed)
{
  constexpr double half_joint = 4.75, least = 1.18;  // [m]
  double& length = pushed ? numerics.pushed_element_length : numerics.element_length;
  const double before = length > 0.0                              ? length
                        : pushed && numerics.element_length > 0.0 ? std::min(numerics.element_length, half_joint)
                                                                  : half_joint;
  if (0.5 * before < least) return false;
  length = 0.5 * before;
  return true;
}
}  // namespace

StaticReport static_report(const Scene& scene, const SlidingMotion& sliding, const MovingMud& mud)
{
  Scene meshed = scene, finer = scene;
  meshed.pressure_waves.reset();  // in steady flow there are none
  const bool pushed = pushed_length(scene) > 0.0;
  double refined = 0.0, first_share = 1.0;
  StaticWork work{refine(finer.numerics, pushed) ? first_work : most_work};
  std::optional<StaticReport> best;
  while (true)
  {
    StaticReport report = report_on(meshed, sliding, mud, first_share, work);
    report.refined_length = refined;
    if (outweighs_block(scene, report.outcome)) refuse(report);
    if (!best || report.outcome.converged || (!best->outcome.converged && report.outcome.share > best->outcome.share))
      best = report;
    if (report.outcome.converged && report.accuracy.doubt != AccuracyDoubt::compression) break;
    if (refined == 0.0) work.friction += most_work - first_work;
    if (work.friction <= 0.0 || !refine(meshed.numerics, pushed)) break;
    refined = pushed ? meshed.numerics.pushed_element_length : meshed.numerics.element_length;
    first_share = report.outcome.gradual ? gradual_share : 1.0;
  }
  if (!best->outcome.converged) refuse(*best);
  return *best;
}

}  // namespace drill_rig_sim
