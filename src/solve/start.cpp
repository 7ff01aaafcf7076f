// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/solve/start.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "drill_rig_sim/contact/bit_cut.h"
#include "drill_rig_sim/contact/bit_torque.h"
#include "drill_rig_sim/math/rotation.h"
#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/model/bore_fill.h"
#include "drill_rig_sim/model/guides.h"
#include "drill_rig_sim/model/hole_cleaning.h"
#include "drill_rig_sim/model/mud_temperature.h"
#include "drill_rig_sim/rig/hoisting.h"
#include "drill_rig_sim/scene/scene_mesh.h"
#include "drill_rig_sim/solve/length_search.h"
#include "drill_rig_sim/well/directions.h"

namespace drill_rig_sim
{
using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

namespace
{
constexpr int kMaxRounds = 20;
constexpr int kFreeRounds = 6;               // after which the bend is held
constexpr double kDepthTolerance = 1e-6;     // [m]
constexpr double kMissedDepth = 1e-3;        // [m]
constexpr double kWeightTolerance = 1e-4;    // of the weight on bit, relative
constexpr double kMissedWeight = 0.01;       // in the same way
constexpr double kToolfaceTolerance = 1e-6;  // [rad]
constexpr double kMissedToolface = 1e-3;     // [rad]
constexpr double kHoldTolerance = 1e-2;  // of the torque that holds the bend: its friction takes ten thousand times as much [N m]
constexpr double kMostWork = 2e7;        // of one start [nodes times iterations]; some 50 s
constexpr int kStretchRounds = 4;

/// A string to begin with.
struct Guess
{
  double length = 0.0;    ///< unstretched [m]
  double toolface = 0.0;  ///< of the bend [rad]
  double twist = 0.0;     ///< of the top beyond the bend, clockwise [rad]
  bool held = false;      ///< the bend, at its toolface
};

/// The node whose toolface is the string's: of the bend; without one the lowest.
std::size_t toolface_node(const Mesh& mesh) noexcept
{
  return static_cast<std::size_t>(std::max(0, mesh.bend_node));
}

/// From the bend up to each node, per torque [rad/(N m)]; 0 below.
std::vector<double> torsional_compliances(const Mesh& mesh)
{
  std::vector<double> compliance(mesh.nodes.size(), 0.0);
  for (std::size_t e = toolface_node(mesh); e < mesh.elements.size(); ++e)
    compliance[e + 1] = compliance[e] + 1.0 / mesh.elements[e].section.torsion;
  return compliance;
}

/// Nodes along the hole, resting on its low side where it is inclined; sections twisted as the guess says, y axes at the
/// toolface. `stretch`: how far each node is from its unstretched place, away from the bit [m]; nodes farther than `free_length`
/// above the bit's face are guided [m].
void place_string(const Mesh& mesh, const Wellbore& well, double depth, const Guess& guess, const std::vector<double>& stretch,
                  double free_length, State& state)
{
  state.nodes.assign(mesh.nodes.size(), NodeState());
  state.spans.assign(mesh.elements.size(), SpanState());
  const WellNode bottom = well.at(depth - mesh.nodes[0].from_bit);
  const Vector3d up = toolface_side(bottom.tangent, well.at(depth - mesh.nodes[toolface_node(mesh)].from_bit).tangent);
  Matrix3d axes;
  axes.col(0) = bottom.tangent;
  axes.col(1) = up * std::cos(guess.toolface) + bottom.tangent.cross(up) * std::sin(guess.toolface);
  axes.col(2) = axes.col(0).cross(axes.col(1));
  Quaterniond q(axes);
  const std::vector<double> compliance = torsional_compliances(mesh);
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
  {
    const double md = depth - mesh.nodes[i].from_bit - stretch[i];
    const WellNode p = well.at(md);
    q = pointed_along(q, p.tangent);
    state.nodes[i].orientation = rotation_from_vector(guess.twist * compliance[i] / compliance.back() * p.tangent) * q;
    state.nodes[i].position = p.position;
    state.nodes[i].guided = mesh.nodes[i].from_bit > free_length;
    if (md <= 0.0) continue;
    const double gap = p.radius - mesh.nodes[i].contact_radius;
    const double inclined = p.tangent.head<2>().norm();  // sin I
    if (gap > 0.0 && inclined > 1e-3) state.nodes[i].position -= std::min(1.0, 20.0 * inclined) * gap * high_side(p.tangent);
  }
}

/// Moves the top node to the block's height over the well's centre, and points it down.
void hang_on_block(const Scene& scene, State& state)
{
  NodeState& top = state.nodes.back();
  top.position = Vector3d(0.0, 0.0, scene.start.block_height);
  top.orientation = pointed_along(top.orientation, -Vector3d::UnitZ());
}

double angle_error(double angle, double wanted)
{
  return std::remainder(angle - wanted, 2.0 * pi);
}

/// What an element whose upper end is at measured depth `depth` pulls along its hole, in mud, a string empty inside down to
/// `level` [N].
double pull_along_hole(const MeshElement& e, const Scene& scene, const Wellbore& well, double depth, double level)
{
  const double empty = std::clamp((level - depth) / e.section.length, 0.0, 1.0);
  return standard_gravity * (e.linear_mass - scene.mud.density * (e.displaced + empty * e.holds)) * e.section.length *
         -well.at(depth).tangent.z();
}

/// How far each node moves away from the bit as the string stretches under its own weight in mud, bit
/// first [m]. A guess: no drag, no bending, no weight on bit.
std::vector<double> estimated_stretch(const Mesh& mesh, const Scene& scene, const Wellbore& well, double depth)
{
  const double level = fill_level(scene.mud, depth);
  double load = 0.0;
  std::vector<double> stretch{0.0};
  for (const MeshElement& e : mesh.elements)
  {
    depth -= e.section.length;
    const double weight = pull_along_hole(e, scene, well, depth, level);
    stretch.push_back(stretch.back() + (load + 0.5 * weight) * e.section.length / e.section.axial);
    load += weight;
  }
  return stretch;
}

[[noreturn]] void fail(const std::string& what)
{
  throw std::runtime_error("start: " + what);
}

/// What the string pulls along its hole, without friction [N].
double string_pull(const Scene& scene, const Mesh& mesh, const Wellbore& well, double depth)
{
  double pull = standard_gravity * mesh.bit_mass;
  const double level = fill_level(scene.mud, depth);
  for (const MeshElement& e : mesh.elements) pull += pull_along_hole(e, scene, well, depth -= e.section.length, level);
  return pull;
}

/// A weight on bit that string and block together do not make, whatever the equilibrium.
void check_weight_on_bit(const Scene& scene, const Mesh& mesh, const Wellbore& well, double depth)
{
  const double most = standard_gravity * scene.rig.hoisting.block_mass + string_pull(scene, mesh, well, depth);
  if (scene.start.weight_on_bit < most) return;
  std::ostringstream message;
  message << "weight_on_bit: " << scene.start.weight_on_bit << " N is more than string and block weigh, allowed: less than "
          << most << " N";
  fail(message.str());
}

/// Puts the string of `rig` into the hole and lets it come to rest. `work`: of the start so far [nodes times iterations],
/// bounded.
void find_equilibrium(const Scene& scene, const Wellbore& well, double depth, const Guess& guess, double& work, RigAtRest& rig)
{
  const Mesh& mesh = rig.model->mesh();
  // stretched as it will be: the way to the equilibrium goes in increments of 2 cm
  place_string(mesh, well, depth, guess, estimated_stretch(mesh, scene, well, depth), free_length(scene), rig.state);
  hang_on_block(scene, rig.state);
  settle_guided(rig.state);
  const double most = (kMostWork - work) / rig.model->nodes();
  const ToolfaceHold hold{mesh.bend_node, guess.toolface, well.at(depth - mesh.nodes[toolface_node(mesh)].from_bit).tangent};
  const auto rest = [&]
  {
    fill_bore(*rig.model, rig.state);
    rig.statics = guess.held ? solve_held(*rig.model, rig.state, hold, static_cast<int>(most))
                             : solve_static(*rig.model, rig.state, no_sliding, static_cast<int>(most));
    work += 1.0 * rig.statics.iterations * rig.model->nodes();
  };
  rest();
  if (!scene.mud.fill.empty() && rig.statics.converged) rest();  // the mud stands where the string at rest has it
  if (rig.statics.converged) return;
  std::ostringstream message;
  const double pull = string_pull(scene, mesh, well, depth);
  if (scene.start.weight_on_bit > pull)
    message << "weight_on_bit: " << scene.start.weight_on_bit << " N is more than the string pulls along its hole, " << pull
            << " N: the block would push it in, and it buckles; use a smaller weight";
  else if (work >= kMostWork)
    message << "no static equilibrium found with " << rig.model->nodes() << " nodes within the allowed number of iterations, "
            << static_cast<long>(most) << "; use a larger numerics.element_length";
  else
    message << "no static equilibrium found for the string at bit depth " << depth << " m (residual " << rig.statics.residual
            << " N after " << rig.statics.iterations
            << " iterations); use a smaller weight_on_bit, or a string that fits its hole";
  fail(message.str());
}

/// A torque on bit that its rock does not hold, whatever the equilibrium.
void check_torque_on_bit(const StartSpec& start, const Model& model, const Wellbore& well)
{
  const BitSpec& bit = model.bit();
  const double most = bit_torque_limit(bit.torque, bit.diameter, start.weight_on_bit, 0.0, model.rock_under(well)).value;
  if (start.torque_on_bit <= most) return;
  std::ostringstream message;
  message << "torque_on_bit: " << start.torque_on_bit << " N m is more than the rock can resist at this weight, allowed: up to "
          << most << " N m";
  fail(message.str());
}

/// A slack line is no start.
void check_slack_line(const StartSpec& start, double hook_load)
{
  if (hook_load > 0.0) return;
  std::ostringstream message;
  message << "weight_on_bit: " << start.weight_on_bit << " N is more than string and block weigh, allowed: less than "
          << start.weight_on_bit + hook_load << " N";
  fail(message.str());
}

/// What hangs on the hook must be what the winch may lift.
void check_hook_load(const HoistingSpec& hoisting, double hook_load)
{
  if (hook_load < hoisting.max_hook_load) return;
  std::ostringstream message;
  message << "rig.hoisting.max_hook_load: must be above the load of string and block, " << hook_load << " N (got "
          << hoisting.max_hook_load << " N)";
  fail(message.str());
}

/// Of the rock at the hole's bottom.
BitCutLaw cut_law_at_bottom(const Model& model, const Wellbore& well)
{
  return bit_cut_law(model.bit().torque, model.formation().at(-well.bottom_position().z()));
}

/// How far the blades sink into the rock per weight [m/N]; the bit of the mean law next to not at all.
double rock_compliance(const Model& model, const Wellbore& well)
{
  return model.regenerative() ? 1.0 / cut_law_at_bottom(model, well).stiffness : 0.0;
}

/// The blades where they rest, their flats with what they carry.
void rest_on_ground(const Model& model, State& state)
{
  const Vector3d to_bottom = state.well.bottom_position() - state.nodes[0].position;
  state.ground.height = model.mesh().bit_radius - to_bottom.dot(state.well.bottom_normal());
  state.ground.flats = resting_cut_weight(cut_law_at_bottom(model, state.well), state.ground.height).flats;
}

/// The brake holds the string's torque, and the motor would.
void hold_drive(const TopDriveSpec& spec, double torque, DriveState& drive)
{
  drive.meter_twist = torque / spec.meter_stiffness;
  drive.braked = spec.brake_torque > 0.0;
  if (drive.braked) drive.gear_twist = -torque / gear_stiffness;
  if (spec.integral_gain > 0.0) drive.integral = torque / spec.integral_gain;
}
/// A string that stretches is so much shorter, and stretches less for it [m].
double first_length(const Scene& scene, const Wellbore& well, double depth)
{
  const double way = depth + scene.start.block_height;
  double length = way;
  for (int round = 0; round < kStretchRounds; ++round)
  {
    const Mesh mesh = build_mesh(scene, length);
    length = way - estimated_stretch(mesh, scene, well, depth).back() + scene.start.weight_on_bit * string_compliance(mesh);
  }
  return length;
}

/// What an equilibrium lacks of the scene's start.
struct StartErrors
{
  double length = 0.0;          ///< of string that is too much [m]
  double toolface = 0.0;        ///< [rad]
  double twist = 0.0;           ///< by which the top is turned too far clockwise where the bend is held [rad]
  double holding_torque = 0.0;  ///< [N m]
  double depth = 0.0;           ///< over what is small [-]
  double much_depth = 0.0;      ///< over what is bearable [-]

  bool small() const noexcept { return depth < 1.0 && std::abs(toolface) < kToolfaceTolerance && is_free(); }
  bool bearable() const noexcept { return much_depth < 1.0 && std::abs(toolface) < kMissedToolface && is_free(); }
  bool is_free() const noexcept { return std::abs(holding_torque) < kHoldTolerance; }
};

StartErrors errors_of(const Scene& scene, const Wellbore& well, double depth, const RigAtRest& rig)
{
  const StartSpec& start = scene.start;
  const Mesh& mesh = rig.model->mesh();
  const bool on_bottom = start.weight_on_bit > 0.0;
  const double weight = rig.statics.forces.wob, weight_error = weight - start.weight_on_bit;
  StartErrors errors;
  // a heavy bit is a long string: what it is too heavy by is what the string is shortened by, seen through its compliance and the
  // rock's
  errors.length = weight_error * (string_compliance(mesh) + rock_compliance(*rig.model, well));
  if (!on_bottom || weight <= 0.0) errors.length += bit_depth(*rig.model, rig.state) - depth;
  errors.depth =
      on_bottom ? std::abs(weight_error) / (kWeightTolerance * start.weight_on_bit) : std::abs(errors.length) / kDepthTolerance;
  errors.much_depth =
      on_bottom ? std::abs(weight_error) / (kMissedWeight * start.weight_on_bit) : std::abs(errors.length) / kMissedDepth;
  if (mesh.bend_node < 0) return errors;
  errors.toolface = angle_error(bend_toolface(*rig.model, rig.state), start.toolface);
  errors.holding_torque = rig.statics.holding_torque;
  errors.twist = -errors.holding_torque * torsional_compliances(mesh).back();
  return errors;
}

/// The next guess of the top's angle. A long string, soft in torsion, rests in some toolfaces only: where turning it does not
/// bring the bend to the scene's, the bend is held there until the string's own torque does so.
void turn(double toolface, int round, const StartErrors& errors, Guess& guess) noexcept
{
  if (guess.held)
  {
    guess.twist -= errors.twist;
    return;
  }
  guess.toolface -= errors.toolface;
  guess.held = round + 1 >= kFreeRounds && std::abs(errors.toolface) >= kMissedToolface;
  if (guess.held) guess.toolface = toolface;
}

[[noreturn]] void refuse(const StartErrors& errors, bool on_bottom)
{
  std::ostringstream message;
  message << "no static equilibrium found with start." << (on_bottom ? "weight_on_bit" : "bit_depth")
          << " and start.toolface_deg: the nearest is off by " << errors.length << " m of string and " << errors.toolface / degree
          << " deg of toolface";
  if (!errors.is_free()) message << ", and needs " << errors.holding_torque << " N m that hold the bend";
  message << "; use another toolface or depth";
  fail(message.str());
}
}  // namespace

double string_compliance(const Mesh& mesh)
{
  double compliance = 0.0;
  for (const MeshElement& e : mesh.elements) compliance += e.section.length / e.section.axial;
  return compliance;
}

double bit_depth(const Model& model, const State& state)
{
  const NodeState& bit = state.nodes.front();
  const Vector3d face = bit.position + model.mesh().bit_radius * x_axis(bit.orientation);
  return state.well.locate(face, bit.segment).md;
}

double bend_toolface(const Model& model, const State& state)
{
  const int bend = model.mesh().bend_node;
  if (bend < 0) return 0.0;
  const NodeState& node = state.nodes[static_cast<std::size_t>(bend)];
  const Vector3d axis = x_axis(node.orientation);
  return angle_about(axis, toolface_side(axis, state.well.tangent_near(node.position, node.segment)), y_axis(node.orientation));
}

RigAtRest build_at_rest(const Scene& scene)
{
  const StartSpec& start = scene.start;
  const double bit_radius = 0.5 * scene.string.front().bit->diameter;
  Wellbore well(scene.well, scene.trajectory, bit_radius, scene.formation);
  const bool on_bottom = start.weight_on_bit > 0.0;
  const double depth = on_bottom ? scene.well.hole_depth : start.bit_depth;
  Guess guess{first_length(scene, well, depth), start.toolface, 0.0, false};
  if (on_bottom) check_weight_on_bit(scene, build_mesh(scene, guess.length), well, depth);
  RigAtRest rig{nullptr, State(well), {}};
  StartErrors errors;
  LengthSearch wanted_length;
  double work = 0.0;
  for (int round = 0; round < kMaxRounds; ++round)
  {
    rig.model = std::make_shared<Model>(scene, build_mesh(scene, guess.length));
    if (round == 0) check_torque_on_bit(start, *rig.model, well);
    find_equilibrium(scene, well, depth, guess, work, rig);
    errors = errors_of(scene, well, depth, rig);
    if (errors.small()) break;
    guess.length = wanted_length.next(guess.length, errors.length);
    turn(start.toolface, round, errors, guess);
  }
  if (!errors.bearable()) refuse(errors, on_bottom);

  rig.state.memory.past.assign(MethodMemory::room, {std::vector<NodeRate>(rig.state.nodes.size()), 0.0});
  const double hook_load = rig.statics.top_force + standard_gravity * scene.rig.hoisting.block_mass;
  if (on_bottom) check_slack_line(start, hook_load);
  check_hook_load(scene.rig.hoisting, hook_load);
  rig.state.hoist.line_length = line_length_for(scene.rig.hoisting, start.block_height, hook_load);
  hold_drive(scene.rig.top_drive, rig.statics.top_torque, rig.state.drive);
  if (start.torque_on_bit > 0.0) rig.state.bit.twist = start.torque_on_bit / rig.model->bit_bristle_stiffness();
  if (rig.model->regenerative()) rest_on_ground(*rig.model, rig.state);
  begin_cuttings(*rig.model, rig.state);
  begin_temperature(*rig.model, rig.state);
  rig.state.mud_waves = waves_at_rest(rig.model->mud().waves, rig.state.time, rig.state.hydraulics.strokes);
  return rig;
}

}  // namespace drill_rig_sim
