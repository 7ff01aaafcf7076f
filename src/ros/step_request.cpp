// SPDX-License-Identifier: BSD-3-Clause
#include "step_request.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>

#include "drill_rig_sim/ros/conversions.h"
#include "drill_rig_sim/sim/requests.h"
#include "fault_request.h"

namespace drill_rig_sim
{
namespace
{
/// What would be refused is handed to the loop all the same, which counts it and changes nothing.
template <class Setpoint>
void require_right(SimulationLoop& loop, const Setpoint& c)
{
  if (why_refused(*loop.rig().simulator, c)) throw Refusal(loop.take(c).reason);
}

std::uint32_t frames_in(double seconds, double rate)
{
  const double frames = seconds * rate;
  constexpr double rounding = 1e-6;  // of seconds that are a whole number of frames in decimals
  const bool whole = std::isfinite(frames) && std::abs(frames - std::round(frames)) < rounding * std::fmax(1.0, frames);
  if (whole && frames > 0.5 && frames < most_frames_of_step + 0.5) return static_cast<std::uint32_t>(std::llround(frames));
  std::ostringstream out;
  out << "seconds must be a whole number of frames of " << 1.0 / rate << " s, at most " << most_frames_of_step / rate
      << " s (got " << seconds << " s)";
  throw Refusal(out.str());
}
}  // namespace

std::uint32_t frames_of(const StepSimulation::Request& request, double rate)
{
  if (request.winch.size() > 1 || request.top_drive.size() > 1 || request.mud_pump.size() > 1 || request.steering.size() > 1)
    throw Refusal("allowed is at most one command of each kind");
  if (request.seconds != 0.0)
  {
    if (request.frames != 0) throw Refusal("frames and seconds are both given; allowed is one of them, the other 0");
    return frames_in(request.seconds, rate);
  }
  if (request.frames > most_frames_of_step)
    throw Refusal("frames is " + std::to_string(request.frames) + "; allowed is 0 to " + std::to_string(most_frames_of_step));
  return request.frames;
}

std::string one_line(std::string text)
{
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

void require_good(const RunningRig& rig)
{
  if (rig.failed) throw Refusal("the last frame failed: reset_well or restore_state first");
}

void command_all(SimulationLoop& loop, const StepSimulation::Request& request)
{
  require_good(loop.rig());
  for (const auto& c : request.winch) require_right(loop, to_setpoint(c));
  for (const auto& c : request.top_drive) require_right(loop, to_setpoint(c));
  for (const auto& c : request.mud_pump) require_right(loop, to_setpoint(c));
  for (const auto& c : request.steering) require_right(loop, to_setpoint(c));
  loop.take_commands();  // what topics brought before the request is older
  for (const auto& c : request.winch) loop.take(to_setpoint(c));
  for (const auto& c : request.top_drive) loop.take(to_setpoint(c));
  for (const auto& c : request.mud_pump) loop.take(to_setpoint(c));
  for (const auto& c : request.steering) loop.take(to_setpoint(c));
}

}  // namespace drill_rig_sim
