#ifndef DRILL_RIG_SIM_MODEL_GUIDES_H
#define DRILL_RIG_SIM_MODEL_GUIDES_H

#include <Eigen/Core>
#include <vector>

#include "drill_rig_sim/contact/contact_spec.h"
#include "drill_rig_sim/math/block_tridiagonal.h"
#include "drill_rig_sim/well/wellbore.h"

/// Guided nodes: model no more than a scene needs.
///
/// A node is free, with six coordinates, or guided: it stays where the hole has it, with two, how far it has moved along the hole and
/// turned about it since the start of the step, (s, phi). Its motion is that of a free node through a 6x2 matrix that holds for a step,
///   displacement = t s,   rotation = w s + t phi,   t the hole's tangent there, w = t x dt/dmd its turn per length,
/// after which it is put back onto its hole. What the laws say in six coordinates counts by T^t r and T^t K T; T does not change within a step, so
/// its derivative is none. (A step of 15 mm in a hole of 17 deg/30 m leaves its tangent by a micrometre.) The rest of r, across the hole, is what the
/// wall must give: the load Q on it, which makes its friction (forces/guided_string.h).
///
/// Vectors of increments and residuals keep six places per node in world axes, for guided nodes too: (t s, w s + t phi) and (t r_s, t r_phi).
/// Only the linear solve knows that those are two unknowns.
namespace drill_rig_sim
{
class Model;
struct State;
struct Stage;

/// What holds of a node during a step if it is guided.
struct Guide
{
  bool guided = false;
  bool joined = false;  ///< other forces than the guided string's act on it: end of the string, stuck point, next to a free node
  Eigen::Vector3d tangent = -Eigen::Vector3d::UnitZ();  ///< t of the hole, down it
  Eigen::Vector3d turn = Eigen::Vector3d::Zero();       ///< w [rad/m]
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();     ///< of the hole [m]
  Eigen::Vector3d side = Eigen::Vector3d::Zero();       ///< of the hole that the node lies on, from its centre [m]
  double md = 0.0;                                      ///< [m]
  // of the hole at the neighbours above and below, where they are guided too: its direction, unit length, the part across the hole here [-]
  Eigen::Vector3d above = Eigen::Vector3d::Zero(), below = Eigen::Vector3d::Zero();
  Eigen::Vector3d weight = Eigen::Vector3d::Zero();  ///< of half of those elements, in mud [N]
  double friction = 0.0;                             ///< kinetic [-]
  double lever = 0.0;                                ///< of that friction about the axis [m]
  double clearance = 0.0;                            ///< between string and wall all around [m]
  WallLaw law;
  double held = 0.0;  ///< by friction around the pipe at the start of the step [N]
};

/// The same of the element between two guided nodes.
struct GuidedSpan
{
  bool guided = false;
  double stretch = 0.0;  ///< at the start of the step, what pressure makes of it taken off [-]
  double twist = 0.0;    ///< at the start of the step, lower end relative to upper [rad]
};

/// Length of a guided string between two places of the line in which it lies, that of the hole's axis and what the sides add or take [m]. A string
/// on the inside of a bend is shorter by clearance times angle.
double length_between(const ClosestPoint& lower, const ClosestPoint& upper, const Eigen::Vector3d& lower_side, const Eigen::Vector3d& upper_side) noexcept;

/// Takes the state's guided nodes into the stage; its loads, normals and free stretches must be there.
void find_guides(const Model& model, const State& state, Stage& stage) noexcept;

/// Solves tangent x = b in place of b, both with six places per node: residual in, increment out. False: singular.
bool solve_increment(const Stage& stage, BlockTridiagonal& tangent, double* b) noexcept;
/// The same with the factors of the last solve_increment().
void solve_increment_again(const Stage& stage, const BlockTridiagonal& tangent, double* b) noexcept;

/// Puts the committed state's guided nodes back onto their hole, on the side of it that `lean` [N] presses them to (Workspace), which
/// they change over half a second; `time`: since the start of the step [s], 0 in statics: half of it at once.
void put_on_hole(const Stage& stage, const std::vector<Eigen::Vector3d>& lean, double time, State& state) noexcept;

}  // namespace drill_rig_sim

#endif
