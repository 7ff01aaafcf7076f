// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_CREW_RIG_CONTROLS_H
#define DRILL_RIG_SIM_CREW_RIG_CONTROLS_H

#include "drill_rig_sim/crew/commands.h"
#include "drill_rig_sim/instruments/signals.h"
#include "drill_rig_sim/scene/fault_spec.h"
#include "drill_rig_sim/scene/scene.h"

namespace drill_rig_sim
{
/// What a driller sees on a rig and does to it, so that programs and operations need not know the simulator behind it.
class RigControls
{
public:
  virtual CommandResult command(const WinchSetpoint& c) noexcept = 0;
  virtual CommandResult command(const TopDriveSetpoint& c) noexcept = 0;
  virtual CommandResult command(const PumpSetpoint& c) noexcept = 0;
  /// Obeyed at once; by the pump's flow as downlink.h says.
  virtual CommandResult command(const SteeringSetpoint& c) noexcept = 0;
  /// The last commands themselves, even while a crew or the watchdog gives the set points.
  virtual const Setpoints& asked() const noexcept = 0;
  /// The rig as it is after the last frame: for judging a controller.
  virtual const Truth& truth() const noexcept = 0;
  /// What its instruments show then: for feeding one.
  virtual const Readings& readings() const noexcept = 0;
  /// The scene that runs, with what level auto has chosen (choice.h) in its keys.
  virtual const Scene& scene() const noexcept = 0;
  /// The next frame fails for this reason (one line, static storage) unless another has failed before.
  virtual void fail(const char* reason) noexcept = 0;
  /// Zero of surface WOB and differential pressure, where they are and where the gauges show them. False (unchanged) on bottom
  /// and in the slips.
  virtual bool tare() noexcept = 0;
  /// Grips the pipe within an element of measured depth `md` [m]; false, and nothing changed, unless 0 < md <= the bit's depth.
  virtual bool stick_pipe(double md) noexcept = 0;
  virtual void free_pipe() noexcept = 0;
  /// A fault (sim/faults.h) begins. Null; or why not, one line, static storage, and nothing changed.
  virtual const char* inject(const Fault& fault) noexcept = 0;
  /// The one of this kind (and gauge) ends.
  virtual void clear(FaultKind kind, Gauge gauge) noexcept = 0;
  /// A coarser level from the next frame on: nodes up to `from_bit` above the bit's face [m] stay free, those above it are guided
  /// (0: axial_torsional; else hybrid). What the string carries goes on as it was (model/levels.h). False, and nothing changed,
  /// where it would set guided pipe free, for that shakes turning pipe for seconds (torque off by up to 40 %), for level rigid,
  /// for methods that have only free nodes, and where `from_bit` is no length.
  virtual bool set_free_length(double from_bit) noexcept = 0;
  /// Sets the slips: they grip the joint's end nearest to the rotary table (model/forces/slips.h). Or pulls them. Null where it
  /// is done, else why not, one line, static storage; nothing has changed then.
  virtual const char* set_slips(bool set) noexcept = 0;
  /// Begins to add `joints` of the last part's pipe (0: a stand) to the string in the slips, or to `remove` them (connection.h).
  /// It is over after connection_time, or what the block's way takes if that is longer. Null, or why not.
  virtual const char* make_connection(int joints, bool remove) noexcept = 0;
  /// The rig's crew makes connections wherever the block's way ends, as with `connections: auto` (crew.h); or no more, but for
  /// what it is about.
  virtual void call_crew(bool on) noexcept = 0;

protected:
  ~RigControls() = default;
};

}  // namespace drill_rig_sim

#endif
