// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_STRING_MESH_H
#define DRILL_RIG_SIM_STRING_MESH_H

#include <vector>

#include "drill_rig_sim/contact/contact_spec.h"
#include "drill_rig_sim/string/element_lengths.h"
#include "drill_rig_sim/string/mud.h"
#include "drill_rig_sim/string/part.h"
#include "drill_rig_sim/string/beam_element.h"

namespace drill_rig_sim
{
/// A node of the string's mesh: rigid cross-section, contact point where it touches the wall, lumped inertia.
struct MeshNode
{
  double from_bit = 0.0;         ///< unstretched distance from the bit's face [m]
  double contact_radius = 0.0;   ///< [m]
  double friction_radius = 0.0;  ///< WallLaw's [m]
  double bearing_radius =
      0.0;  ///< of what carries the string's load here while it lies straight: within a joint its ends, if they are wider [m]
  ContactLaw contact;
  double mass = 0.0;          ///< in air [kg]
  double mud_inside = 0.0;    ///< in the bore; moves along sideways [kg]
  double mud_outside = 0.0;   ///< as much as the string's outside displaces; confinement() says how much of it moves along [kg]
  double diameter = 0.0;      ///< of the string's outside, mean over its share [m]
  double mud_along = 0.0;     ///< linear drag of the mud along the string (mud_damping.h) [N s/m]
  double mud_across = 0.0;    ///< across it [N s/m]
  double mud_about = 0.0;     ///< against spin [N m s/rad]
  double spin_inertia = 0.0;  ///< about the string's axis [kg m2]
  double tilt_inertia = 0.0;  ///< about any axis across it [kg m2]
  double length = 0.0;        ///< share of the string [m]
  double squeeze_film_damping = 0.0;  ///< of lateral motion by the mud squeezed between blades or gauge and wall [N s/m]
  int part = 0;                       ///< index of the part below it
  int joint = 0;                      ///< joint of that part, counted from its lower end
  bool joint_end = false;             ///< upper end of a joint
};

/// The beam between nodes i (lower) and i + 1 (upper).
struct MeshElement
{
  BeamSection section;
  double linear_mass = 0.0;  ///< in air, averaged over the element [kg/m]
  double displaced = 0.0;    ///< volume of mud displaced per length, the string full of it [m3/m]
  double holds = 0.0;        ///< volume of mud inside per length, none in the bit's own [m3/m]
  double bend = 0.0;         ///< its upper end's normal is turned by this about the upper node's z axis, towards y [rad]
  Eigen::Quaterniond upper_end = Eigen::Quaterniond::Identity();  ///< that turn
  double outer_area = 0.0;                                        ///< [m2]
  double bore_area = 0.0;                                         ///< [m2]
  double outer_diameter = 0.0;
  ContactLaw contact;            ///< of its middle
  double friction_radius = 0.0;  ///< WallLaw's [m]
  int part = 0;
};

/// The drillstring as nodes and elements, bit first. Node 0 is the centre of the bit's ball, half a diameter above the bit's
/// face; the bit is a rigid body on it. A bit with a gauge length has node 1 at the upper end of its pads, so that they take
/// moments between two circles; between these it bends like the part above it. The last node is the top-drive shaft. Every
/// joint's end but one between two joints that are one element, every part's end, stabiliser's blade, bend, pads and pivot is a
/// node.
/// A tool that shakes the string (model/forces/oscillator.h), at the node nearest to the middle of its part.
struct Oscillator
{
  int node;
  double force, frequency;  ///< amplitude [N], [Hz]
};

struct Mesh
{
  std::vector<MeshNode> nodes;
  std::vector<MeshElement> elements;
  double total_length = 0.0;   ///< unstretched, bit's face to top-drive shaft [m]
  double bit_radius = 0.0;     ///< [m]
  double bit_mass = 0.0;       ///< [kg]
  double bit_displaced = 0.0;  ///< volume [m3]
  int gauge_nodes = 1;  ///< number of the lowest nodes that are the bit's gauge: their contact turns with the motor and loads it
  int bend_node = -1;   ///< -1: straight string
  int pad_node = -1;    ///< where a rotary steerable tool pushes; -1: none
  int pivot_node = -1;  ///< where one that points leans; -1: none
  double sensor_from_bit = -1.0;  ///< the MWD's sensor; -1: none
  std::vector<Oscillator> oscillators;
  std::vector<double> part_bottom;  ///< from_bit of each part's lower end [m]
  std::vector<double> part_top;

  /// Of the rotary steerable tool; -1: there is none.
  int steering_node() const noexcept { return pivot_node >= 0 ? pivot_node : pad_node; }
  /// Whether element `e` begins at the pivot with the shaft of a tool that points.
  bool is_shaft(int e) const noexcept { return e + 1 == pivot_node; }
  /// Unstretched distance of an element's middle from the bit's face [m].
  double middle(std::size_t e) const noexcept { return 0.5 * (nodes[e].from_bit + nodes[e + 1].from_bit); }
};

/// Cuts a string of `parts`, bit first, in `mud` into elements no longer than `longest`; `contact`: the wall's laws for parts
/// without one of their own, stiffer under gauge, blades and sleeve. `total_length` [m] fixes how many joints the `fill` entry
/// has and how long its last one is. Throws std::runtime_error if the string does not fit.
Mesh build_mesh(const std::vector<PartSpec>& parts, const ContactSpec& contact, const MudSpec& mud, const ElementLengths& longest,
                double total_length);

}  // namespace drill_rig_sim

#endif
