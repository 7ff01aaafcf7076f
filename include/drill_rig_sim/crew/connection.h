// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_CREW_CONNECTION_H
#define DRILL_RIG_SIM_CREW_CONNECTION_H

#include <memory>

#include "drill_rig_sim/model/model.h"
#include "drill_rig_sim/model/rig_forces.h"
#include "drill_rig_sim/model/state.h"
#include "drill_rig_sim/rig/hoisting.h"

/// Pipe that is added to the string, or taken away, while it rests in the slips.
///
/// The slips grip a joint's end at the rotary table. What is above it up to the shaft, the stump, stays on the top drive: a short
/// piece, for the last part fills up to the block. A connection breaks the string there and adds or removes joints.
/// The string below is what it was, node by node; while it is broken out it goes on resting in the slips, and hook load, torque
/// and block height are those of a block that runs by itself: a quarter of the time to break out, half of it to run, a quarter to
/// make up, all of them smooth.
namespace drill_rig_sim
{
/// Largest pull of the pipe above the slips at break-out, and least load of the lines [N].
constexpr double most_rest_load = 10e3;
constexpr unsigned most_joints = 12;     ///< of one connection
constexpr double most_slips_load = 5e3;  ///< largest load on the slips when they are pulled [N]

/// The string that a rig has at present.
struct StringBuilt
{
  double length = 0.0;     ///< unstretched, bit's face to shaft [m]
  double bit_depth = 0.0;  ///< when it was built, for the mud's way past it [m]

  template <class V>
  void visit(V& v)
  {
    v("length", length);
    v("bit_depth", bit_depth);
  }
};

/// A connection under way.
struct ConnectionState
{
  bool under_way = false;
  double elapsed = 0.0;       ///< since the break-out began [s]
  double length = 0.0;        ///< of the pipe that is added; < 0: taken away [m]
  double travel = 0.0;        ///< of the block, + up: that length, stretched as it hangs [m]
  double load_between = 0.0;  ///< of the hook while the block runs: block and stump [N]
  double load_after = 0.0;    ///< made up: with the pipe that hangs down to the slips [N]

  template <class V>
  void visit(V& v)
  {
    v("under_way", under_way);
    v("elapsed", elapsed);
    v("length", length);
    v("travel", travel);
    v("load_between", load_between);
    v("load_after", load_after);
  }
};

/// The block by itself.
struct BlockRun
{
  double travel = 0.0;  ///< since the break-out, + up [m]
  double speed = 0.0;   ///< [m/s]
};

/// How long a connection takes whose block runs by `travel` x [m], and where the block is then: a cycloid, x (s - sin(2 pi s)/(2
/// pi)), s the share of the time T that it runs, whose speed is at most 2 x/T and whose acceleration 2 pi x/T^2. T is half of
/// connection_time, or what keeps these within the winch's limits [s].
double connection_duration(const HoistingSpec& spec, double travel) noexcept;
BlockRun block_run(const HoistingSpec& spec, const ConnectionState& connection) noexcept;

/// What shows of a quantity of the string's top that is `held` [N, N m] in the string in the slips, `between` only on the block
/// and `after` when it is made up: smooth from one to the next.
double shown_while_broken_out(const HoistingSpec& spec, const ConnectionState& connection, double held, double between,
                              double after) noexcept;

/// The uppermost end of a joint below the shaft: what the slips hold when pipe is added; -1: there is none.
int uppermost_joint(const Mesh& mesh) noexcept;

/// Whole joints of the last part below that.
int joints_below_stump(const Mesh& mesh, const Scene& scene) noexcept;

/// How the pipe above a node hangs when its lower end is free.
struct HangingPipe
{
  double weight = 0.0;  ///< of its nodes, the held one left out [N]
  double height = 0.0;  ///< of the shaft [m]
};

/// Of the mesh above node `held`, which is at height `z` [m]; its elements' weights lie half on each of their nodes, as in the
/// model.
HangingPipe hanging_pipe(const Model& model, int held, double z) noexcept;

/// The state of a rig whose string was broken out above node `held` and made up as `model` has it: below as in `before`, the pipe
/// above hanging straight from a block at rest, without load on what is below. Its method starts anew. `travel`: that the block
/// has run [m].
State made_up(const Model& model, const State& before, int held, double travel, double free_length);

/// Forces of that state, as far as they are shown before its first step.
RigForces forces_of_made_up(const Model& model, const State& state, const RigForces& before, int held);

}  // namespace drill_rig_sim

#endif
