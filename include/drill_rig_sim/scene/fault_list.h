// SPDX-License-Identifier: BSD-3-Clause
// THE list of faults: one row a fault. It has no include guard: it is included once for each thing that is made from it.
//
//   FAULT(name, label, place, by_ida, target, magnitude)
//
// name       enumerator of FaultKind, word of the scene file; in capitals the constant of InjectFault.srv, numbered in this order
// label      in rviz's panel
// place      of FaultPlace: what `depth` means
// by_ida     whether the integrator `ida` has it
// target     gauge or nothing (of FaultTarget)
// magnitude  of FaultMagnitude (scene/fault_spec.h)
//
// Made from it: FaultKind and fault_traits (scene/fault_spec.h), the words of a program, rviz's controls, the faults of Python
// (src/python/tables.py). A new fault goes to the end, with what begins and ends it (sim/faults.cpp) and its constant in
// srv/InjectFault.srv.
#ifndef FAULT
#define FAULT(...)
#endif

FAULT(stuck_pipe, "stuck pipe", in_pipe, true, nothing, no_magnitude)
FAULT(sensor_freeze, "sensor freeze", nowhere, true, gauge, no_magnitude)
FAULT(sensor_bias, "sensor bias", nowhere, true, gauge, of_signal("error"))
FAULT(sensor_noise, "sensor noise", nowhere, true, gauge,
      above_0("deviation", Dimension::count, 1e9, 0.0, "magnitude: allowed is above 0, up to 1e9 units of the signal"))
FAULT(brake_slip, "brake slip", nowhere, false, nothing,
      above_0("holds", Dimension::force, 5e7, 1e5, "magnitude: allowed is above 0, up to 5e7 N"))
FAULT(drive_trip, "drive trip", nowhere, true, nothing, no_magnitude)
FAULT(motor_stall, "motor stall", nowhere, false, nothing, no_magnitude)
FAULT(washed_out_hole, "washed-out hole", in_hole, false, nothing,
      above_0("wider by", Dimension::diameter, 1.0, 0.05, "magnitude: allowed is above 0, up to 1 m"))
FAULT(pump_trip, "pump trip", nowhere, true, nothing, no_magnitude)
FAULT(sensor_dropout, "sensor drop-out", nowhere, true, gauge, no_magnitude)
FAULT(sensor_drift, "sensor drift", nowhere, true, gauge, of_signal("per second", true))
FAULT(differential_sticking, "differential sticking", in_pipe, false, nothing,
      above_0("overpressure x length", Dimension::force_per_length, 1e9, 1e6, "magnitude: allowed is above 0, up to 1e9 N/m"))
FAULT(pack_off, "pack-off", in_pipe, false, nothing,
      above_0("drag", Dimension::force, 1e7, 5e4, "magnitude: allowed is above 0, up to 1e7 N"))
FAULT(friction_change, "friction change", from_there_down, false, nothing,
      factor(0.0, 10.0, 1.5, "magnitude: allowed is 0 to 10 times"))
FAULT(formation_change, "formation change", nowhere, false, nothing,
      factor(1e-3, 1e3, 0.5, "magnitude: allowed is 0.001 to 1000 times"))
FAULT(washed_out_pipe, "washed-out pipe", in_pipe, false, nothing,
      above_0("hole", Dimension::area, 0.01, 1e-4, "magnitude: allowed is above 0, up to 0.01 m2"))

#undef FAULT
