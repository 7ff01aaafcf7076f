// SPDX-License-Identifier: BSD-3-Clause
#include "tumble.h"

#include <algorithm>
#include <cmath>

namespace drill_rig_sim
{
const TumbleKind whole_tumble{16.0, {2.0, 1.9, 2.1}, 2.0};
const TumbleKind first_bounces{0.5, {2.0, 1.9, 2.1}, 2.0};
const TumbleKind lowered_and_turned{16.0, {0.0}, 0.0};

namespace
{
constexpr double kReferenceStep = 2e-4;
/// In the fast subset, of those that only show how far bounces differ: most of its time would be theirs.
constexpr double kStepBeside = 1e-3;

struct Means
{
  double fastest = 0.0;      ///< [m/s]
  double string_load = 0.0;  ///< over the second half [N]
  double torque = 0.0;       ///< [N m]
};

Means means_of(const std::vector<Sample>& samples, double seconds)
{
  Means m;
  int count = 0;
  for (const Sample& s : samples)
  {
    m.fastest = std::max(m.fastest, s.speed);
    if (s.time <= 0.5 * seconds + 1e-6) continue;
    m.string_load += s.string_load;
    m.torque += s.torque;
    ++count;
  }
  m.string_load /= std::max(count, 1);
  m.torque /= std::max(count, 1);
  return m;
}

/// What the references say of a figure.
struct Span
{
  double low = HUGE_VAL;
  double high = -HUGE_VAL;

  void take(double x)
  {
    low = std::min(low, x);
    high = std::max(high, x);
  }
  double nearest(double x) const { return std::min(std::max(x, low), high); }
  double outside(double x) const { return std::abs(x - nearest(x)); }
};

/// Sets verdict and message where the run is out of bounds.
void judge(const TumbleReference& reference, Tumble& run)
{
  const Means mine = means_of(run.samples, reference.kind.seconds);
  const Sample& end = run.samples.back();
  Span load, torque;
  double fastest = 0.0, off = HUGE_VAL, turn = HUGE_VAL;
  for (const Tumble& other : reference.runs)
  {
    const Means theirs = means_of(other.samples, reference.kind.seconds);
    fastest = std::max(fastest, theirs.fastest);
    load.take(theirs.string_load);
    torque.take(theirs.torque);
    off = std::min(off, (end.bit - other.samples.back().bit).norm());
    turn = std::min(turn, std::abs(end.bit_turned - other.samples.back().bit_turned));
  }
  const double bound = 2.0 * fastest + 0.05;
  // of four alike in their bounces one in two is the first or last: what three differ by among themselves is allowed beyond them
  // too
  const double torque_allowed = 0.1 * std::abs(torque.nearest(mine.torque)) + 20.0 + (torque.high - torque.low);
  const bool right = mine.fastest <= bound && off <= 0.05 && turn <= 0.5 &&
                     load.outside(mine.string_load) <= 0.05 * reference.runs.front().load_at_rest &&
                     torque.outside(mine.torque) <= torque_allowed;
  if (right) return;
  run.verdict = mine.fastest <= 10.0 * bound ? Verdict::fails_wrong : Verdict::fails_diverged;
  run.message = text(
      "speed %.3g of %.3g m/s allowed; bit %.2g m and %.2g rad off; string's load %.4g kN (references %.4g to %.4g); "
      "torque %.3g N m (%.3g to %.3g)",
      mine.fastest, bound, off, turn, 1e-3 * mine.string_load, 1e-3 * load.low, 1e-3 * load.high, mine.torque, torque.low,
      torque.high);
}

Tumble ride_out(const std::vector<std::string>& settings, const Choice& choice, double step, double thrown, double seconds,
                double limit)
{
  Tumble out;
  Ride ride(load_scene("inclined", settings, choice, step), limit);
  if (ride.going())
  {
    out.load_at_rest = ride.now().hook_load_string;
    if (thrown > 0.0) ride.throw_sideways(thrown);
  }
  while (ride.going() && static_cast<long>(out.samples.size()) < std::lround(seconds / 0.1))
  {
    // a hundredth of a second resolves the swing of torque and load
    const int frames = step > 0.0 ? std::max(1, std::min(10, static_cast<int>(std::lround(0.1 / step)))) : 10;
    double torque = 0.0, load = 0.0;
    for (int k = 0; k < frames && ride.go(0.1 / frames, 0.1 / frames); ++k)
    {
      torque += ride.now().torque / frames;
      load += ride.now().hook_load_string / frames;
    }
    if (!ride.going()) break;
    out.samples.push_back(ride.sample());
    out.samples.back().torque = torque;
    out.samples.back().string_load = load;
    if (!(out.samples.back().speed < 1e6)) break;
  }
  out.verdict = ride.verdict();
  out.message = ride.message();
  return out;
}
}  // namespace

const Tumble& TumbleReference::worst() const
{
  for (const Tumble& run : runs)
    if (!passed(run.verdict)) return run;
  return runs.front();
}

TumbleReference tumble_reference(const std::vector<std::string>& settings, bool fast, const TumbleKind& kind)
{
  TumbleReference out{kind, {}};
  for (double thrown : kind.reference_throws)
  {
    const double step = fast && thrown != kind.thrown ? kStepBeside : kReferenceStep;
    out.runs.push_back(ride_out(settings, default_choice(), step, thrown, kind.seconds, 240e6));
  }
  return out;
}

Tumble tumble(const std::vector<std::string>& settings, const Choice& choice, double step, const TumbleReference& reference,
              double limit)
{
  Tumble out = ride_out(settings, choice, step, reference.kind.thrown, reference.kind.seconds, limit);
  if (passed(out.verdict)) judge(reference, out);
  return out;
}

}  // namespace drill_rig_sim
