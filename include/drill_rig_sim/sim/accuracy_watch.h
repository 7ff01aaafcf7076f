#ifndef DRILL_RIG_SIM_SIM_ACCURACY_WATCH_H
#define DRILL_RIG_SIM_SIM_ACCURACY_WATCH_H

#include <memory>
#include <vector>

#include "drill_rig_sim/model/model.h"
#include "drill_rig_sim/model/rig_forces.h"
#include "drill_rig_sim/model/state.h"
#include "drill_rig_sim/sim/accuracy.h"
#include "drill_rig_sim/solve/energy_balance.h"
#include "drill_rig_sim/solve/integrator.h"
#include "drill_rig_sim/solve/wave_life.h"

namespace drill_rig_sim
{
/// What of the string's loads its elements, or its walls, do not stand for: the largest of the first of compression, twist and embedding
/// that there is (below).
AccuracyReport doubt_of_string(const Model& model, const State& state, const RigForces& forces) noexcept;

/// Turn where the bit is pressed aside so far that the body that follows it holds back the turn of the hole (well/turn_limit.h).
AccuracyReport doubt_of_turn(const Model& model, const State& state, const RigForces& forces) noexcept;

/// Slant where the hole leaves the rotary table by more than 10 deg from the vertical: the rig stands upright, and pulls the string over a
/// corner there. Without friction the hook load is 1 % low at 12 deg, 6 % at 20 deg.
AccuracyReport doubt_of_hole(const State& state) noexcept;

/// Where the scene needs an output that its level does not represent.
AccuracyReport doubt_of_level(const Scene& scene, const State& state) noexcept;

/// Watches what makes a run inaccurate without failing it. Every tenth frame is looked at, and the energy of its first step booked; of steps longer than frames every fourth at most.
///
/// - Compression: two cubic elements carry the half wave into which pipe in a hole buckles, pi sqrt(2 E I/P), so an element of length L
///   carries (pi^2/2) E I/L^2. Above it a mesh buckles in its own way.
/// - Twist: 1 rad an element; the corotational element is made for less.
/// - Embedding: the string is deeper in the wall than its clearance there and 2 mm: place and side forces are those of a wider hole.
/// - Refused steps: more than a fifth of the attempts of the last ten seconds; of variable steps only those that Newton's iteration did not solve.
/// - Dissipation: more than 5 % of the throughput of the last ten seconds, or of 1 kW if that is more, so that a string at rest is not
///   judged. The throughput is what comes in or what is lost, whichever is more: a string that comes free lives on what it has stored. Both are
///   sums of magnitudes, account by account and step by step (energy_accounts.h): what cancels counts.
///   A frame that takes up new set points stands for those of its kind, any other for the rest: programs' commands come in time with the samples.
/// - Cut (regenerative law): the bit turns by more than a hundredth of the way from blade to blade in a step. On quick.yaml with 5 blades,
///   which shakes, the deviation of weight is 0 at 13 steps a blade, 0.58 of the reference's at 27, 0.81 at 53 and 1.04 at 133.
/// - Shaking: a bent motor that turns at W sends up waves of W, 2 W and 3 W, and BDF2 takes (w h)^4/4 of a wave's amplitude a step. More than 0.1
///   a second of those of 3 W: as much as the mud takes of turning pipe at its default. A motor of 1.15 deg at 120 rpm in a J well sways the torque
///   by 0.36 kN m at 10 ms, by 0.64 in its reference.
/// - Waves: surface torque or hook load swing so fast that the steps have damped or delayed them by more than 2 % of the signal's range so far (10 % of the
///   hook load's, for which the estimate is too large), or will have within 3 s (wave_watch.h): a motor that starts under weight, say, whose bit breaks loose; a block that stops at once.
/// - Blows: the bit came down on the bottom every other second or more often, over the last 3 s. Its waves are what a long step blurs first:
///   tagging at 0.3 m/s in 1 km, torque 2.5 % off at 10 ms and 0.9 % at 5 ms (test/accuracy/README.md, operations).
/// - Loose: the lower end began to turn after at least a second of rest, with the string wound up by ten turns or more. The moment of that and
///   the waves after it are off by a tenth of a second: 3 % of the bit's speed over 30 s in 5 km at 60 rpm.
/// - Hesitation: the string's lower end came loose (0.3 rad/s), but stuck again before it had run as fast as the drive. Whether it goes or sticks hangs on
///   the smallest waves then, and so does the time of all that follows: stick-slip of 2.5 km at 60 rpm runs apart there by 8 % of the torque, at 10 and at 5 ms.
/// - Whirl: turning pipe (0.1 m/s at its surface, in the mean) moved sideways at more than a tenth of what rolling on its walls would make,
///   over the last 3 s, for 8 s on end. Pulled or pushed along a hole it may roll up the wall and round it; elements that bend too little do that more readily.
/// - Jerks: of the force between string and walls that have friction (5 kN at least), the share that sticks, or slides slower than 2 mm/s, came and went every twelve seconds or more often, over the
///   last 10 s; a start or a stop alone is half of that. Pipe that slides below its friction's Stribeck speed does that by itself;
///   where in its slip it is, and so the peaks and what a stop leaves, hangs on the numerics.
/// - Turn: doubt_of_turn().
/// - Slant, level: doubt_of_hole(), doubt_of_level(), where nothing else is doubted.
class AccuracyWatch
{
public:
  explicit AccuracyWatch(std::shared_ptr<const Model> model);

  /// Before a frame under `setpoints`: books the energy of its first step where its turn has come, if it `steps` at all. The reference's steps are not
  /// booked.
  void begin_frame(Integrator& integrator, const Setpoints& setpoints, bool steps, AccuracyMemory& memory) noexcept;
  /// After the frame's first step of `step` [s].
  void end_first_step(Integrator& integrator, double step, AccuracyMemory& memory) noexcept;
  /// After a frame of `duration` [s]; `forces`: at its end. `measured`: the error of the numerics is measured beside a finer model: signs of it do not count,
  /// and only what the model itself does not stand for is looked for.
  void end_frame(const Integrator& integrator, const State& state, const RigForces& forces, double duration, bool measured, AccuracyMemory& memory) noexcept;

private:
  std::shared_ptr<const Model> model_;
  EnergyBalance balance_;
  WaveLives life_;  // in the mud
  bool booked_ = false;
  std::uint64_t stands_for_ = 0;  // what is booked [frames]
  std::uint64_t steps_ = 0, attempts_ = 0;  // of the integrator, before the frame
};

}  // namespace drill_rig_sim

#endif
