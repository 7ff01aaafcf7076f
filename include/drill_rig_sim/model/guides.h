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
struct Workspace;

/// What holds of a node during a step if it is guided. Its numbers are a row for the batch kernel (kernels/guided_kernel.h), in this order.
struct Guide
{
  bool guided = false;
  Eigen::Vector3d tangent = -Eigen::Vector3d::UnitZ();  ///< t of the hole, down it
  // of the hole at the neighbours above and below, where they are guided too: its direction, unit length, the part across the hole here [-]
  Eigen::Vector3d above = Eigen::Vector3d::Zero(), below = Eigen::Vector3d::Zero();
  Eigen::Vector3d weight = Eigen::Vector3d::Zero();  ///< of half of those elements, in mud [N]
  double mass = 0.0, spin_inertia = 0.0;             ///< [kg, kg m2]
  double mud_along = 0.0, mud_about = 0.0;           ///< drag of the mud [N s/m, N m s]
  double friction = 0.0;                             ///< kinetic [-]
  double lever = 0.0;                                ///< of that friction about the axis [m]
  double clearance = 0.0;                            ///< between string and wall all around [m]
  double held = 0.0;                                 ///< by friction around the pipe at the start of the step [N]
  WallLaw law;
  Eigen::Vector3d turn = Eigen::Vector3d::Zero();    ///< w [rad/m]
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< of the hole [m]
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

/// The same of the element between two guided nodes.
struct GuidedSpan
{
  bool guided = false;
  double axial = 0.0, torsion = 0.0;  ///< EA/L, GJ/L [N/m, N m/rad]
  double stretch = 0.0;               ///< at the start of the step, what pressure makes of it taken off [m]
  double twist = 0.0;                 ///< at the start of the step, lower end relative to upper [rad]
};

/// How a guided node moves at a stage, and what its wall does.
struct GuidedMotion
{
  double along = 0.0, about = 0.0;                            ///< s, phi [m, rad]
  double along_rate = 0.0, about_rate = 0.0;                  ///< [m/s, rad/s]
  double along_acceleration = 0.0, about_acceleration = 0.0;  ///< [m/s2, rad/s2]
  Eigen::Vector3d push = Eigen::Vector3d::Zero();             ///< load on the wall [N]
  Eigen::Vector3d lean = Eigen::Vector3d::Zero();             ///< the same without what free neighbours give [N]
  double around = 0.0;                                        ///< friction of the wall around the pipe [N]
};

/// Tension and torque of a guided element, damping included [N, N m].
struct GuidedForce
{
  double tension = 0.0, torque = 0.0;
};

/// Puts a guided node onto its hole where it is: md, side.
void settle_in_hole(State& state, std::size_t i) noexcept;
/// Gives a span the twist that its ends have.
void settle_span(State& state, std::size_t e) noexcept;
/// Both, of all guided nodes and the spans between them: after somebody has placed them in six coordinates.
void settle_guided(State& state) noexcept;

/// Length of the guided string between nodes e and e + 1 [m]: of the line in which it lies, that of the hole's axis and what the sides add or take. A
/// string on the inside of a bend is shorter by clearance times angle.
double guided_length(const State& state, std::size_t e) noexcept;

/// What the scene alone says of all nodes and elements, once they are guided.
void prepare_guides(const Model& model, Stage& stage);

/// Takes the state's guided nodes into the stage; its loads, normals and free stretches must be there.
void find_guides(const Model& model, const State& state, Stage& stage) noexcept;

/// Solves tangent x = b in place of b, both with six places per node: residual in, increment out. False: singular.
bool solve_increment(const Stage& stage, BlockTridiagonal& tangent, double* b) noexcept;
/// The same with the factors of the last solve_increment().
void solve_increment_again(const Stage& stage, const BlockTridiagonal& tangent, double* b) noexcept;

/// The motions of the guided nodes in six coordinates, where evaluate() has left them out: increments, rates and accelerations.
void expand_motions(const Stage& stage, Workspace& work) noexcept;

/// Commits the guided nodes: along their hole, on the side of it that their load presses them to and that friction makes them climb to, which they
/// change over half a second; in statics half of it at once.
void commit_guided(const Stage& stage, const Workspace& work, State& state) noexcept;

}  // namespace drill_rig_sim

#endif
