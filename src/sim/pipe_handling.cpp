// SPDX-License-Identifier: BSD-3-Clause
#include "pipe_handling.h"

#include <algorithm>
#include <cmath>
#include <exception>

#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/model/forces/slips.h"
#include "drill_rig_sim/rig/hoisting.h"
#include "drill_rig_sim/scene/scene_mesh.h"
#include "drill_rig_sim/sim/integrator_table.h"

namespace drill_rig_sim
{
namespace
{
constexpr double same_place = 1e-6;  // of two nodes along the string [m]

/// Whether two strings are the same from the bit up to node `i`.
bool same_below(const Mesh& a, const Mesh& b, int i) noexcept
{
  for (std::size_t k = 0; k <= static_cast<std::size_t>(i); ++k)
    if (std::abs(a.nodes[k].from_bit - b.nodes[k].from_bit) > same_place) return false;
  return true;
}
}  // namespace

PipeHandling::PipeHandling(const Scene& scene, Motion& motion, CommandIntake& commands, SimulatorState& state)
    : scene_(scene), motion_(motion), commands_(commands), state_(state), connection_(state.connection), string_(state.string)
{
  string_ = {motion_.model()->mesh().total_length, scene_.start.bit_depth};
  string_changed();
}

int PipeHandling::joint_at_table() const noexcept
{
  const Model& model = *motion_.model();
  const State& now = motion_.shown();
  int nearest = -1;
  double away = 0.0;
  for (int i = 1; i < model.top(); ++i)
  {
    const MeshNode& node = model.mesh().nodes[static_cast<std::size_t>(i)];
    if (!node.joint_end || !model.scene().string[static_cast<std::size_t>(node.part)].pipe) continue;
    const double z = std::abs(now.nodes[static_cast<std::size_t>(i)].position.z() - now.hoist.floor.height);
    if (nearest >= 0 && z >= away) continue;
    nearest = i;
    away = z;
  }
  return nearest;
}

int PipeHandling::joint_for(int joints, bool remove) const
{
  const Mesh& mesh = motion_.model()->mesh();
  if (!remove) return uppermost_joint(mesh);
  const int count = joints > 0 ? joints : scene_.rig.hoisting.stand_joints;
  if (joints_below_stump(mesh, scene_) <= count) return -1;
  return uppermost_joint(build_mesh(scene_, string_.length - count * scene_.string.back().joint_length));
}

double PipeHandling::place_of(int joint) const noexcept
{
  return motion_.model()->mesh().nodes[static_cast<std::size_t>(joint)].from_bit;
}

const char* PipeHandling::why_not_set(int joint) const noexcept
{
  if (const char* refused = why_slips_are_not_set(commands_.at_table())) return refused;
  return joint < 0 ? "slips: there is no joint of pipe below the shaft" : nullptr;
}

/// Each end of a stand is a node in any mesh of the string.
int PipeHandling::joint_at(double from_bit) const noexcept
{
  const Mesh& mesh = motion_.model()->mesh();
  int nearest = 1;
  for (int i = 1; i + 1 < static_cast<int>(mesh.nodes.size()); ++i)
  {
    const auto away = [&](int k) { return std::abs(mesh.nodes[static_cast<std::size_t>(k)].from_bit - from_bit); };
    if (mesh.nodes[static_cast<std::size_t>(i)].joint_end && away(i) < away(nearest)) nearest = i;
  }
  return nearest;
}

void PipeHandling::set_slips(int joint) noexcept
{
  motion_.change(
      [joint](State& state)
      {
        const NodeState& node = state.nodes[static_cast<std::size_t>(joint)];
        state.slips = {joint, node.position - state.hoist.floor.height * Eigen::Vector3d::UnitZ(), node.spin_angle};
      });
}

const char* PipeHandling::why_not_pulled() const noexcept
{
  if (const char* refused = why_slips_are_not_pulled(commands_.at_table())) return refused;
  const bool bear = slips_load(motion_.shown()) > most_slips_load;
  return bear ? "slips: the slips carry the string, allowed: up to 5 kN, pick up first" : nullptr;
}

void PipeHandling::pull_slips() noexcept
{
  motion_.change([](State& state) { state.slips = HeldNode(); });
}

double PipeHandling::rest_load() const noexcept
{
  return motion_.shown_forces().tension[static_cast<std::size_t>(motion_.shown().slips.node)];
}

double PipeHandling::length_of(int joints, bool remove) const noexcept
{
  const int count = joints > 0 ? joints : scene_.rig.hoisting.stand_joints;
  return (remove ? -1.0 : 1.0) * count * scene_.string.back().joint_length;
}

const char* PipeHandling::why_no_connection(int joints, bool remove) const noexcept
{
  const HoistingSpec& hoisting = scene_.rig.hoisting;
  const State& now = motion_.shown();
  const int count = joints > 0 ? joints : hoisting.stand_joints;
  if (const char* refused = drill_rig_sim::why_no_connection(commands_.at_table())) return refused;
  if (now.stuck_point.node > now.slips.node) return "connection: the pipe is stuck above the slips";
  if (rest_load() > most_rest_load)
    return "connection: the hook carries more than block and pipe above the slips, allowed: up to 10 kN more, slack off first";
  if (motion_.shown_forces().hook_load < most_rest_load)
    return "connection: the block rests on the pipe, allowed: only on its lines, pick up first";
  if (remove && count >= joints_below_stump(motion_.model()->mesh(), scene_))
    return "connection: the string has fewer joints than are to be removed";
  const double height = block_height(now) + length_of(joints, remove);
  if (height > hoisting.highest_block_height) return "connection: the block would rise above highest_block_height";
  return height < hoisting.lowest_block_height ? "connection: the block would go below lowest_block_height" : nullptr;
}

const char* PipeHandling::begin_connection(double length) noexcept
{
  try
  {
    return break_out(length);
  }
  catch (const std::exception&)
  {
    return "connection: the solver cannot continue with the changed string";
  }
}

const char* PipeHandling::break_out(double length)
{
  const std::shared_ptr<const Model> longer = model_of({string_.length + length, state_.truth.bit_depth}),
                                     model = motion_.model();
  const int held = motion_.shown().slips.node;
  if (uppermost_joint(length < 0.0 ? longer->mesh() : model->mesh()) != held || !same_below(model->mesh(), longer->mesh(), held))
    return "connection: the slips hold another joint than the one to break out, move the block there first";
  motion_.settle();
  const State& now = motion_.shown();
  const State next = made_up(*longer, now, held, length, motion_.free_length_of(*longer));
  make_integrator(scene_.numerics.integrator, longer, next);
  const double foot = next.nodes[static_cast<std::size_t>(held)].position.z(),
               block = standard_gravity * scene_.rig.hoisting.block_mass;
  const double after = hanging_pipe(*longer, held, foot).weight;
  const double travel = next.nodes.back().position.z() - now.nodes.back().position.z();
  connection_ = {true,         0.0, length, travel, block + (length < 0.0 ? after : hanging_pipe(*model, held, foot).weight),
                 block + after};
  if (!commands_.crew_drives()) commands_.by_crew() = Setpoints();
  commands_.let_crew_drive(true);
  return nullptr;
}

void PipeHandling::go_on(double duration) noexcept
{
  if (connection_.under_way) connection_.elapsed += duration;
}

void PipeHandling::follow(double elapsed) noexcept
{
  if (connection_.under_way) connection_.elapsed = elapsed;
}

bool PipeHandling::is_made_up() const noexcept
{
  return connection_.under_way &&
         connection_.elapsed >= connection_duration(scene_.rig.hoisting, connection_.travel) - time_rounding;
}

void PipeHandling::end_connection()
{
  motion_.settle();
  const State& now = motion_.shown();
  const int held = now.slips.node;
  string_ = {string_.length + connection_.length, state_.truth.bit_depth};
  const std::shared_ptr<const Model> longer = model_of(string_);
  const double free_length = motion_.free_length_of(*longer);
  State next = made_up(*longer, now, held, connection_.travel, free_length);
  RigForces forces = forces_of_made_up(*longer, next, motion_.shown_forces(), held);
  motion_.go_on_with(longer, std::move(next), std::move(forces), free_length);
  connection_ = ConnectionState();
  commands_.let_crew_drive(state_.crew.doing != CrewTask::none);
}

std::shared_ptr<const Model> PipeHandling::model_of(const StringBuilt& string) const
{
  Scene there = scene_;
  there.start.bit_depth = string.bit_depth;
  return std::make_shared<Model>(there, build_mesh(scene_, string.length, string.bit_depth));
}

void PipeHandling::string_changed()
{
  joint_below_stand_ = joint_for(0, true);
}

}  // namespace drill_rig_sim
