#include "drill_rig_sim/sim/wave_watch.h"

#include <algorithm>
#include <cmath>

#include "drill_rig_sim/math/running_mean.h"
#include "drill_rig_sim/math/units.h"

namespace drill_rig_sim
{
namespace
{
constexpr double trend_time = 0.5;  // what is slower is no wave [s]
constexpr double wave_time = 1.0;   // a motor's start sends its waves within seconds [s]
constexpr double ahead = 3.0;       // [s]
constexpr double share_of_level = 0.1;

/// Of a wave's amplitude, a second.
double blur_rate(double passes, double step) noexcept
{
  const double frequency = pi * passes;
  return damping_of_wave(frequency, step) + frequency * std::pow(frequency * step, 2) / 3.0;
}
}  // namespace

double damping_of_wave(double frequency, double step) noexcept
{
  return step > 0.0 ? 0.25 * std::pow(frequency * step, 4) / step : 0.0;
}

void WaveWatch::note(double signal, double duration, double step, double life) noexcept
{
  if (!begun)
  {
    trend = signal;
    range = {signal, signal};
    begun = true;
  }
  average(signal, duration, trend_time, trend);
  const double now = signal - trend;
  average(now * now, duration, wave_time, square);
  average((now > 0.0) != (away > 0.0) ? 1.0 / duration : 0.0, duration, wave_time, passes);
  away = now;
  range.add(signal);
  const double waves = std::sqrt(square);
  blurred = std::min(waves, (blurred + duration * blur_rate(passes, step) * waves) * std::exp(-duration / life));
}

double WaveWatch::blur(double step, double least) const noexcept
{
  const double waves = std::sqrt(square), wrong = std::min(waves, blurred + ahead * blur_rate(passes, step) * waves);
  return wrong / std::max({range.span(), share_of_level * std::abs(trend), least});
}

}  // namespace drill_rig_sim
