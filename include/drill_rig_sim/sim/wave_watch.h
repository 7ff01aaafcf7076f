#ifndef DRILL_RIG_SIM_SIM_WAVE_WATCH_H
#define DRILL_RIG_SIM_SIM_WAVE_WATCH_H

#include "drill_rig_sim/model/state.h"

namespace drill_rig_sim
{
/// Waves in a signal at the string's top, and what the steps have made of them so far.
///
/// A wave is what the signal is away from its mean over the last half second; how often it passes that tells its frequency w. BDF2 of step h takes
/// (w h)^4/4 of its amplitude a step and is late by w (w h)^2/3 [rad/s]: so much of the waves' amplitude is added every second to what is wrong by
/// now. That goes as the waves go, and with what the mud damps them by.
struct WaveWatch
{
  double trend = 0.0;   ///< mean over the last half second [of the signal]
  double square = 0.0;  ///< of what it is away from that, mean over the last second [its square]
  double passes = 0.0;  ///< of the trend, in the same way [1/s]
  double away = 0.0;    ///< at the end of the last frame
  bool begun = false;
  ValueRange range;
  double blurred = 0.0;  ///< what is wrong of the waves by now [of the signal]

  /// After a frame of `duration` [s] by steps of `step` [s]; `life`: of waves in the mud [s].
  void note(double signal, double duration, double step, double life) noexcept;
  /// What is wrong, or will be within 3 s by steps of `step` [s], over the signal's range, a tenth of its level, or `least`, whichever is most [-].
  double blur(double step, double least) const noexcept;

  template <class V>
  void visit(V& v)
  {
    v("trend", trend);
    v("square", square);
    v("passes", passes);
    v("away", away);
    v("begun", begun);
    v("range", range);
    v("blurred", blurred);
  }
};

/// What BDF2 of `step` [s] takes of the amplitude of a wave [rad/s]: (w h)^4/4 a step [1/s].
double damping_of_wave(double frequency, double step) noexcept;

}  // namespace drill_rig_sim

#endif
