// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/sim/level_watch.h"

#include <cmath>

#include "drill_rig_sim/model/levels.h"
#include "drill_rig_sim/scene/scene_mesh.h"
#include "drill_rig_sim/sim/string_watch.h"

namespace drill_rig_sim
{
namespace
{
constexpr double opens = 0.6;  // of the buckling load
constexpr double closes = 0.4;
constexpr double reach = 30.0;     // [m]
constexpr double patience = 10.0;  // [s]
}  // namespace

Level level_of(const Model& model, double free_length) noexcept
{
  if (free_length >= model.mesh().nodes.back().from_bit) return Level::beam3d;
  if (free_length > model.mesh().nodes.front().from_bit) return Level::hybrid;
  return model.scene().numerics.level == Level::rigid ? Level::rigid : Level::axial_torsional;
}

LevelWatch::LevelWatch(const Model& model) : free_length_(free_length(model.scene())), guided_(model.mesh().nodes.size())
{
  follow(model, free_length_);
  wanted_ = guided_;
}

void LevelWatch::follow(const Model& model, double free_length) noexcept
{
  free_length_ = free_length;
  for (std::size_t i = 0; i < guided_.size(); ++i) guided_[i] = model.mesh().nodes[i].from_bit > free_length ? 1 : 0;
}

/// Into wanted_; false: all may stay as it is.
bool LevelWatch::open(const Model& model, const RigForces& forces, const State& state) noexcept
{
  const std::vector<MeshNode>& nodes = model.mesh().nodes;
  bool any = false;
  for (std::size_t i = 0; i < nodes.size(); ++i) wanted_[i] = state.nodes[i].guided ? 1 : 0;
  for (std::size_t e = 0; e + 1 < nodes.size(); ++e)
  {
    if (!state.nodes[e].guided && !state.nodes[e + 1].guided) continue;
    if (buckling_share(model, state, e, forces.tension[e]) < opens) continue;
    any = true;
    const double middle = model.mesh().middle(e);
    for (std::size_t i = e + 1; i-- > 0 && nodes[i].from_bit > middle - reach;) wanted_[i] = 0;
    for (std::size_t i = e + 1; i + 1 < nodes.size() && nodes[i].from_bit < middle + reach; ++i) wanted_[i] = 0;
  }
  // a guided node alone would know of no load that presses it to its wall
  for (std::size_t i = 1; any && i + 1 < nodes.size(); ++i)
    if (!wanted_[i - 1] && !wanted_[i + 1]) wanted_[i] = 0;
  return any;
}

bool LevelWatch::calm(const Model& model, const RigForces& forces, const State& state) const noexcept
{
  for (std::size_t e = 0; e + 1 < guided_.size(); ++e)
  {
    const bool in_window = (guided_[e] && !state.nodes[e].guided) || (guided_[e + 1] && !state.nodes[e + 1].guided);
    if (in_window && buckling_share(model, state, e, forces.tension[e]) > closes) return false;
  }
  return true;
}

void LevelWatch::look(const Model& model, const RigForces& forces, double duration, State& state, LevelMemory& memory) noexcept
{
  const double since = memory.unseen + duration;
  memory.unseen = 0.0;
  if (free_length_ != memory.free_length) follow(model, memory.free_length);
  if (memory.moved)
  {
    change_guided(model, guided_, forces, state);
    memory.moved = false;
    memory.calm = 0.0;
    return;
  }
  if (level_of(model, memory.free_length) != Level::hybrid) return;
  if (open(model, forces, state))
  {
    if (change_guided(model, wanted_, forces, state)) ++memory.opened;
    memory.calm = 0.0;
    return;
  }
  if (wanted_ == guided_ || !calm(model, forces, state))
  {
    memory.calm = 0.0;
    return;
  }
  memory.calm += since;
  if (memory.calm < patience) return;
  if (change_guided(model, guided_, forces, state)) ++memory.closed;
  memory.calm = 0.0;
}

}  // namespace drill_rig_sim
