// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/ros/diagnostics_report.h"

#include <cmath>
#include <cstdio>
#include <sstream>

#include "drill_rig_sim/accuracy/output_difference.h"
#include "drill_rig_sim/ros/accuracy_message.h"
#include "drill_rig_sim/ros/conversions.h"

namespace drill_rig_sim
{
namespace
{
using diagnostic_msgs::DiagnosticStatus;

const char* word(RunState state)
{
  switch (state)
  {
    case RunState::running:
      return "running";
    case RunState::paused:
      return "paused";
    case RunState::waiting:
      return "waiting for a step";
    case RunState::failed:
      break;
  }
  return "failed";
}

constexpr std::int64_t millisecond = 1'000'000;  // [ns]

// How many times were below each bound and not below the one before.
std::string text_of(const TimeHistogram& times)
{
  std::ostringstream text;
  std::uint64_t before = 0;
  double last = 0.0;
  for (const double bound : {0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0})
  {
    const std::uint64_t below = times.below(std::llround(bound * millisecond));
    text << "< " << bound << " ms: " << below - before << ", ";
    before = below;
    last = bound;
  }
  text << ">= " << last << " ms: " << times.number() - before;
  return text.str();
}

void add_times(diagnostic_updater::DiagnosticStatusWrapper& s, const std::string& key, const TimeHistogram& times)
{
  for (const double percent : {50.0, 99.0, 99.9, 99.99})
  {
    std::ostringstream name;
    name << key << "_p" << percent << "_ms";
    s.add(name.str(), 1e3 * times.percentile(0.01 * percent));
  }
  s.add(key + "_share_below_1_ms", times.share_below(millisecond));
  s.add(key + "_share_below_period", times.share_within());
}

std::string in_percent(double share)
{
  if (share < 1e-4) return "below 0.01 %";
  char text[32];
  std::snprintf(text, sizeof text, share < 0.1 ? "%.2g %%" : "%.0f %%", 100.0 * share);
  return text;
}

// The measured errors of the outputs that the scene needs, and what is allowed; empty where none is measured.
std::string needed_errors(const FrameRecord& frame)
{
  if (!frame.physics.error_is_measured) return "";
  std::string text;
  for (std::size_t i = 0; i < output_count; ++i)
    if (frame.accuracy.needs & output_traits[i].need)
      text += std::string(text.empty() ? "" : ", ") + output_traits[i].words + " " + in_percent(frame.physics.errors[i]);
  return text.empty() ? "none for the outputs in `needs`" : text + " (allowed " + in_percent(frame.accuracy.tolerance) + ")";
}
}  // namespace

std::string trouble_of(const OperationStatus& operation)
{
  if (operation.trouble == OperationTrouble::none) return "";
  std::ostringstream text;
  text << "operation " << operation.number << " of " << operation.count << ", " << word_of(operation.kind)
       << ", was given up, the block is braked: " << text_of(operation.trouble);
  return text.str();
}

std::optional<double> RealTimeFactor::update(double ticked, RunState state, std::int64_t now) noexcept
{
  const bool stands = state == RunState::paused || state == RunState::failed;
  if (!begun_ || (stood_ && !stands))  // what stood is no part of what runs
  {
    begun_ = true;
    ticked_ = ticked;
    since_ = now;
  }
  else if (now - since_ >= shortest)
  {
    factor_ = (ticked - ticked_) / (1e-9 * static_cast<double>(now - since_));
    ticked_ = ticked;
    since_ = now;
  }
  stood_ = stands;
  return factor_;
}

diagnostic_msgs::DiagnosticArray DiagnosticsReport::on(const FrameRecord& frame, const Refusals& refusals,
                                                       const std::string& clock_trouble, std::int64_t now,
                                                       const std::string& sender_trouble)
{
  diagnostic_msgs::DiagnosticArray array;
  array.header.stamp = to_time(frame.stamp);
  array.status = {time_status(frame, clock_trouble, now), physics_status(frame), accuracy_status(frame),
                  command_status(frame, refusals, sender_trouble)};
  return array;
}

DiagnosticsReport::Status DiagnosticsReport::status(const std::string& part, const std::string& summary) const
{
  Status s;
  s.name = name_ + ": " + part;
  s.hardware_id = name_;
  s.summary(DiagnosticStatus::OK, summary);
  return s;
}

DiagnosticsReport::Status DiagnosticsReport::time_status(const FrameRecord& frame, const std::string& clock_trouble,
                                                         std::int64_t now)
{
  Status s = status("time", word(frame.run_state));
  if (frame.loop.dropped_seconds > dropped_before_)
    s.mergeSummary(DiagnosticStatus::WARN, std::string(word(frame.run_state)) + ", slower than the requested speed");
  dropped_before_ = frame.loop.dropped_seconds;
  if (!clock_trouble.empty()) s.mergeSummary(DiagnosticStatus::WARN, clock_trouble);
  s.add("state", word(frame.run_state));
  s.add("simulated_time", frame.loop.ticked_seconds);
  const auto factor = factor_.update(frame.loop.ticked_seconds, frame.run_state, now);
  if (factor) s.add("real_time_factor", *factor);
  s.add("speed", frame.loop.speed);
  s.add("overruns", frame.loop.overruns);
  s.add("dropped_seconds", frame.loop.dropped_seconds);
  s.add("unpublished_frames", frame.loop.unpublished_frames);
  s.add("pictures_left_out", frame.loop.pictures_left_out);
  s.add("longest_frame_ms", 1e3 * frame.loop.frame_times.longest());
  s.add("frame_times", text_of(frame.loop.frame_times));
  add_times(s, "frame_time", frame.loop.frame_times);
  s.add("longest_lateness_ms", 1e3 * frame.loop.lateness.longest());
  s.add("latenesses", text_of(frame.loop.lateness));
  add_times(s, "lateness", frame.loop.lateness);
  return s;
}

DiagnosticsReport::Status DiagnosticsReport::physics_status(const FrameRecord& frame) const
{
  Status s = status("physics", "solved");
  const SimulatorStatistics& p = frame.physics;
  if (frame.run_state == RunState::failed)
    s.mergeSummary(DiagnosticStatus::ERROR, std::string("simulation stopped at the last good state: ") + frame.failure.data());
  const auto tell = [&s](bool beyond, const char* what, const std::string& key, const LoadShare& load)
  {
    if (beyond) s.mergeSummary(DiagnosticStatus::WARN, what);
    s.add(key + "_share", load.share);
    s.add(key + "_from_bit", load.from_bit);
  };
  tell(frame.truth.over_stress, "pipe beyond its yield strength", "yield", p.loads.stress);
  s.add("pull_to_yield", p.loads.pull_to_yield);
  tell(frame.truth.over_torque, "connection beyond its make-up torque", "make_up", p.loads.torque);
  tell(frame.truth.buckled, "pipe beyond its buckling load", "buckling", p.loads.buckling);
  if (p.tight) s.mergeSummary(DiagnosticStatus::WARN, text_of(*p.tight));
  if (frame.truth.relief_valve_open)
    s.mergeSummary(DiagnosticStatus::WARN, "relief valve open: part of the flow goes back to the tanks");
  s.add("level", p.level);
  s.add("integrator", p.integrator);
  s.add("kernel", name_of(p.kernel));
  s.add("step", p.step);
  s.add("last_step", p.last_step);
  s.add("nodes", p.nodes);
  s.add("coordinates", p.coordinates);
  s.add("frames", p.frames);
  s.add("steps", p.steps);
  s.add("newton_iterations", p.newton_iterations);
  s.add("newton_iterations_per_step",
        p.steps > 0 ? static_cast<double>(p.newton_iterations) / static_cast<double>(p.steps) : 0.0);
  s.add("convergence_failures", p.convergence_failures);
  s.add("error_test_failures", p.error_test_failures);
  s.add("error_estimate", p.last_error_estimate);
  return s;
}

DiagnosticsReport::Status DiagnosticsReport::accuracy_status(const FrameRecord& frame) const
{
  const SimulatorStatistics& p = frame.physics;
  const std::string errors = needed_errors(frame), why = why_not_measured(p);
  Status s =
      status("accuracy", why.empty() ? "measured errors, relative to the ranges: " + errors : "error not measured: " + why);
  if (frame.truth.accuracy_warning) s.mergeSummary(DiagnosticStatus::WARN, text_of(p.accuracy));
  s.add("reason_code", code_of(p.accuracy.doubt));
  s.add("measured_errors", errors);
  for (std::size_t i = 0; p.error_is_measured && i < output_count; ++i)
    s.add(std::string("error_") + output_traits[i].name, p.errors[i]);
  s.add("error_window", difference_window);
  s.add("tolerance", frame.accuracy.tolerance);
  s.add("companion", text_of(p.companion));
  s.add("why_not_measured", why);
  s.add("companion_cost_share", companion_cost_share(p));
  return s;
}

DiagnosticsReport::Status DiagnosticsReport::command_status(const FrameRecord& frame, const Refusals& refusals,
                                                            const std::string& sender_trouble)
{
  Status s = status("commands", "obeyed");
  const std::uint64_t refused = refusals.number(), clamped = frame.physics.commands_clamped;
  if (clamped < clamped_before_) clamped_before_ = 0;  // another rig's count
  if (frame.truth.commands_timed_out)
    s.mergeSummary(DiagnosticStatus::WARN, "no commands for winch or top drive: brake set, drive coasts until commands arrive");
  if (refused > refused_before_) s.mergeSummary(DiagnosticStatus::WARN, std::string("refused: ") + refusals.last());
  if (clamped > clamped_before_ || frame.truth.command_clamped)
    s.mergeSummary(DiagnosticStatus::WARN, std::string("beyond a limit: ") + frame.last_clamp);
  if (!sender_trouble.empty()) s.mergeSummary(DiagnosticStatus::WARN, sender_trouble);
  if (frame.operation.trouble != OperationTrouble::none) s.mergeSummary(DiagnosticStatus::ERROR, trouble_of(frame.operation));
  refused_before_ = refused;
  clamped_before_ = clamped;
  std::string faults;
  for (const std::string& word : words_of(frame.faults)) faults += (faults.empty() ? "" : ", ") + word;
  s.add("active_faults", faults);
  s.add("clamped", clamped);
  s.add("last_clamp", frame.last_clamp);
  s.add("refused", refused);
  s.add("last_refusal", refusals.last());
  return s;
}

}  // namespace drill_rig_sim
