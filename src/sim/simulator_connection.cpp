// Slips, and the string that is lengthened or shortened in them.
#include <algorithm>
#include <cmath>
#include <exception>

#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/model/forces/slips.h"
#include "drill_rig_sim/rig/hoisting.h"
#include "drill_rig_sim/scene/scene_mesh.h"
#include "drill_rig_sim/sim/integrator_table.h"
#include "simulator_impl.h"

namespace drill_rig_sim
{
namespace
{
constexpr double standing_block = 0.01;  // bouncing in its lines by less it counts as at rest [m/s]
constexpr double same_place = 1e-6;      // of two nodes along the string [m]

/// The joint's end of pipe that is nearest to the rotary table; -1: there is none.
int joint_at_table(const Model& model, const State& state) noexcept
{
  int nearest = -1;
  double away = 0.0;
  for (int i = 1; i < model.top(); ++i)
  {
    const MeshNode& node = model.mesh().nodes[static_cast<std::size_t>(i)];
    if (!node.joint_end || !model.scene().string[static_cast<std::size_t>(node.part)].pipe) continue;
    const double z = std::abs(state.nodes[static_cast<std::size_t>(i)].position.z() - state.hoist.floor.height);
    if (nearest >= 0 && z >= away) continue;
    nearest = i;
    away = z;
  }
  return nearest;
}

/// The joint's end nearest to an unstretched distance from the bit's face [m]: of another mesh of the same string, in which each end of a stand is a node.
int nearest_joint(const Mesh& mesh, double from_bit) noexcept
{
  int nearest = 1;
  for (int i = 1; i + 1 < static_cast<int>(mesh.nodes.size()); ++i)
  {
    const auto away = [&](int k) { return std::abs(mesh.nodes[static_cast<std::size_t>(k)].from_bit - from_bit); };
    if (mesh.nodes[static_cast<std::size_t>(i)].joint_end && away(i) < away(nearest)) nearest = i;
  }
  return nearest;
}

/// Whether two strings are the same from the bit up to node `i`.
bool same_below(const Mesh& a, const Mesh& b, int i) noexcept
{
  for (std::size_t k = 0; k <= static_cast<std::size_t>(i); ++k)
    if (std::abs(a.nodes[k].from_bit - b.nodes[k].from_bit) > same_place) return false;
  return true;
}
}  // namespace

const char* Simulator::locked(const WinchSetpoint& c) const noexcept
{
  return impl_->state.crew.doing == CrewTask::none ? why_locked(c, impl_->at_table()) : nullptr;
}

const char* Simulator::locked(const TopDriveSetpoint& c) const noexcept
{
  return impl_->state.crew.doing == CrewTask::none ? why_locked(c, impl_->at_table()) : nullptr;
}

const char* Simulator::locked(const PumpSetpoint& c) const noexcept
{
  return impl_->state.crew.doing == CrewTask::none ? why_locked(c, impl_->at_table()) : nullptr;
}

StringAtTable Simulator::Impl::at_table() const noexcept
{
  const State& now = shown();
  const Setpoints set = state.commands.in_force();
  const bool bounces = scene.rig.heave.amplitude == 0.0 && std::abs(block_velocity(now)) > standing_block;  // in waves it always does
  StringAtTable at;
  at.by_reference = scene.numerics.integrator == IntegratorKind::ida;
  at.in_slips = now.slips.node >= 0;
  at.broken_out = state.connection.under_way;
  at.block_moves = std::abs(now.hoist.winch_speed) > standing_winch || (!at.in_slips && bounces);
  at.block_commanded = moves(set.winch);
  at.top_drive_turns = std::abs(now.drive.speed) > standing_rotor || (!at.in_slips && turns(set.top_drive));
  at.pump_runs = set.pump.flow > 0.0 || now.hydraulics.pump_flow > 0.0;
  return at;
}

const char* Simulator::Impl::pull_slips() noexcept
{
  if (const char* refused = why_slips_are_not_pulled(at_table())) return refused;
  if (slips_load(shown()) > most_slips_load) return "slips: the slips carry the string, allowed: up to 5 kN, pick up first";
  release_slips();
  lead([](Impl& companion) { companion.release_slips(); });
  return nullptr;
}

void Simulator::Impl::release_slips() noexcept
{
  settle();
  mechanics().slips = HeldNode();
}

/// Under a joint's end.
const char* Simulator::Impl::set_slips(int joint) noexcept
{
  if (const char* refused = why_slips_are_not_set(at_table())) return refused;
  if (joint < 0) return "slips: there is no joint of pipe below the shaft";
  grip(joint);
  const double from_bit = model->mesh().nodes[static_cast<std::size_t>(joint)].from_bit;
  lead([from_bit](Impl& companion) { companion.grip(nearest_joint(companion.model->mesh(), from_bit)); });
  return nullptr;
}

void Simulator::Impl::grip(int joint) noexcept
{
  settle();
  const NodeState& node = mechanics().nodes[static_cast<std::size_t>(joint)];
  mechanics().slips = {joint, node.position - mechanics().hoist.floor.height * Eigen::Vector3d::UnitZ(), node.spin_angle};
}

/// Of the pipe above the slips on what they hold [N].
double Simulator::Impl::rest_load() const noexcept
{
  return shown_forces().tension[static_cast<std::size_t>(shown().slips.node)];
}

std::shared_ptr<const Model> Simulator::Impl::model_of(const StringBuilt& string) const
{
  Scene there = scene;
  there.start.bit_depth = string.bit_depth;
  return std::make_shared<Model>(there, build_mesh(scene, string.length));
}

const char* Simulator::Impl::make_connection(int joints, bool remove) noexcept
{
  const HoistingSpec& hoisting = scene.rig.hoisting;
  const State& now = shown();
  const PartSpec& pipe = scene.string.back();
  const int count = joints > 0 ? joints : hoisting.stand_joints;
  if (const char* refused = why_no_connection(at_table())) return refused;
  if (now.stuck_point.node > now.slips.node) return "connection: the pipe is stuck above the slips";
  if (rest_load() > most_rest_load) return "connection: the hook carries more than block and pipe above the slips, allowed: up to 10 kN more, slack off first";
  if (shown_forces().hook_load < most_rest_load) return "connection: the block rests on the pipe, allowed: only on its lines, pick up first";
  if (remove && count >= joints_below_stump(model->mesh(), scene)) return "connection: the string does not have as many joints";
  const double length = (remove ? -1.0 : 1.0) * count * pipe.joint_length, height = block_height(now);
  if (height + length > hoisting.highest_block_height) return "connection: the block would rise above highest_block_height";
  if (height + length < hoisting.lowest_block_height) return "connection: the block would go below lowest_block_height";
  const char* refused = try_connection(length);
  if (!refused) lead([length](Impl& companion) { if (const char* why = companion.try_connection(length)) companion.failure = why; });
  return refused;
}

const char* Simulator::Impl::try_connection(double length) noexcept
{
  try
  {
    return begin_connection(length);
  }
  catch (const std::exception&)
  {
    return "connection: the solver cannot continue with the changed string";
  }
}

/// Of a string that `longer` is: what is free all over stays so [m].
double Simulator::Impl::free_length_of(const Model& longer) const noexcept
{
  const bool all_free = level_of(*model, state.levels.free_length) == Level::beam3d;
  return all_free ? longer.mesh().nodes.back().from_bit : state.levels.free_length;
}

/// Makes the string up once to see where the block has to run, and whether it can be.
const char* Simulator::Impl::begin_connection(double length)
{
  const std::shared_ptr<const Model> longer = model_of({state.string.length + length, state.truth.bit_depth});
  const int held = shown().slips.node;
  if (uppermost_joint(length < 0.0 ? longer->mesh() : model->mesh()) != held || !same_below(model->mesh(), longer->mesh(), held))
    return "connection: the slips hold another joint than the one to break out, move the block there first";
  settle();
  const State next = made_up(*longer, mechanics(), held, length, free_length_of(*longer));
  make_integrator(scene.numerics.integrator, longer, next);
  const double foot = next.nodes[static_cast<std::size_t>(held)].position.z(), block = standard_gravity * scene.rig.hoisting.block_mass;
  const double after = hanging_pipe(*longer, held, foot).weight;
  const double travel = next.nodes.back().position.z() - mechanics().nodes.back().position.z();
  state.connection = {true, 0.0, length, travel, block + (length < 0.0 ? after : hanging_pipe(*model, held, foot).weight), block + after};
  if (!state.commands.crew_drives) state.commands.by_crew = Setpoints();
  state.commands.crew_drives = true;
  return nullptr;
}

void Simulator::Impl::end_connection()
{
  lead([](Impl& companion) { companion.end_connection(); });
  settle();
  const int held = mechanics().slips.node;
  state.string = {state.string.length + state.connection.length, state.truth.bit_depth};
  const std::shared_ptr<const Model> longer = model_of(state.string);
  state.levels.free_length = free_length_of(*longer);
  state.mechanics = made_up(*longer, mechanics(), held, state.connection.travel, state.levels.free_length);
  state.forces = forces_of_made_up(*longer, mechanics(), state.forces, held);
  state.connection = ConnectionState();
  state.commands.crew_drives = state.crew.doing != CrewTask::none;
  take_string(longer);
}

/// Goes on with another string, whose state is there.
void Simulator::Impl::take_string(std::shared_ptr<const Model> longer)
{
  std::unique_ptr<Integrator> next = make_integrator(scene.numerics.integrator, longer, mechanics());
  next->count_on_from(*integrator);
  integrator = std::move(next);
  model = std::move(longer);
  watch = StringWatch(*model);
  levels = LevelWatch(*model);
  stride_end = between = mechanics();
  end_forces = forces_between = state.forces;
  statistics.nodes = model->nodes();
  find_stand();
  note_ring();
  if (!balance) return;
  const std::unique_ptr<EnergyBalance> before = std::move(balance);
  balance = std::make_unique<EnergyBalance>(model);
  balance->go_on_from(*before);
  balance_before = std::make_unique<EnergyBalance>(*balance);
  integrator->keep_balance(balance.get());
}

/// Where the string would be broken out to take a stand away, for the crew alone.
void Simulator::Impl::find_stand()
{
  below_stand = -1;
  const int joints = scene.rig.hoisting.stand_joints;
  if (joints_below_stump(model->mesh(), scene) <= joints) return;
  const double length = state.string.length - joints * scene.string.back().joint_length;
  below_stand = uppermost_joint(build_mesh(scene, length));
}

/// What the block's gauges see, which while the string is broken out is not what holds it in the slips.
void Simulator::Impl::measure_block() noexcept
{
  Truth& m = state.truth;
  const State& s = shown();
  const HoistingSpec& hoisting = scene.rig.hoisting;
  m.hook_load = shown_forces().hook_load;
  m.torque = shown_forces().meter_torque;
  m.floor_height = s.hoist.floor.height;
  m.floor_velocity = s.hoist.floor.speed;
  m.block_height = block_height(s);
  m.block_velocity = block_velocity(s);
  double slip = s.hoist.sheave_slip;
  if (const ConnectionState& c = state.connection; c.under_way)
  {
    const BlockRun run = block_run(hoisting, c);
    m.hook_load = shown_while_broken_out(hoisting, c, m.hook_load, c.load_between, c.load_after);
    m.torque = shown_while_broken_out(hoisting, c, m.torque, 0.0, 0.0);
    m.block_height += run.travel;
    m.block_velocity += run.speed;
    slip = sheave_slip(slip, run.travel);
  }
  m.hook_load_string = m.hook_load - standard_gravity * hoisting.block_mass;
  m.dead_line_hook_load = dead_line_hook_load(m.hook_load, slip, hoisting.sheaves, hoisting.sheave_efficiency);
}

void Simulator::Impl::measure_string_built() noexcept
{
  Truth& m = state.truth;
  m.in_slips = shown().slips.node >= 0;
  m.crew = state.connection.under_way ? CrewTask::connecting : state.crew.doing;
  // whole joints of the last part, the one at the block counted by its length
  const double pipe = state.string.length - model->mesh().part_bottom.back();
  m.stand_count = static_cast<int>(std::floor(pipe / (scene.rig.hoisting.stand_joints * scene.string.back().joint_length) + 1e-9));
}

void Simulator::Impl::tell_string_built() noexcept
{
  measure_string_built();
  state.readings.in_slips = state.truth.in_slips;
  state.readings.crew = state.truth.crew;
}

const char* Simulator::set_slips(bool set) noexcept
{
  if (impl_->state.crew.doing != CrewTask::none) return "slips: the crew is making a connection";
  const char* refused = set ? impl_->set_slips(joint_at_table(*impl_->model, impl_->shown())) : impl_->pull_slips();
  impl_->tell_string_built();
  return refused;
}

const char* Simulator::make_connection(int joints, bool remove) noexcept
{
  if (impl_->state.crew.doing != CrewTask::none) return "connection: the crew is already making one";
  const char* refused = impl_->make_connection(joints, remove);
  impl_->tell_string_built();
  return refused;
}

void Simulator::call_crew(bool on) noexcept
{
  impl_->state.crew.called = on;
}

void Simulator::attend(double duration) noexcept
{
  if (*impl_->failure) return;
  const ConnectionState& c = impl_->state.connection;
  if (c.under_way && c.elapsed >= connection_duration(impl_->scene.rig.hoisting, c.travel) - time_rounding) impl_->end_connection();
  if (impl_->broken_out_by_hand()) impl_->state.commands.by_crew.winch = impl_->to_slack(duration);
  impl_->crew_works(duration);
}

}  // namespace drill_rig_sim
