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
#include "drill_rig_sim/model/hole_cleaning.h"
#include "drill_rig_sim/model/mud_temperature.h"
#include "drill_rig_sim/rig/hoisting.h"
#include "drill_rig_sim/scene/scene_mesh.h"
#include "drill_rig_sim/solve/length_search.h"
#include "drill_rig_sim/well/directions.h"
#include "placed_string.h"

namespace drill_rig_sim
{
using Eigen::Vector3d;

namespace
{
constexpr int kPlacedRounds = 20;            // in which the string is placed along its hole
constexpr int kFollowedRounds = 20;          // in which it begins where it came to rest
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

double angle_error(double angle, double wanted)
{
  return std::remainder(angle - wanted, 2.0 * pi);
}

[[noreturn]] void fail(const std::string& what)
{
  throw std::runtime_error("start: " + what);
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

/// Lets the string of `rig`, which is where it was placed, come to rest. `work`: of the start so far [nodes times iterations],
/// bounded.
void find_equilibrium(const Scene& scene, const Wellbore& well, double depth, const Guess& guess, double& work, RigAtRest& rig)
{
  const Mesh& mesh = rig.model->mesh();
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

/// Weights on bit of equilibria that were found, next to the wanted one [N]; 0: none.
struct NearestWeights
{
  double below = 0.0, above = 0.0;

  void take(double weight, double wanted) noexcept
  {
    if (weight < wanted) below = std::max(below, weight);
    if (weight > wanted) above = above > 0.0 ? std::min(above, weight) : weight;
  }
};

[[noreturn]] void refuse(const StartErrors& errors, bool on_bottom, const NearestWeights& nearest)
{
  std::ostringstream message;
  const bool snaps = nearest.below > 0.0 && nearest.above > 0.0;
  if (on_bottom && snaps && std::abs(errors.toolface) < kMissedToolface && errors.is_free())
  {
    message << "weight_on_bit: compressed pipe buckles from one shape into another one between " << nearest.below << " and "
            << nearest.above << " N, and no equilibrium was found between them; use one of these weights, or a smaller one";
    fail(message.str());
  }
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
  NearestWeights nearest;
  Guess last;
  for (int round = 0; round < kPlacedRounds + kFollowedRounds; ++round)
  {
    rig.model = std::make_shared<Model>(scene, build_mesh(scene, guess.length));
    if (round == 0) check_torque_on_bit(start, *rig.model, well);
    // Compressed pipe buckles into another shape from one length to the next, each time it is placed anew, and no length has the
    // weight between them: the shape that it has is followed.
    if (round == kPlacedRounds) wanted_length = LengthSearch();
    if (round >= kPlacedRounds && rig.state.nodes.size() == rig.model->mesh().nodes.size())
      turn_string(rig.model->mesh(), last, guess, rig.state);
    else
      place_string(rig.model->mesh(), scene, well, depth, guess, rig.state);
    last = guess;
    find_equilibrium(scene, well, depth, guess, work, rig);
    errors = errors_of(scene, well, depth, rig);
    if (errors.small()) break;
    nearest.take(rig.statics.forces.wob, start.weight_on_bit);
    guess.length = wanted_length.next(guess.length, errors.length);
    turn(start.toolface, round, errors, guess);
  }
  if (!errors.bearable()) refuse(errors, on_bottom, nearest);

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
