// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_TEST_SCENE_OF_ALL_KEYS_H
#define DRILL_RIG_SIM_TEST_SCENE_OF_ALL_KEYS_H

namespace drill_rig_sim
{
/// A scene in which every key that excludes no other has a value of its own.
constexpr const char* scene_of_all_keys = R"(
name: all_keys
well:
  stations: [[0.0, 1.0, 2.0], [400.0, 3.0, 4.0], [900.0, 5.0, 6.0]]
  hole_depth: 801.0
  project: curvature
  pilot_depth: 851.0
  pilot_diameter: 0.21
  sections:
    - {to: 301.0, diameter: 0.35, friction: 0.21, static_ratio: 1.25, stribeck_speed: 0.061}
    - {to: 801.0, diameter: 0.3112, friction: 0.31}
formation:
  - {to_tvd: 501.0, drillability: 1.1e-8, weight_exponent: 1.2, speed_exponent: 0.7, threshold: 1301.0, dip_deg: 14.0,
      strike_deg: 15.0, anisotropy: 0.16, friction: 0.23}
  - {to_tvd: 5001.0, drillability: 1.7e-8}
mud: {density: 1181.0, viscosity: 0.031, axial_damping: 0.19, lateral_damping: 21.0, drag_coefficient: 1.4,
    torsional_damping: 2.2e-4, added_mass: 1.23, bulk_modulus: 1.51e9, gel_strength: 4.7, fill: [[101.5, 11.5], [701.5, 203.5]]}
string:
  - {name: b1, type: bit, length: 0.36, mass: 91.0, diameter: 0.3112, side_cutting: 0.12, speed_lag: 0.31, gauge_length: 0.15,
      gauge_clearance: 4.3e-4, squeeze_film_damping: 41000.0,
      torque: {model: stribeck, static: 0.61, kinetic: 0.41, speed_rpm: 31.0},
      bottom: {stiffness: 1.1e9, exponent: 1.51, damping: 1.01}}
  - {name: m1, type: mud_motor, length: 8.4, outer_diameter: 0.204, inner_diameter: 0.121, linear_mass: 191.0, bend_deg: 1.3,
      bit_to_bend: 2.1, sleeve_diameter: 0.3079, bit_to_sleeve: 1.05, displacement_per_rev: 0.025, stall_torque: 12100.0,
      curve_exponent: 3.9, efficiency: 0.85}
  - {name: c1, type: collar, joints: 2, joint_length: 9.1, outer_diameter: 0.203, inner_diameter: 0.072, linear_mass: 221.0,
      young_modulus: 2.01e11, poisson_ratio: 0.28, yield_strength: 9.31e8, make_up_torque: 4.1e4, density: 7801.0,
      friction_radius: 0.081, oscillation_force: 14001.0, oscillation_frequency: 0.17,
     contact: {stiffness: 5.1e7, exponent: 1.52, damping: 0.32}}
  - {name: s1, type: stabilizer, length: 1.9, outer_diameter: 0.2031, inner_diameter: 0.073, linear_mass: 231.0,
      blade_diameter: 0.3081, squeeze_film_damping: 42000.0}
  - {name: g1, type: mwd, length: 9.2, outer_diameter: 0.2033, inner_diameter: 0.074, linear_mass: 216.0, sensor_offset: 4.6,
      axial_stiffness: 5.61e9, bending_stiffness: 1.65e7, torsional_stiffness: 1.27e7, polar_inertia: 1.26}
  - {name: r1, type: rotary_steerable, length: 14.1, outer_diameter: 0.2032, inner_diameter: 0.0741, linear_mass: 217.0,
      bit_to_pads: 48.5, pad_force: 15001.0, downlink_bit_time: 13.1}
  - {name: p1, type: pipe, joints: fill, joint_length: 9.6, outer_diameter: 0.128, inner_diameter: 0.1087, linear_mass: 32.0,
      tool_joint_diameter: 0.169}
rig:
  hoisting: {sheaves: 6, line_ea: 4.1e7, crown_height: 47.0, fixed_length: 61.0, block_mass: 17600.0, sheave_efficiency: 0.97,
      latency: 0.31, rail_friction: 0.04, line_damping: 0.05, max_speed: 1.6, max_acceleration: 0.6, max_hook_load: 2.6e6,
      min_hook_load: 51001.0, trip_hook_load: 1.9e6, lowest_block_height: 1.1, highest_block_height: 41.0,
      connection_time: 171.0, stand_joints: 2}
  top_drive: {inertia: 2600.0, proportional_gain: 20001.0, integral_gain: 5001.0, max_torque: 50001.0, max_speed_rpm: 221.0,
      max_power: 750001.0, meter_stiffness: 1.1e6, gearbox_friction: 1001.0, brake_torque: 50001.0, max_acceleration_rpm: 71.0,
    soft_torque: {damping: 801.0, stiffness: 3951.0, inertia_compensation: 0.11}, z_torque: {damping: 401.0, stiffness: 61.0,
        inertia_compensation: 0.91}}
  mud_pump: {max_flow: 0.061, flow_ramp: 0.011, stroke_volume: 0.0161, relief_pressure: 3.51e7, trip_pressure: 3.41e7,
      pressure_coefficient: 4.1e9, loss_exponent: 1.83}
  heave: {amplitude: 1.1, period: 11.0}
  plc_latency: 0.21
contact: {stiffness: 5.3e7, assembly_stiffness: 2.1e10, exponent: 1.53, damping: 0.33, stribeck_speed: 0.051, static_ratio: 1.21,
    stribeck_curve: exponential, growth_at_rest: 0.03, growth_time: 1.7, growth_limit: 0.43, tangential_stiffness: 5.4e6,
    tangential_damping: 0.26}
trajectory: {stage_two_length: 0.11}
start: {bit_depth: 801.0, block_height: 35.0, weight_on_bit: 1001.0, torque_on_bit: 101.0, toolface_deg: 11.0}
numerics: {level: beam3d, free_length: 57.5, integrator: trbdf2, element: corotational, kernel: scalar, step: 0.004,
    element_length: 9.7, pushed_element_length: 4.6, guided_element_length: 19.1, tolerance: 0.012, refinement: 1.7,
    companion: finer, judge: readings, reference_tolerance: 1.1e-6,
           reference_order: 3, reference_index: 3, newton_tolerance: 1.2e-6, structural_damping: 1.3e-4}
instruments:
  mwd: {period: 32.0, latency: 8.1, inclination_resolution_deg: 0.13, noise_deg: 0.06, scribe_offset_deg: 17.0, quiet_time: 7.1,
      inclination_period: 21.3}
  toolface: {period: 10.1, latency: 4.1, noise_deg: 0.51, resolution_deg: 2.8, max_speed_rpm: 12.1}
  dynamics: {period: 17.1, latency: 7.3, from_bit: 21.7}
  surface:
    hook_load: {place: block, noise: 1.1, bias: 1.2, delay: 1.3, filter_time: 1.4, resolution: 1.5, drift: 1.6, rate: 1.7,
        dropout_interval: 1.8, dropout_duration: 1.9, outlier_interval: 2.0, outlier_size: 2.1}
    torque: {noise: 2.1, bias: 2.2, delay: 2.3, filter_time: 2.4, resolution: 2.5, drift: 2.6, rate: 2.7, dropout_interval: 2.8,
        dropout_duration: 2.9, outlier_interval: 3.0, outlier_size: 3.1}
    stand_pipe_pressure: {pump_noise: 0.031, noise: 3.1, bias: 3.2, delay: 3.3, filter_time: 3.4, resolution: 3.5, drift: 3.6,
        rate: 3.7, dropout_interval: 3.8, dropout_duration: 3.9, outlier_interval: 4.0, outlier_size: 4.1}
    flow: {noise: 4.1, bias: 4.2, delay: 4.3, filter_time: 4.4, resolution: 4.5, drift: 4.6, rate: 4.7, dropout_interval: 4.8,
        dropout_duration: 4.9, outlier_interval: 5.0, outlier_size: 5.1}
    block_height: {noise: 5.1, bias: 5.2, delay: 5.3, filter_time: 5.4, resolution: 5.5, drift: 5.6, rate: 5.7,
        dropout_interval: 5.8, dropout_duration: 5.9, outlier_interval: 6.0, outlier_size: 6.1}
    encoder_bit_depth: {noise: 6.1, bias: 6.2, delay: 6.3, filter_time: 6.4, resolution: 6.5, drift: 6.6, rate: 6.7,
        dropout_interval: 6.8, dropout_duration: 6.9, outlier_interval: 7.0, outlier_size: 7.1}
needs: [torque, rop]
connections: off
program:
  - {at: 1.5, block_velocity: -0.01, top_drive_speed_rpm: 54.0, flow: 0.046}
  - {at: 2.5, top_drive_torque: 1234.0, top_drive_brake: true, brake: true}
  - {at: 3.5, brake: false, flow: 0.045, ramp: 6.5, stuck_at: 701.0}
  - {at: 4.5, free: true, free_length: 57.0, slips: true, connection: -2.0}
  - {at: 5.5, top_drive_mode: oscillate, top_drive_angle_deg: 1801.0, amplitude_right_deg: 721.0, amplitude_left_deg: 361.0,
      top_drive_torque_limit: 9001.0, steering_toolface_deg: 92.0, steering_ratio: 0.61}
  - {at: 6.5, fault: pack_off, fault_depth: 501.0, fault_magnitude: 20001.0}
  - {at: 7.5, clear_fault: sensor_freeze, fault_target: flow}
operations:
  - {do: flow, flow: 0.044, ramp: 7.5, time: 3.1}
  - {do: rotate, speed_rpm: 61.0, ramp: 8.5}
  - {do: pick_up, speed: 0.11, to_depth: 795.0, distance: 5.1, time: 90.0, overpull: 81000.0}
  - {do: slack_off, speed: 0.12, to_depth: 801.5, weight: 21000.0}
  - {do: tag, speed: 0.013, weight: 6100.0}
  - {do: drill, speed: 0.014, weight: 22000.0, to_depth: 803.0, distance: 2.1, time: 4000.0}
  - {do: slide, speed: 0.015, weight: 23000.0, toolface_deg: 91.0, distance: 2.2, speed_rpm: 11.0, amplitude_right_deg: 181.0,
      amplitude_left_deg: 182.0}
  - {do: oscillate, amplitude_right_deg: 183.0, amplitude_left_deg: 184.0, speed_rpm: 12.0}
  - {do: ream, speed: 0.16, distance: 3.1, times: 2}
  - {do: wait, time: 66.0}
  - {do: steer, toolface_deg: 93.0, ratio: 0.62}
  - {do: connection, remove: true}
)";
}  // namespace drill_rig_sim

#endif
