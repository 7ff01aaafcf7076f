// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_CONTACT_BIT_TORQUE_H
#define DRILL_RIG_SIM_CONTACT_BIT_TORQUE_H

#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/well/formation.h"

/// Torque on bit: how much the rock can resist the bit's turning, and the bristle that lets a stuck bit really stick.
namespace drill_rig_sim
{
/// The laws, by which one of the functions below gives the largest torque; the list says what each of them is.
enum class BitTorqueModel
{
#define BIT_LAW(name, ...) name,
#include "drill_rig_sim/contact/bit_law_list.h"
};

struct BitLawTraits
{
  const char* word;  ///< of the scene file
  bool drag;         ///< cutters and wear flats carry the weight by their width; else the face rubs
  bool by_cut;       ///< weight and torque by the depth that each blade cuts (bit_cut.h)
};

/// By BitTorqueModel.
constexpr BitLawTraits bit_laws[] = {
#define BIT_LAW(name, limit, drag, by_cut, meaning) {#name, drag, by_cut},
#include "drill_rig_sim/contact/bit_law_list.h"
};
constexpr BitLawTraits traits_of(BitTorqueModel model) noexcept
{
  return bit_laws[static_cast<int>(model)];
}

struct BitTorqueSpec
{
  BitTorqueModel model = BitTorqueModel::stribeck;
  double static_friction = 0.6;   ///< YAML `static` [-]
  double kinetic_friction = 0.4;  ///< YAML `kinetic` [-]
  double speed = 30.0 * rpm;      ///< YAML `speed_rpm`: bit speed over which it falls [rad/s]
  double cutting_energy = 0.0;    ///< drag: intrinsic specific energy epsilon; 0: what the rock's drillability says [J/m3]
  double wear_friction = 0.6;     ///< drag: mu * gamma of the wear flat [-]
  double wear_weight = 0.0;       ///< drag: weight carried by the wear flats [N]
  int blades = 5;                 ///< by_cut: n, alike and evenly set
};

/// The largest torque at a force on the bottom and a bit speed, and its slopes.
struct TorqueLimit
{
  double value = 0.0;        ///< T_max >= 0 [N m]
  double force_slope = 0.0;  ///< dT_max/dF [m]
  double speed_slope = 0.0;  ///< dT_max/d|N| [N m s/rad]
};

/// Velocity-weakening friction: T_max = mu_b(|N|) F D/3, mu_b = mu_k + (mu_s - mu_k) exp(-|N|/N_s).
/// D/3 is the mean arm of a uniform pressure over the bit's face: int r dA / A = D/3.
/// @param spec      static_friction, kinetic_friction [-], speed N_s [rad/s]
/// @param diameter  D [m]
/// @param force     F on the bottom [N]
/// @param speed     N, either sign [rad/s]
TorqueLimit stribeck_bit_torque(const BitTorqueSpec& spec, double diameter, double force, double speed) noexcept;

/// zeta of a drag bit: the weight that its cutters need over the force they cut with. Detournay and Defourny measured 0.5 to 0.8.
constexpr double cutter_inclination = 0.6;

/// The zeta that a drillability K and an intrinsic specific energy epsilon make together [-]: the cutters carry W - F_0 = zeta
/// epsilon a d, the rock law says d = 2 pi K (W - F_0), hence zeta = 1/(2 pi a K epsilon). For the exponents alpha = beta = 1.
/// @param diameter  D = 2 a [m]
double implied_inclination(double diameter, double drillability, double cutting_energy) noexcept;

/// Drag bit: cutting plus friction of the wear flats, T_max = epsilon a^2 d/2 + mu_gamma (a/2) min(F, W_f),
/// a = D/2, d = 2 pi v/N the depth of cut per revolution, epsilon the intrinsic specific energy, mu_gamma the friction of the
/// wear flats times the bit's constant gamma, W_f the weight that the flats carry when they bear fully. v = K (F - F_0)^alpha
/// N^beta by the formation, hence d = 2 pi K (F - F_0)^alpha N^(beta - 1). Below 1 rad/s N is held at 1 rad/s here: a stuck bit
/// is held by the cut it is in, not by an infinite one. With epsilon = 0 the two laws share one input: the cutters' weight W_c =
/// F - F_0 cuts by T_c = a W_c/(2 zeta), zeta the cutter_inclination, whatever the exponents. Source: Detournay and Defourny, A
/// phenomenological model for the drilling action of drag bits, Int. J. Rock Mech. Min. Sci. 29 (1992), 13-23: T = T_c + T_f, T_c
/// = epsilon a^2 d/2, W_c = zeta epsilon a d, 2 T_f/a = mu gamma W_f.
/// @param spec  cutting_energy [J/m3], wear_friction [-], wear_weight [N]
/// @param rock  drillability K, weight_exponent alpha, speed_exponent beta, threshold F_0
TorqueLimit detournay_bit_torque(const BitTorqueSpec& spec, double diameter, double force, double speed,
                                 const FormationLayer& rock) noexcept;

/// The one that `spec.model` selects; on a ring of rock (pilot_hole.h) with its share and lever.
TorqueLimit bit_torque_limit(const BitTorqueSpec& spec, double diameter, double force, double speed,
                             const FormationLayer& rock) noexcept;

/// Torque on bit at one implicit stage.
struct BitTorque
{
  double value = 0.0;        ///< T against clockwise turning; the string gets -T about the bit's axis [N m]
  double spin_slope = 0.0;   ///< dT/d sigma, sigma the housing's spin in the step [N m/rad]
  double force_slope = 0.0;  ///< dT/dF [m]
  double twist = 0.0;        ///< bristle's new twist: the next step's, once this one is accepted [rad]
  bool slipping = false;
};

/// Sticking and slipping by return mapping, as for the wall: z_t = z_n + slip; T = k z_t while |T| <= T_max(|N|, F), else
/// T = sign(z_t) T_max and z = T/k. The bristle's stiffness k does not depend on F, so that a stuck bit holds its torque when the
/// weight changes, as long as the limit allows.
/// @param limit      T_max at this stage's force and bit speed
/// @param stiffness  k > 0 [N m/rad]; bit_bristle_stiffness() is a good one
/// @param twist      z_n at the start of the step [rad]
/// @param slip       bit's turn in the step: sigma + h (motor speed) [rad]
/// @param speed      N at this stage; its sign gives the tangent's [rad/s]
/// @param speed_coefficient  c = dN/d sigma [1/s]
BitTorque bit_torque(const TorqueLimit& limit, double stiffness, double twist, double slip, double speed,
                     double speed_coefficient) noexcept;

/// A bristle stiffness k by which a bit under an ordinary weight, 300 kN per metre of its diameter, breaks free after 0.01 rad:
/// k = mu_s (300 kN/m) D^2 / (3 * 0.01) [N m/rad].
double bit_bristle_stiffness(const BitTorqueSpec& spec, double diameter) noexcept;

}  // namespace drill_rig_sim

#endif
