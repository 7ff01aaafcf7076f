#include "tumble.h"

#include <algorithm>
#include <cmath>

namespace drill_rig_sim
{
namespace
{
constexpr double kDuration = 4.0;
constexpr double kThrown = 2.0;  // [m/s]
constexpr double kReferenceStep = 1e-4;

struct Means
{
  double fastest = 0.0;    ///< [m/s]
  double hook_load = 0.0;  ///< over the last two seconds [N]
  double torque = 0.0;     ///< [N m]
};

Means means_of(const std::vector<Sample>& samples)
{
  Means m;
  int count = 0;
  for (const Sample& s : samples)
  {
    m.fastest = std::max(m.fastest, s.speed);
    if (s.time <= kDuration - 2.0 + 1e-6) continue;
    m.hook_load += s.hook_load;
    m.torque += s.torque;
    ++count;
  }
  m.hook_load /= std::max(count, 1);
  m.torque /= std::max(count, 1);
  return m;
}

/// Sets verdict and message where the run is out of bounds.
void judge(const std::vector<Sample>& reference, Tumble& run)
{
  const Means a = means_of(reference), b = means_of(run.samples);
  const double bound = 2.0 * a.fastest + 0.05;
  const double off = (run.samples.back().bit - reference.back().bit).norm();
  const double turn = run.samples.back().bit_turned - reference.back().bit_turned;
  if (!(b.fastest <= 10.0 * bound))
    run.verdict = Verdict::fails_diverged;
  else if (b.fastest > bound || off > 0.05 || std::abs(turn) > 0.5 ||
           std::abs(b.hook_load - a.hook_load) > 0.05 * std::abs(a.hook_load) ||
           std::abs(b.torque - a.torque) > 0.25 * std::abs(a.torque) + 100.0)
    run.verdict = Verdict::fails_wrong;
  else
    return;
  run.message =
      text("speed %.3g of %.3g m/s allowed; bit %.2g m and %.2g rad off; hook load %.4g of %.4g kN; torque %.3g of %.3g N m",
           b.fastest, bound, off, turn, 1e-3 * b.hook_load, 1e-3 * a.hook_load, b.torque, a.torque);
}
}  // namespace

Tumble tumble(const std::vector<std::string>& settings, const Choice& choice, double step, const Tumble* reference,
              double cpu_limit)
{
  Tumble out;
  Ride ride(load_scene("inclined", settings, choice, step), cpu_limit);
  if (ride.going()) ride.throw_sideways(kThrown);
  while (ride.going() && out.samples.size() < std::lround(kDuration / 0.1))
  {
    // a hundredth of a second resolves the torque's swing
    const int frames = std::max(1, std::min(10, static_cast<int>(std::lround(0.1 / step))));
    double torque = 0.0;
    for (int k = 0; k < frames && ride.go(0.1 / frames, 0.1 / frames); ++k) torque += ride.now().torque / frames;
    if (!ride.going()) break;
    out.samples.push_back(ride.sample());
    out.samples.back().torque = torque;
    if (!(out.samples.back().speed < 1e6)) break;
  }
  out.verdict = ride.verdict();
  out.message = ride.message();
  if (reference && ride.going()) judge(reference->samples, out);
  return out;
}

Tumble tumble_reference(const std::vector<std::string>& settings)
{
  return tumble(settings, default_choice(), kReferenceStep, nullptr, 60.0);
}

}  // namespace drill_rig_sim
