// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SCENE_NEEDS_H
#define DRILL_RIG_SIM_SCENE_NEEDS_H

namespace drill_rig_sim
{
/// Outputs that matter to who wrote the scene; a set is a sum of them. The words of the key `needs` stand in the same order.
enum Need : unsigned
{
  need_hook_load = 1u << 0,
  need_torque = 1u << 1,
  need_wob = 1u << 2,
  need_rop = 1u << 3,
  need_bit_speed = 1u << 4,
  need_pressure = 1u << 5,
  need_direction = 1u << 6,  ///< of the hole that is drilled: inclination, azimuth, what a bend or a stabiliser makes of them
  need_contact = 1u << 7,    ///< forces and bending along the string
  need_buckling = 1u << 8
};

constexpr unsigned every_need = (1u << 9) - 1u;

}  // namespace drill_rig_sim

#endif
