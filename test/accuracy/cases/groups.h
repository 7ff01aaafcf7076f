// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_ACCURACY_GROUPS_H
#define DRILL_RIG_SIM_ACCURACY_GROUPS_H

/// One function a group of cases, each in a file of its own; listed in groups.cpp.
namespace drill_rig_sim
{
class Report;

/// Every survey of ../shared/data against its listed positions.
void survey_cases(Report& report);
/// Constant curvature, capstan, and a published well.
void torque_and_drag_cases(Report& report);
/// Natural frequencies, torsional and axial, of hanging strings.
void vibration_cases(Report& report);
/// Steady drilling with a drag bit.
void detournay_cases(Report& report);
void sliding_cases(Report& report);
/// A collar that rolls on the wall.
void whirl_cases(Report& report);
/// One degree of freedom against its closed form.
void stick_slip_cases(Report& report);
/// Stick-slip of a published well with the bit off bottom.
void stick_slip_well_a_cases(Report& report);

/// Pipe pushed into a horizontal hole: sinusoidal and helical buckling, the helix's contact force and pitch.
void buckling_cases(Report& report);
/// Beams of every kind of element: a bend in space, roll-up, columns, the vertical pipe.
void beam_cases(Report& report);
/// Energy balance of scenes: of small ones, and of all others.
void small_energy_cases(Report& report);
void energy_cases(Report& report);

/// Build rate of a bent motor while it slides.
void bent_motor_cases(Report& report);

/// The reference integrator against motions known exactly, and the default stepper against it.
void reference_cases(Report& report);

}  // namespace drill_rig_sim

#endif
