#ifndef DRILL_RIG_SIM_STABILITY_TUMBLE_H
#define DRILL_RIG_SIM_STABILITY_TUMBLE_H

#include <string>
#include <vector>

#include "ride.h"

namespace drill_rig_sim
{
/// The ride behind the maps: scenes/inclined.yaml for four seconds. Pipe in an inclined hole is thrown across it at 2 m/s,
/// bounces from wall to wall, is lowered at 0.5 m/s meanwhile, and then turned at 60 rpm: it lies, slides, climbs and rolls.
struct Tumble
{
  Verdict verdict = Verdict::passes;
  std::string message;
  std::vector<Sample> samples;  ///< every 0.1 s
};

/// Runs it; the verdict is against `reference`, unless null.
///
/// Stable means: the run reaches its end; every number is finite; at every tenth of a second the nodes' root mean square speed is
/// at most twice the reference's largest plus 0.05 m/s; at the end the bit is within 0.05 m of the reference's place and within
/// 0.5 rad of its turn; hook load and torque, as means over the last two seconds, are within 5 %, and within 25 % + 100 N m.
/// These bounds tell stable from unstable, not exact from inexact: after a few bounces the motion is chaotic, and runs at 5e-5,
/// 1e-4 and 2e-4 s differ by some 20 N m. Speeds beyond ten times that bound are `diverged`, the rest of what is out of bounds is
/// `wrong`.
Tumble tumble(const std::vector<std::string>& settings, const Choice& choice, double step, const Tumble* reference,
              double cpu_limit);

/// The small-step reference: the default method and element at 1e-4 s.
Tumble tumble_reference(const std::vector<std::string>& settings);

}  // namespace drill_rig_sim

#endif
