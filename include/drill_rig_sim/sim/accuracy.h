#ifndef DRILL_RIG_SIM_SIM_ACCURACY_H
#define DRILL_RIG_SIM_SIM_ACCURACY_H

#include <cstdint>
#include <string>

#include "drill_rig_sim/accuracy/outputs.h"
#include "drill_rig_sim/rig/setpoints.h"
#include "drill_rig_sim/sim/wave_watch.h"

namespace drill_rig_sim
{
/// Why a run's numbers may be wrong, though every step was solved.
enum class AccuracyDoubt
{
  none,
  measured,       ///< an output is further from that of a finer model than the tolerance allows
  confined,       ///< guided pipe is compressed so far that it would leave the middle of its hole
  compression,    ///< an element carries more than it can bend under
  twist,          ///< an element is twisted by more than its beam is made for
  embedding,      ///< the string lies deeper in the wall than the hole is wide beside it
  refused_steps,  ///< many steps had to be taken in parts
  dissipation,    ///< the method itself takes much of the energy that goes through rig and string
  cut,            ///< the step is too long for the waves that one blade leaves to the next
  shaking,        ///< a bent motor turns, and the step is too long for the waves that it sends up
  waves,          ///< torque swings faster than the step can follow
  load_waves,     ///< and hook load
  blows,          ///< the bit strikes the bottom again and again
  loose,          ///< a string that was wound up by many turns came loose
  hesitation,     ///< the string's lower end came loose and stuck again before it had run
  whirl,          ///< turning pipe rolls along its walls
  jerks,          ///< the string sticks and slips on its walls again and again
  slant,          ///< the hole leaves the table inclined, and the rig stands upright
  level,          ///< the level does not represent an output that the scene needs
  turn            ///< the bit drills aside, and the body that follows it does not let the hole turn so fast
};

/// A doubt, how large and where.
struct AccuracyReport
{
  AccuracyDoubt doubt = AccuracyDoubt::none;
  double measure = 0.0;         ///< confined: of the load at which it buckles; compression: over what the element can carry; twist [rad]; embedding [m]; shares of steps or energy; cut: blades passed a step; shaking: damping by the method, blows, jerks [1/s]; loose [turns]; whirl: of pure rolling, waves: of the signal's range [-]; hesitation: speed that was reached [rad/s]; slant [rad]; level: sum of the needs; turn: of the hole by the rock law [rad/m]
  double from_bit = 0.0;        ///< where on the string [m]; confined, compression, twist, embedding
  double element_length = 0.0;  ///< of the element there [m]; compression, twist
  double allowed = 0.0;         ///< turn: what the body lets [rad/m]
  Output output = Output::hook_load;  ///< measured: the one whose error `measure` is [-]

  template <class V>
  void visit(V& v)
  {
    v("doubt", doubt);
    v("measure", measure);
    v("output", output);
    v("from_bit", from_bit);
    v("element_length", element_length);
    v("allowed", allowed);
  }
};

/// The report in a line that names the remedy; empty without a doubt. `step`: numerics.step [s]. Allocates.
std::string text_of(const AccuracyReport& report, double step);

/// What the watch remembers from frame to frame.
struct AccuracyMemory
{
  std::uint64_t frames = 0;   ///< since the start
  Setpoints setpoints;        ///< of the last frame
  std::uint64_t commanded = 0;  ///< frames that took up new set points since the last sample of energy
  bool due = false;           ///< such a sample is
  std::uint64_t spared = 0;   ///< frames that begin with a step and are passed over before the next one
  double dissipated = 0.0;    ///< numerical, mean over the last seconds by magnitudes [W]
  double throughput = 0.0;    ///< of the inputs, or of the losses where they are more, in the same way [W]
  double refused = 0.0;       ///< attempts a step that were repeated in parts, in the same way
  double sticking = 1.0;      ///< share of the walls' force that sticks, when it was last looked at [-]
  double jerks = 0.0;         ///< how often it comes loose and takes hold, in the same way [1/s]
  double turning = 0.0;       ///< speed of the string's lower end, mean over the last seconds [rad/s]
  double sideways = 0.0;      ///< of the string's speed sideways, in the same way [m/s]
  double surface = 0.0;       ///< and of its surface's about its axis [m/s]
  double whirled = 0.0;       ///< how long it has rolled along its walls [s]
  double held = 0.0;          ///< how long the lower end has not turned [s]
  double hesitated = 0.0;     ///< since the last look, the largest speed at which it stuck again without having run [rad/s]
  double ran = 0.0;           ///< largest speed of the lower end since it last stood [rad/s]
  WaveWatch torque;           ///< of the torque meter [N m]
  WaveWatch hook_load;        ///< [N]
  bool on_bottom = true;      ///< at the end of the last frame; with 1 kN or more since it came down
  double blows = 0.0;         ///< how often the bit comes down on the bottom, mean over the last seconds [1/s]
  double stands_for = 0.0;    ///< the report stands that much longer without a new cause [s]
  AccuracyReport report;

  template <class V>
  void visit(V& v)
  {
    v("frames", frames);
    v("setpoints", setpoints);
    v("commanded", commanded);
    v("due", due);
    v("spared", spared);
    v("dissipated", dissipated);
    v("throughput", throughput);
    v("refused", refused);
    v("sticking", sticking);
    v("jerks", jerks);
    v("turning", turning);
    v("sideways", sideways);
    v("surface", surface);
    v("whirled", whirled);
    v("held", held);
    v("hesitated", hesitated);
    v("ran", ran);
    v("torque", torque);
    v("hook_load", hook_load);
    v("on_bottom", on_bottom);
    v("blows", blows);
    v("stands_for", stands_for);
    v("report", report);
  }
};

}  // namespace drill_rig_sim

#endif
