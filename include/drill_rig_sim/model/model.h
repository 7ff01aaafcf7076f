// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_MODEL_MODEL_H
#define DRILL_RIG_SIM_MODEL_MODEL_H

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "drill_rig_sim/contact/section_friction.h"
#include "drill_rig_sim/hydraulics/cuttings.h"
#include "drill_rig_sim/hydraulics/mud_circuit.h"
#include "drill_rig_sim/hydraulics/mud_heat.h"
#include "drill_rig_sim/math/kernel.h"
#include "drill_rig_sim/scene/scene.h"
#include "drill_rig_sim/string/beam_table.h"
#include "drill_rig_sim/string/lower_body.h"
#include "drill_rig_sim/string/mesh.h"
#include "drill_rig_sim/well/formation.h"
#include "drill_rig_sim/well/pilot_hole.h"
#include "drill_rig_sim/well/wellbore.h"

namespace drill_rig_sim
{
using Vector6d = Eigen::Matrix<double, 6, 1>;

/// What of rig, string and rock does not change: mesh, sections, parameters of the laws. Constant and shared: any number of
/// threads may evaluate one Model at once, each with a Workspace of its own. What changes is the State (state.h).
class Model
{
public:
  Model(const Scene& scene, Mesh mesh);
  Model(const Model&) = delete;
  Model& operator=(const Model&) = delete;

  const Scene& scene() const noexcept { return scene_; }
  const Mesh& mesh() const noexcept { return mesh_; }
  const Formation& formation() const noexcept { return formation_; }
  const PilotHole& pilot() const noexcept { return pilot_; }
  /// What the bit stands on at a hole's bottom; of a pilot hole ahead the ring around it.
  const FormationLayer& rock_under(const Wellbore& well) const noexcept
  {
    return (pilot_.is_ahead(well.hole_depth()) ? ring_ : formation_).at(-well.bottom_position().z());
  }
  const BeamKind& beam() const noexcept { return beam_; }
  /// Of the batch kernels: what the scene means on this machine, never automatic.
  Kernel kernel() const noexcept { return kernel_; }
  int nodes() const noexcept { return static_cast<int>(mesh_.nodes.size()); }
  int elements() const noexcept { return static_cast<int>(mesh_.elements.size()); }
  /// The last node: the top drive's shaft.
  int top() const noexcept { return nodes() - 1; }
  const BitSpec& bit() const noexcept { return *scene_.string.front().bit; }
  /// Whether the bit cuts blade by blade (contact/bit_cut.h).
  bool regenerative() const noexcept { return traits_of(bit().torque.model).by_cut; }
  /// Null: none.
  const MotorSpec* motor() const noexcept { return motor_; }
  /// Of the rotary steerable tool; null: none.
  const SteerableSpec* steerable() const noexcept { return steerable_; }
  /// The mud's way through string and hole.
  const MudCircuit& mud() const noexcept { return mud_; }
  /// Mud with cuttings; none: the mud stays clean.
  const std::optional<CuttingsFluid>& cuttings() const noexcept { return cuttings_; }
  /// What the mud carries of heat; none: no mud.temperature.
  const std::optional<HeatMud>& heat() const noexcept { return heat_; }
  /// How fast the body that follows the bit lets the hole turn.
  const TurnLimit& turn_limit() const noexcept { return turn_limit_; }
  /// Wall contact at a node; friction as the scene has it everywhere.
  const WallLaw& contact(int i) const noexcept { return contact_[static_cast<std::size_t>(i)]; }
  /// And at an element's middle.
  const WallLaw& span_contact(int e) const noexcept { return span_contact_[static_cast<std::size_t>(e)]; }
  /// The same with the friction of where the hole is met, after a rest there [s].
  WallLaw contact(int i, const ClosestPoint& closest, double rest) const noexcept
  {
    return there(contact(i), closest.section, rest);
  }
  WallLaw contact(int i, double section, double rest) const noexcept { return there(contact(i), section, rest); }
  WallLaw span_contact(int e, const ClosestPoint& closest, double rest) const noexcept
  {
    return there(span_contact(e), closest.section, rest);
  }
  /// Whether these two ever differ from contact(i).
  bool contact_varies() const noexcept { return !friction_.uniform() || scene_.contact.growth.per_fold > 0.0; }
  /// Of the bristle that carries a stuck bit's torque [N m/rad].
  double bit_bristle_stiffness() const noexcept { return bit_bristle_; }
  /// Weight of element `e` in mud, its ends at heights `z_lower`, `z_upper` [m]; no buoyancy above the rotary table. Of a string
  /// that holds mud up to `bore_top` above the bit's face (HydraulicState), with what it holds and less what its outside
  /// displaces: it may float [N].
  double element_weight(int e, double z_lower, double z_upper, double bore_top) const noexcept
  {
    const WetElement& wet = wet_[static_cast<std::size_t>(e)];
    return z_upper <= 0.0 && bore_top >= wet.top ? wet.weight : partly_wet_weight(e, z_lower, z_upper, bore_top);
  }

private:
  // An element in mud that is full of it: how far its upper end is from the bit's face [m], and its weight [N].
  struct WetElement
  {
    double top, weight;
  };
  double partly_wet_weight(int e, double z_lower, double z_upper, double bore_top) const noexcept;
  WallLaw there(WallLaw law, double section, double rest) const noexcept
  {
    friction_.apply(section, law);
    law.static_ratio += scene_.contact.growth.at(rest);
    return law;
  }

  Scene scene_;
  Mesh mesh_;
  const BeamKind& beam_;
  Kernel kernel_;
  Formation formation_, ring_;  // the second around the pilot
  PilotHole pilot_;
  SectionFriction friction_;
  std::vector<WallLaw> contact_;              // per node
  std::vector<WallLaw> span_contact_;         // per element
  std::vector<WetElement> wet_;               // too
  const MotorSpec* motor_ = nullptr;          // into scene_
  const SteerableSpec* steerable_ = nullptr;  // too
  double bit_bristle_ = 0.0;
  MudCircuit mud_;
  std::optional<CuttingsFluid> cuttings_;
  std::optional<HeatMud> heat_;
  TurnLimit turn_limit_;
};

/// What of an element is below the rotary table, its ends at heights [m]: its lower part, 0 to 1.
double immersed_share(double z_lower, double z_upper) noexcept;

}  // namespace drill_rig_sim

#endif
