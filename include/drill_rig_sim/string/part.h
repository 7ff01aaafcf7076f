// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_STRING_PART_H
#define DRILL_RIG_SIM_STRING_PART_H

#include <optional>
#include <string>
#include <vector>

#include "drill_rig_sim/contact/bit_torque.h"
#include "drill_rig_sim/contact/normal_law.h"
#include "drill_rig_sim/math/units.h"

namespace drill_rig_sim
{
enum class PartType
{
  bit,
  mud_motor,
  collar,
  stabilizer,
  mwd,
  pipe,
  rotary_steerable
};

/// What a bit has beside what every part has.
struct BitSpec
{
  double mass = 0.0;      ///< [kg]
  double diameter = 0.0;  ///< gauge [m]
  /// i_b in [0, 1]: sideways per revolution and side force over ahead per revolution and weight. PDC bits have 0.001 (long
  /// passive gauge) to 0.1 (short, cutting); the default is a middle. Source: Menand, Sellami, Simon, PDC bit classification
  /// according to steerability, SPE Drilling & Completion 19 (2004), SPE 87837, eq. (1): ratio of lateral to axial drillability.
  double side_cutting = 0.02;
  /// Lateral, by the mud squeezed between gauge and wall: of 12 pi mu L (R/c)^3, 2e7 for a gauge of 0.1 m with 0.2 mm of
  /// clearance, what the blades leave. Less than some 3e5 would let the gauge whirl that rubs on a stiff wall [N s/m]
  double squeeze_film_damping = 5e5;
  /// Of the gauge pads, up from the middle of the bit's ball [m]; 0: only the ball touches the wall, and no tilt of the bit
  /// presses on it
  double gauge_length = 0.0;
  double gauge_clearance = 2e-4;  ///< of the pads' upper end, all round, in hole that the bit has cut [m]
  double speed_lag = 0.4;         ///< of the speed that drills behind the bit's [s]
  std::vector<double> nozzles;    ///< their diameters, of a mud with a rheology [m]
  double nozzle_area = 0.0;       ///< all of it, instead of them [m2]
  BitTorqueSpec torque;
  ContactLaw bottom{1e9, 1.5, 1.0};  ///< bit against the hole's bottom

  /// What the mud flows through [m2]; 0: not given.
  double flow_area() const noexcept
  {
    double area = nozzle_area;
    for (const double diameter : nozzles) area += 0.25 * pi * diameter * diameter;
    return area;
  }
};

/// What a mud motor has beside what every part has.
struct MotorSpec
{
  double bend = 0.0;                  ///< angle of the bent housing [rad]
  double bit_to_bend = 0.0;           ///< from the bit's face to the bend [m]
  double sleeve_diameter = 0.0;       ///< over the blades on its bearing housing, does not turn with the bit; 0: none [m]
  double bit_to_sleeve = 0.0;         ///< from the bit's face to the middle of these blades [m]
  double displacement_per_rev = 0.0;  ///< [m3/rev]
  double stall_torque = 0.0;          ///< [N m]
  double curve_exponent = 4.0;        ///< of speed over torque: 1 a straight line, more: the speed holds until near stall [-]
  double efficiency =
      1.0;  ///< mechanical: of the torque that the pressure would give without friction in rotor and bearings, this comes out [-]

  /// The displacement of the frictionless motor that has this one's torque at its pressure [m3/rev].
  double pressure_displacement() const noexcept { return efficiency * displacement_per_rev; }
};

/// What a stabilizer has beside what every part has.
struct StabilizerSpec
{
  double blade_diameter = 0.0;        ///< [m]
  double squeeze_film_damping = 5e4;  ///< lateral, by the mud squeezed between blades and wall [N s/m]
};

/// What an mwd has beside what every part has.
struct MwdToolSpec
{
  double sensor_offset = 0.0;  ///< from the part's lower end up to the sensor [m]
};

/// What a rotary steerable tool has beside what every part has. It pushes the bit: pads press on the wall, one after the other as
/// the tool turns, so that the force on the tool stays in one direction (model/forces/pads.h). Or it points it: below its pivot
/// the tool is a shaft that leans against its collar in a direction that stays (model/pointing.h).
struct SteerableSpec
{
  double bit_to_pads = 0.0;         ///< from the bit's face [m]
  double pad_force = 0.0;           ///< at full steering; 0: it points [N]
  double bit_to_pivot = 0.0;        ///< from the bit's face [m]
  double tilt = 0.0;                ///< of the shaft at full steering; 0: it pushes [rad]
  double downlink_bit_time = 12.0;  ///< of a downlink by the pump's flow (instruments/downlink.h) [s]

  /// Where it steers, from the bit's face [m].
  double place() const noexcept { return tilt > 0.0 ? bit_to_pivot : bit_to_pads; }
};

/// What drill pipe has beside what every part has.
struct PipeSpec
{
  double tool_joint_diameter = 0.0;  ///< at its joints' ends; 0 = outer diameter [m]
};

/// A section's stiffness where it is given outright; zeros: that of the tube that the diameters say.
struct StiffnessSpec
{
  double axial = 0.0;      ///< E A [N]
  double bending = 0.0;    ///< E I [N m2]
  double torsional = 0.0;  ///< G J [N m2]
};

/// One entry of the `string` list; entries go from the bit up. Optional members are set only for the type that has them.
struct PartSpec
{
  std::string name;
  PartType type = PartType::collar;
  double length = 0.0;          ///< of the whole part if it has no joints [m]
  int joints = 1;               ///< number of joints; 0 means `fill`: as many as reach the surface
  double joint_length = 0.0;    ///< [m]; equal to length where the part has no joints
  double outer_diameter = 0.0;  ///< [m]
  double inner_diameter = 0.0;  ///< [m]
  double linear_mass = 0.0;     ///< in air [kg/m]
  double young_modulus = 206e9;
  double poisson_ratio = 0.3;
  StiffnessSpec stiffness;         ///< instead of the tube's: all three or none
  double polar_inertia = 0.0;      ///< about the axis, in air [kg m2/m]; 0: that of the tube with this linear_mass
  double density = 7850.0;         ///< of its material: displaced volume = linear mass / density [kg/m3]
  double yield_strength = 724e6;   ///< of its material; drill pipe of grade G-105 [Pa]
  double make_up_torque = 0.0;     ///< of its connections; 0: not known [N m]
  double friction_radius = 0.0;    ///< lever of the wall's friction about the axis; 0: half the diameter where it touches [m]
  double oscillation_force = 0.0;  ///< amplitude with which it shakes the string along its axis (model/forces/oscillator.h) [N]
  double oscillation_frequency = 16.0;  ///< [Hz]
  std::optional<ContactLaw> contact;    ///< its own law of wall contact instead of the scene's

  std::optional<BitSpec> bit;
  std::optional<MotorSpec> motor;
  std::optional<StabilizerSpec> stabilizer;
  std::optional<MwdToolSpec> mwd;
  std::optional<PipeSpec> pipe;
  std::optional<SteerableSpec> steerable;
};

}  // namespace drill_rig_sim

#endif
