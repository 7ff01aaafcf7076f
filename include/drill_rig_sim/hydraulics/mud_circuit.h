// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_HYDRAULICS_MUD_CIRCUIT_H
#define DRILL_RIG_SIM_HYDRAULICS_MUD_CIRCUIT_H

#include <string>
#include <vector>

#include "drill_rig_sim/hydraulics/hydraulics.h"
#include "drill_rig_sim/hydraulics/mud_pump.h"
#include "drill_rig_sim/hydraulics/pressure_waves.h"
#include "drill_rig_sim/hydraulics/rheology.h"
#include "drill_rig_sim/hydraulics/warm_mud.h"
#include "drill_rig_sim/string/mesh.h"
#include "drill_rig_sim/well/well_spec.h"

/// The hydraulic circuit of a string in its hole, and where along it the pressures drop.
///
/// Volumes are those of bore and annulus at the start, as are diameters: thirty metres drilled change them by little. The scene's
/// pressure_coefficient says what is lost in all at max_flow. Of that,
/// - the annulus takes 1.4327e-7 W L V^2/(D_h - D) (psi, lb/gal, ft, ft/min, in), dp/ds = 2 f rho v^2/(D_h - D) with f = 0.0133
/// in any
///   units (a rough wall's), element by element;
/// - the bore 6.1e-5 W L Q^1.86/d^4.86 (psi, lb/gal, ft, gal/min, in), both Lapeyrouse, Formulas and Calculations for Drilling,
/// Production
///   and Workover;
/// - the bit, its nozzles and tools above it the rest. Where there is no such rest both are scaled to what there is, the bore
/// first.
///
/// With a rheology of the mud (`mud.rheology`) the losses are those of its law by section, surface lines and nozzles included,
/// and no rule of thumb nor pressure_coefficient is in them (section_losses.h, flow_losses.h). Where along string and annulus
/// they lie is worked out at max_flow, as above: at another flow, or of a string that moves, their sum is right and their places
/// are off by a few per cent of it.
///
/// What the pressures do to the string, above the hydrostatic ones, whose part is buoyancy. T_e = T - p_i A_i + p_o A_o, +
/// tension, is the effective tension, the one in the elements: T that of the steel, A_i and A_o the areas of bore and outside.
/// - Pump-open force: T = T_e + p_i A_i - p_o A_o. What the pump adds in the bore pulls the steel, bit against swivel, and is
/// inner to the
///   string with the mud in it: friction of the mud down the bore and pressure drop of the bit too. The swivel, whose gooseneck
///   the same pressure lifts by p A_i, hangs with the string: the hook carries T_e of the top, and feels no bore pressure as
///   such.
/// - Stretch: e = (T_e + (1 - 2 nu)(p_i A_i - p_o A_o))/(E A_s), from Lame's stresses, whose sum is 2 (p_i A_i - p_o A_o)/A_s:
/// the string grows
///   under the pump; with the block held and the bit on bottom it pushes, weight comes on the bit and off the hook.
/// - Lift: mud that flows up the annulus pushes the string up, towards the surface, by dp/ds (A_o + D/(D + D_h) (A_h - A_o)) =
///   dp/ds pi/4 D D_h per length: its pressure gradient as buoyancy, and the pipe's share of the walls' friction, by
///   circumference.
///
/// Surge and swab. A string closed by its float displaces A_o v as it runs in at v, and mud clings to it: along a section the
/// losses are those of a flow Q + v (A_o + K (A_h - A_o)), of a speed K v + (Q + A_o v)/(A_h - A_o), K = 0.41 + 0.1 D/D_h
/// (Burkhardt, J. Pet. Tech. 13 (1961) 595-605, his chart for turbulent flow as fitted by Guo and Liu, Applied Drilling
/// Circulation Systems, 2011, eq. 2.82; Lapeyrouse has 0.45). One area stands for the string's sections, their mean to the power
/// m by the share of the loss: exact where either the pump or the string stands. One v too: the mean of the elements' speed along
/// themselves, weighted with the lift. What that pressure does to the string is what the pump's does. Without a rheology the
/// losses are a turbulent flow's: mud of high yield point, moved slowly, loses more. The plugged pipe of Lapeyrouse's example, 4
/// 1/2 in in 7 7/8 in, 14,300 ft, 15 lb/gal, at 270 ft/min: 4.1 MPa; by his power law 3.6 (4.9 at 1.5 times the speed, for the
/// peak); at 0.3 m/s 0.2 MPa against 1.0. With a rheology it is the law's, section by section (section_losses.h). Not in it: the
/// jets' reaction, about rho Q v, a few kN at most.
///
/// With pressure waves (`mud.pressure_waves`, pressure_waves.h) the pressures in bore and annulus are those of the waves at each
/// element. The lift goes with the annulus's pressure at the bit: right in steady flow, late or early by the wave's way else.
namespace drill_rig_sim
{
constexpr double annulus_friction = 0.0133;  ///< Fanning's f

/// What is lost at the pump's largest flow [Pa].
struct LossesAtLargestFlow
{
  double lines = 0.0;  ///< surface lines
  double bore = 0.0;
  double bit = 0.0;  ///< without a rheology nozzles and tools above them: what pressure_coefficient leaves
  double annulus = 0.0;
};

struct MudCircuit
{
  HydraulicCircuit circuit;
  // per element, bit first: shares of its middle
  std::vector<double> bore_above;          ///< of the bore's friction, lost above it
  std::vector<double> bore_here;           ///< of it, lost along it
  std::vector<double> annulus_above;       ///< of the annulus's loss, still to come above it
  std::vector<double> annulus_here;        ///< of the annulus's loss, along it
  std::vector<double> stretch_by_bore;     ///< (1 - 2 nu) A_i/(E A_s): of the pipe by a pressure in its bore [1/Pa]
  std::vector<double> stretch_by_annulus;  ///< -(1 - 2 nu) A_o/(E A_s): by one around it [1/Pa]
  std::vector<double> lift;                ///< pi/4 D D_h annulus_here: by the annulus's pressure at the bit [m2]
  std::vector<double> speed_weight;        ///< of the element in the string's mean speed: lift/(2 L), over all lift [1/m]
  double displaced_area =
      0.0;  ///< A_o + K (A_h - A_o): flow that counts for the annulus's losses per speed of the string; with a rheology A_o [m2]
  double tubular_loss =
      0.0;  ///< of bore and annulus at the largest flow by the rules above, whatever pressure_coefficient says [Pa]
  double bore_friction = 0.0;    ///< share of circuit.bore.loss that is the bore's; the rest is the bit's and the surface lines'
  LossesAtLargestFlow losses;    ///< without rotation
  double rotation_factor = 1.0;  ///< on the annulus's losses at 120 rpm (flow_losses.h)
  PressureWaves waves;           ///< none without mud.pressure_waves
  // number of each element's section among the losses by temperature, no_section: none; empty without mud.temperature
  std::vector<std::size_t> bore_section, annulus_section;

  static constexpr std::size_t no_section = static_cast<std::size_t>(-1);
};

/// Annular pressure gradient [Pa/m] of a flow [m3/s] of mud of a density [kg/m3] between a hole and a string of diameters [m]; 0
/// where the string fills the hole.
double annulus_gradient(double density, double flow, double hole_diameter, double diameter) noexcept;
/// The gradient in a bore [Pa/m].
double bore_gradient(double density, double flow, double diameter) noexcept;

/// What a circuit leads through.
struct MudWay
{
  const MudPumpSpec& pump;
  const MudSpec& mud;
  const std::vector<HoleSection>& hole;
  const std::vector<PartSpec>& string;
  double bit_depth;                                 ///< [m]
  const RheologySpec* rheology = nullptr;           ///< none: by pressure_coefficient
  const PressureWavesSpec* waves = nullptr;         ///< with a rheology only
  const MudTemperatureSpec* temperature = nullptr;  ///< the same
};

MudCircuit mud_circuit(const MudWay& way, const Mesh& mesh);

/// One line that says why the pressures are not reliable: pressure_coefficient gives less than bore and annulus lose by the rules
/// above. Empty if it leaves a loss for the bit.
std::string doubt_of_pressures(const MudCircuit& mud);

/// Pressures above the hydrostatic ones.
struct MudPressures
{
  double stand_pipe = 0.0;  ///< [Pa]
  double lines = 0.0;       ///< lost in the surface lines [Pa]
  double friction = 0.0;    ///< lost in the bore [Pa]
  double annulus = 0.0;     ///< at the bit [Pa]
  double load = 0.0;        ///< of it, what cuttings weigh; with waves only [Pa]
  const PressureWaveState* waves = nullptr;

  /// At an element's middle [Pa].
  double in_bore(const MudCircuit& mud, std::size_t e) const noexcept
  {
    return waves ? waves->in_bore(mud.waves.bore_cell[e]) : stand_pipe - lines - mud.bore_above[e] * friction;
  }
  double in_annulus(const MudCircuit& mud, std::size_t e) const noexcept
  {
    if (!waves) return mud.annulus_above[e] * annulus;
    const std::size_t cell = mud.waves.annulus_cell[e];
    return cell == PressureWaves::no_cell ? 0.0 : waves->in_annulus(cell) + mud.annulus_above[e] * load;
  }
  bool any() const noexcept { return waves || stand_pipe != 0.0 || annulus != 0.0; }
};

/// The annulus's pressure along the hole, above the hydrostatic one, as a share of that at the bit: at a distance above the bit's
/// face [m].
double annulus_share(const MudCircuit& mud, const Mesh& mesh, double from_bit) noexcept;

/// @param flow  through the bore [m3/s]
/// @param warm  of the mud by temperature; null: none
/// @param head  of the annulus by it (WarmHeads), which is hydrostatic [Pa]
MudPressures mud_pressures(const MudCircuit& mud, const HydraulicState& state, double flow, const LossPlaces* warm = nullptr,
                           double head = 0.0) noexcept;
/// The same of a circuit with waves; the result refers to them.
/// @param load  weight of cuttings at the bit [Pa]
MudPressures wave_pressures(const HydraulicState& state, const PressureWaveState& waves, double load, double head = 0.0) noexcept;

}  // namespace drill_rig_sim

#endif
