// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_STABILITY_TUMBLE_H
#define DRILL_RIG_SIM_STABILITY_TUMBLE_H

#include <string>
#include <vector>

#include "ride.h"

namespace drill_rig_sim
{
/// The ride behind the maps: scenes/inclined.yaml. Pipe in an inclined hole is thrown across it at 2 m/s, bounces from wall to
/// wall, is lowered at 0.5 m/s meanwhile, and from 1.5 s on turned at 20 rpm: it lies, slides and climbs. Turned
/// faster, thrown pipe may whirl on for good, or not: by chance.
struct Tumble
{
  Verdict verdict = Verdict::passes;
  std::string message;
  std::vector<Sample> samples;  ///< every 0.1 s
  double load_at_rest = 0.0;    ///< of the string alone, before it is thrown [N]
};

/// How long a tumble is, and what it is held against.
struct TumbleKind
{
  double seconds;
  std::vector<double> reference_throws;  ///< one small-step run each [m/s]
  double thrown;                         ///< [m/s]
};

/// The whole of it.
extern const TumbleKind whole_tumble;
/// The throw and its first bounces, for steps too short for more.
extern const TumbleKind first_bounces;
/// Without a throw.
extern const TumbleKind lowered_and_turned;
/// A step that is left to the scene.
constexpr double as_the_scene_says = 0.0;

/// Small-step runs of the default method and element, at 2e-4 s; in the fast subset those thrown at another speed than the run
/// take 1e-3 s.
struct TumbleReference
{
  TumbleKind kind;
  std::vector<Tumble> runs;

  /// The first that did not pass, else the first.
  const Tumble& worst() const;
};

TumbleReference tumble_reference(const std::vector<std::string>& settings, bool fast, const TumbleKind& kind = whole_tumble);

/// Runs it as long as the reference, and judges it against that.
///
/// Stable means: the run reaches its end; every number is finite; at every tenth of a second the nodes' root mean square speed is
/// at most twice the references' largest plus 0.05 m/s; at the end the bit is within 0.05 m of a reference's place and within
/// 0.5 rad of its turn; hook load and torque, as means over the second half, are off what the references span by no more than 5 %
/// of the string's own load at rest (without block and top drive), and 10 % + 20 N m.
///
/// Why several references: bounces are chaotic, and how long they last differs from run to run.
/// Speeds beyond ten times the bound are `diverged`, the rest of what is out of bounds is `wrong`.
Tumble tumble(const std::vector<std::string>& settings, const Choice& choice, double step, const TumbleReference& reference,
              double limit);

}  // namespace drill_rig_sim

#endif
