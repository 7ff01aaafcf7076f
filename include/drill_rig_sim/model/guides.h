// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_MODEL_GUIDES_H
#define DRILL_RIG_SIM_MODEL_GUIDES_H

#include <Eigen/Core>
#include <vector>

#include "drill_rig_sim/contact/contact_spec.h"
#include "drill_rig_sim/math/block_tridiagonal.h"
#include "drill_rig_sim/math/columns.h"
#include "drill_rig_sim/well/wellbore.h"

/// Guided nodes: model no more than a scene needs.
///
/// A node is free, with six coordinates, or guided: it stays where the hole has it, with two, how far it has moved along the hole
/// and turned about it since the start of the step, (s, phi). Its motion is that of a free node through a 6x2 matrix that holds
/// for a step,
///   displacement = t s,   rotation = w s + t phi,   t the hole's tangent there, w = t x dt/dmd its turn per length,
/// after which it is put back onto its hole. What the laws say in six coordinates counts by T^t r and T^t K T; T does not change
/// within a step, so its derivative is none. (A step of 15 mm in a hole of 17 deg/30 m leaves its tangent by a micrometre.) The
/// rest of r, across the hole, is what the wall must give: the load Q on it, which makes its friction (forces/guided_string.h).
///
/// Vectors of increments and residuals keep six places per node in world axes, for guided nodes too: (t s, w s + t phi) and (t
/// r_s, t r_phi). Only the linear solve knows that those are two unknowns.
namespace drill_rig_sim
{
class Model;
struct State;
struct Stage;
struct Workspace;

/// Constants of a guided node during a step.
struct Guide
{
  Eigen::Vector3d tangent;                                  ///< t of the hole, down it
  Eigen::Vector3d turn;                                     ///< w [rad/m]
  Eigen::Vector3d centre;                                   ///< of the hole [m]
  Eigen::Vector3d weight;                                   ///< of half of the guided elements beside it, in mud [N]
  double mass, spin_inertia;                                ///< [kg, kg m2]
  double mud_along, mud_about;                              ///< drag of the mud [N s/m, N m s]
  double friction;                                          ///< kinetic [-]
  double lever;                                             ///< of that friction about the axis [m]
  double clearance;                                         ///< between string and wall all around [m]
  double held;                                              ///< by friction around the pipe at the start of the step [N]
  double stribeck_speed, static_ratio, stiffness, damping;  ///< of the friction, as of WallLaw
};

/// Constants of an element between two guided nodes during a step.
struct GuidedSpan
{
  double axial, torsion;  ///< EA/L, GJ/L [N/m, N m/rad]
  double stretch;         ///< at the start of the step, what pressure makes of it taken off [m]
  double twist;           ///< at the start of the step, lower end relative to upper [rad]
};

/// Guides and guided spans by column; an element has the number of its lower node. Of free nodes only what the model says means
/// anything.
struct GuideColumns
{
  // of the model
  Column mass, spin_inertia, lever, bearing_radius;
  Column mud_along, mud_about;             ///< where it is immersed
  Column length, axial, torsion, bending;  ///< of elements; bending: EI [N m2]
  // of the step
  Columns<3> tangent, turn, centre, weight;
  Column wet_along, wet_about;  ///< Guide::mud_along, mud_about
  Column friction, clearance, held, stribeck_speed, static_ratio, stiffness, damping;
  Columns<3> direction;  ///< from the hole's centre at the element's lower end to that at its upper one, unit length; 0 beside
                         ///< guided spans
  Column stretch, twist;
  Columns<2> bristle;                 ///< of the friction, along the hole and around it [m]
  Column rest;                        ///< how long it has stuck [s]
  std::vector<unsigned char> guided;  ///< per node

  template <class V>
  void visit(V& v)
  {
    v("mass", mass);
    v("spin_inertia", spin_inertia);
    v("lever", lever);
    v("bearing_radius", bearing_radius);
    v("mud_along", mud_along);
    v("mud_about", mud_about);
    v("length", length);
    v("axial", axial);
    v("torsion", torsion);
    v("bending", bending);
    v("tangent", tangent);
    v("turn", turn);
    v("centre", centre);
    v("weight", weight);
    v("wet_along", wet_along);
    v("wet_about", wet_about);
    v("friction", friction);
    v("clearance", clearance);
    v("held", held);
    v("stribeck_speed", stribeck_speed);
    v("static_ratio", static_ratio);
    v("stiffness", stiffness);
    v("damping", damping);
    v("direction", direction);
    v("stretch", stretch);
    v("twist", twist);
    v("bristle", bristle);
    v("rest", rest);
  }
  explicit GuideColumns(std::size_t nodes) : guided(nodes, 0) { ColumnSizes::resize(*this, nodes); }

  Guide operator[](std::size_t i) const noexcept
  {
    const std::ptrdiff_t k = static_cast<std::ptrdiff_t>(i);
    return {tangent[k],  turn[k],  centre[k],    weight[k], mass[k],           spin_inertia[k], wet_along[k], wet_about[k],
            friction[k], lever[k], clearance[k], held[k],   stribeck_speed[k], static_ratio[k], stiffness[k], damping[k]};
  }
  /// Whether element e is between two guided nodes.
  bool spans(std::size_t e) const noexcept { return guided[e] && guided[e + 1]; }
  GuidedSpan span(std::size_t e) const noexcept
  {
    const std::ptrdiff_t k = static_cast<std::ptrdiff_t>(e);
    return {axial[k], torsion[k], stretch[k], twist[k]};
  }
  void set_law(std::size_t i, const WallLaw& law) noexcept;
};

/// Runs of neighbouring nodes or elements, in ascending order; room for all there can be.
class Runs
{
public:
  struct Run
  {
    int first, last;  ///< from and to, the latter not among them
  };

  explicit Runs(std::size_t count) : runs_(count / 2 + 1) {}
  void clear() noexcept { count_ = 0; }
  /// Node or element i, which is behind all that are there.
  void add(int i) noexcept
  {
    if (count_ > 0 && runs_[count_ - 1].last == i)
      runs_[count_ - 1].last = i + 1;
    else
      runs_[count_++] = {i, i + 1};
  }
  bool empty() const noexcept { return count_ == 0; }
  const Run* begin() const noexcept { return runs_.data(); }
  const Run* end() const noexcept { return runs_.data() + count_; }

private:
  std::vector<Run> runs_;
  std::size_t count_ = 0;
};

/// Calls visit(first, last) for the runs between these, of 0 to count - 1.
template <class Visit>
void each_between(const Runs& runs, int count, Visit&& visit)
{
  int i = 0;
  for (const Runs::Run& run : runs)
  {
    if (run.first > i) visit(i, run.first);
    i = run.last;
  }
  if (i < count) visit(i, count);
}

/// And visit(i) for what is in them.
template <class Visit>
void each_outside(const Runs& runs, int count, Visit&& visit)
{
  each_between(runs, count,
               [&](int first, int last)
               {
                 for (int i = first; i < last; ++i) visit(i);
               });
}

/// How guided nodes move at a stage, what their walls do, and tension and torque of the elements above them, damping included; by
/// column.
struct GuidedMotions
{
  Column along, about;                            ///< s, phi [m, rad]
  Column along_rate, about_rate;                  ///< [m/s, rad/s]
  Column along_acceleration, about_acceleration;  ///< [m/s2, rad/s2]
  Columns<3> push;                                ///< load on the wall [N]
  Columns<3> lean;                                ///< the same without what free neighbours give [N]
  Column around;                                  ///< friction of the wall around the pipe [N]
  Column tension, torque;                         ///< [N, N m]

  template <class V>
  void visit(V& v)
  {
    v("along", along);
    v("about", about);
    v("along_rate", along_rate);
    v("about_rate", about_rate);
    v("along_acceleration", along_acceleration);
    v("about_acceleration", about_acceleration);
    v("push", push);
    v("lean", lean);
    v("around", around);
    v("tension", tension);
    v("torque", torque);
  }
  explicit GuidedMotions(std::size_t nodes) { ColumnSizes::resize(*this, nodes); }
};

/// Puts a guided node onto its hole where it is: md, side.
void settle_in_hole(State& state, std::size_t i) noexcept;
/// Gives a span the twist that its ends have.
void settle_span(State& state, std::size_t e) noexcept;
/// Both for all guided nodes and spans. Call it after the nodes were placed in six coordinates.
void settle_guided(State& state) noexcept;

/// Length of the guided string between nodes e and e + 1 [m]: of the line in which it lies, that of the hole's axis and what the
/// sides add or take. A string on the inside of a bend is shorter by clearance times angle.
double guided_length(const State& state, std::size_t e) noexcept;

/// Fills the constants of guided nodes and elements that depend only on the scene.
void prepare_guides(const Model& model, Stage& stage);

/// Takes the state's guided nodes into the stage; its loads, normals and free stretches must be there.
void find_guides(const Model& model, const State& state, Stage& stage) noexcept;

/// Solves tangent x = b in place of b, both with six places per node: residual in, increment out. False: singular.
bool solve_increment(const Stage& stage, BlockTridiagonal& tangent, double* b) noexcept;
/// The same with the factors of the last solve_increment().
void solve_increment_again(const Stage& stage, const BlockTridiagonal& tangent, double* b) noexcept;

/// The motion of a guided node as a free one's, into work.nodes: all but its place.
void expand_motion(const Stage& stage, int i, Workspace& work) noexcept;
/// The motions of the guided nodes in six coordinates, where evaluate() has left them out: increments, rates and accelerations.
void expand_motions(const Stage& stage, Workspace& work) noexcept;

/// Commits the guided nodes: along their hole, on the side of it that their load presses them to and that friction makes them
/// climb to, which they change over half a second; in statics half of it at once.
void commit_guided(const Stage& stage, const Workspace& work, State& state) noexcept;

}  // namespace drill_rig_sim

#endif
