// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_ACCURACY_WELL_A_H
#define DRILL_RIG_SIM_ACCURACY_WELL_A_H

#include <cmath>

#include "test_scenes.h"

/// Well A of U. J. F. Aarsnes and R. J. Shor, Torsional vibrations with bit off bottom: modeling, characterization and field data
/// validation, J. Pet. Sci. Eng. 163 (2018), 712-721 (their synthetic case): vertical to 1500 m, inclination linear to 60 deg at
/// 2100 m, held to 2500 m; 2270 m of pipe over 230 m of collars, which they average over the parts of a bottom-hole assembly.
namespace drill_rig_sim
{
struct WellA
{
  static constexpr double depth = 2500.0, kick_off = 1500.0, build_end = 2100.0, inclination = 60.0 * degree;
  static constexpr double density = 7850.0;
  static constexpr double pipe_outer = 0.146529, pipe_inner = 0.123024, pipe_shear = 61e9;
  static constexpr double collar_length = 230.0, collar_shear = 67e9;
  static constexpr double collar_moment = 8.4937e-5;  ///< polar, averaged [m4]
  static constexpr double collar_area = 0.0155634;    ///< averaged [m2]
  static constexpr double collar_radius = 0.0835906;  ///< averaged, where friction acts [m]
  static double pipe_moment() { return pi / 32.0 * (std::pow(pipe_outer, 4) - std::pow(pipe_inner, 4)); }
};

inline PartSpec well_a_pipe()
{
  PartSpec pipe = pipe_part(0, 1e5, 0.0, 0.0);
  pipe.outer_diameter = WellA::pipe_outer;
  pipe.inner_diameter = WellA::pipe_inner;
  pipe.linear_mass = WellA::density * pi / 4.0 * (std::pow(WellA::pipe_outer, 2) - std::pow(WellA::pipe_inner, 2));
  pipe.young_modulus = 2.6 * WellA::pipe_shear;
  return pipe;
}

/// The averaged collars are no tube: no diameters give area, moment and radius together. Here the outer diameter is that of the
/// friction, the mass that of the area, the bore such that rotary inertia per metre, and the modulus such that torsional
/// stiffness, is the average's. `inertia_factor`: rotary inertia against that of steel.
inline PartSpec well_a_collars(double inertia_factor = 1.0)
{
  PartSpec collars = collar_part(1, WellA::collar_length);
  collars.outer_diameter = 2.0 * WellA::collar_radius;
  collars.linear_mass = WellA::density * WellA::collar_area;
  const double inertia = inertia_factor * WellA::density * WellA::collar_moment;  // = linear mass (ro^2 + ri^2) / 2
  collars.inner_diameter = 2.0 * std::sqrt(2.0 * inertia / collars.linear_mass - WellA::collar_radius * WellA::collar_radius);
  const double moment = pi / 32.0 * (std::pow(collars.outer_diameter, 4) - std::pow(collars.inner_diameter, 4));
  collars.young_modulus = 2.6 * WellA::collar_shear * WellA::collar_moment / moment;
  return collars;
}

}  // namespace drill_rig_sim

#endif
