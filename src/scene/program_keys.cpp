// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cstddef>
#include <iterator>

#include "scene_keys.h"

namespace drill_rig_sim
{
const std::vector<const char*> operation_words = {
#define OPERATION(name, ...) #name,
#include "drill_rig_sim/scene/operation_list.h"
};

std::string unit_of(FaultKind fault, Gauge gauge)
{
  const FaultMagnitude& magnitude = traits_of(fault).magnitude;
  if (magnitude.dimension == Dimension::number) return "";
  const bool of_gauge = magnitude.dimension == Dimension::count;
  return std::string(of_gauge ? unit_of(gauge) : si_name(magnitude.dimension)) + (magnitude.per_second ? "/s" : "");
}

std::string unit_of(const std::string& fault, const std::string& gauge)
{
  const auto* const traits =
      std::find_if(std::begin(fault_traits), std::end(fault_traits), [&](const FaultTraits& f) { return f.word == fault; });
  if (traits == std::end(fault_traits)) return "";
  const auto* const name = std::find(std::begin(gauge_names), std::end(gauge_names), gauge);
  return unit_of(static_cast<FaultKind>(traits - fault_traits),
                 name == std::end(gauge_names) ? Gauge::hook_load : static_cast<Gauge>(name - gauge_names));
}

namespace
{
constexpr unsigned flow = kind(OperationKind::flow), rotate = kind(OperationKind::rotate), pick_up = kind(OperationKind::pick_up),
                   slack_off = kind(OperationKind::slack_off), tag = kind(OperationKind::tag), drill = kind(OperationKind::drill),
                   slide = kind(OperationKind::slide), oscillate = kind(OperationKind::oscillate),
                   ream = kind(OperationKind::ream), wait = kind(OperationKind::wait), steer = kind(OperationKind::steer),
                   connection = kind(OperationKind::connection), trip = kind(OperationKind::trip);
constexpr unsigned ramps = flow | rotate, rocks = slide | oscillate, drills = drill | slide, moves = pick_up | slack_off,
                   crew = connection | trip;
constexpr unsigned lasts = every_kind & ~(tag | ream | steer | crew);
const std::vector<const char*> top_drive_mode_words = {
#define MODE(name, ...) #name,
#include "drill_rig_sim/rig/top_drive_mode_list.h"
};
const std::vector<const char*> fault_words = {
#define FAULT(name, ...) #name,
#include "drill_rig_sim/scene/fault_list.h"
};
const std::vector<const char*> gauge_words(gauge_names, gauge_names + gauge_count);
}  // namespace

// clang-format off
const Table<ProgramStep> program_keys = {"program[]", "Commands and faults at simulated times. A key that is left out leaves "
    "its set point unchanged. A ramp begins at the set point in force: at 0 where the winch's brake is set, at the measured "
    "value where the drive is braked or in the other mode. It ends early when a later line sets the same set point, the other "
    "mode or the brake.", {
  {"at",                    "s",      &ProgramStep::at,                    between(0.0, 1e7),
      "simulated time, in ascending order", must},
  {"ramp",                  "s",      &ProgramStep::ramp,                  between(0.0, 1e7),
      "time over which block_velocity, top_drive_speed_rpm, top_drive_torque and flow of this line are reached linearly; 0: at "
      "once"},
  {"block_velocity",        "m/s",    &ProgramStep::block_velocity,        between(-20.0, 20.0),
      "velocity of the block, + up; releases the brake", no_kind, every_kind, "as before"},
  {"top_drive_speed_rpm",   "rpm",    &ProgramStep::top_drive_speed,       between(-1000.0, 1000.0),
      "speed of the top drive, + clockwise: in speed mode, soft_torque and z_torque; the largest speed in angle and oscillate",
      no_kind, every_kind, "as before"},
  {"top_drive_torque",      "N m",    &ProgramStep::top_drive_torque,      between(-1e6, 1e6),
      "torque of the top drive, + clockwise: torque mode", no_kind, every_kind, "as before"},
  {"top_drive_mode",        "",       Choice<ProgramStep>{top_drive_mode_words,
      [](ProgramStep& s, int word) { s.top_drive_mode = word; },
      [](const ProgramStep& s) { return s.top_drive_mode; }},
      none, "mode of the top drive", no_kind, every_kind, "by the keys beside it; a speed leaves soft_torque and z_torque"},
  {"top_drive_angle_deg",   "deg",    &ProgramStep::top_drive_angle,       between(-1e7, 1e7),
      "angle of the shaft since the start: angle mode, or the middle of oscillate", no_kind, every_kind, "as before"},
  {"amplitude_right_deg",   "deg",    &ProgramStep::amplitude_right,       between(0.0, 1e5),
      "oscillate: amplitude clockwise from the middle", no_kind, every_kind, "as before"},
  {"amplitude_left_deg",    "deg",    &ProgramStep::amplitude_left,        between(0.0, 1e5),
      "oscillate: amplitude counterclockwise from the middle", no_kind, every_kind, "as before"},
  {"top_drive_torque_limit", "N m",   &ProgramStep::torque_limit,          between(0.0, 1e6),
      "largest torque that the drive may use; 0: the limit of the rig", no_kind, every_kind, "as before"},
  {"flow",                  "m3/s",   &ProgramStep::flow,                  between(0.0, 1.0),    "flow of the mud pump", no_kind,
      every_kind, "as before"},
  {"steering_toolface_deg", "deg",    &ProgramStep::steering_toolface,     between(-360.0, 360.0),
      "direction of the force or the tilt of a rotary_steerable", no_kind, every_kind, "as before"},
  {"steering_ratio",        "-",      &ProgramStep::steering_ratio,        between(0.0, 1.0),
      "share of the full force or tilt of a rotary_steerable", no_kind, every_kind, "as before"},
  {"top_drive_brake",       "",       Flag<ProgramStep>{&ProgramStep::top_drive_brake}, none,
      "true sets the top drive's brake, false releases it; a speed or a torque releases it too", no_kind, every_kind,
      "as before"},
  {"brake",                 "",       Flag<ProgramStep>{&ProgramStep::brake}, none,
      "true sets the winch's brake, false releases it", no_kind, every_kind, "as before"},
  {"stuck_at",              "m",      &ProgramStep::stuck_at,              above(0.0, 20000.0),
      "measured depth where the hole grips the pipe; not below the bit at that time", no_kind, every_kind, "as before"},
  {"free",                  "",       Flag<ProgramStep>{&ProgramStep::free}, none,
      "true: the stuck pipe is free again", no_kind, every_kind, "as before"},
  {"slips",                 "",       Flag<ProgramStep>{&ProgramStep::slips}, none,
      "true sets the slips, with block and top drive at rest; false pulls them", no_kind, every_kind, "as before"},
  {"connection",            "",       &ProgramStep::connection,            between(-12.0, 12.0),
      "number of joints added to the string in the slips; negative: removed", no_kind, every_kind, "none"},
  {"fault",                 "",       Choice<ProgramStep>{fault_words, [](ProgramStep& s, int word) { s.fault = word; },
      [](const ProgramStep& s) { return s.fault; }},
      none, "fault that begins, as by the service inject_fault", no_kind, every_kind, "none"},
  {"fault_depth",           "m",      &ProgramStep::fault_depth,           between(0.0, 20000.0),
      "measured depth of a fault that has a place; pipe must be there at that time"},
  {"fault_magnitude",       "signal",       &ProgramStep::fault_magnitude,       between(-1e9, 1e9),
      "magnitude of the fault, in its unit (InjectFault.srv)"},
  {"fault_target",          "",       Choice<ProgramStep>{gauge_words, [](ProgramStep& s, int word) { s.fault_gauge = word; },
      [](const ProgramStep& s) { return s.fault_gauge; }},
      none, "gauge of a sensor's fault that begins or ends", no_kind, every_kind, "none"},
  {"clear_fault",           "",       Choice<ProgramStep>{fault_words, [](ProgramStep& s, int word) { s.clear_fault = word; },
      [](const ProgramStep& s) { return s.clear_fault; }},
      none, "fault that ends", no_kind, every_kind, "none"},
  {"free_length",           "m",      &ProgramStep::free_length,           between(0.0, 20000.0),
      "a coarser level from now on: all motions are modelled up to this distance above the bit's face, motions along and about "
      "the hole above; 0: axial_torsional. Not longer than before", no_kind, every_kind, "as before"},
}};

const Table<Operation> operation_keys = {"operations[]", "Tasks of the driller, one after the other; each ends at the first of "
    "its ends: to_depth, distance, time, weight (slack_off and tag) or overpull. Lines of `program` act at their times beside "
    "them. Weights, depths and toolface are those of the readings.", {
  {"do",                    "",       Choice<Operation>{operation_words,
      [](Operation& o, int word) { o.kind = static_cast<OperationKind>(word); },
      [](const Operation& o) { return static_cast<int>(o.kind); }},
      none, "task; flow, rotate and steer stay in force while others follow", every_kind},
  {"ramp",                  "s",      &Operation::ramp,                    between(0.0, 1e5),
      "time over which flow or speed_rpm is reached", no_kind, ramps},
  {"flow",                  "m3/s",   &Operation::flow,                    between(0.0, 1.0),    "flow of the mud pump", flow,
      flow},
  {"speed_rpm",             "rpm",    &Operation::rotary_speed,            between(-1000.0, 1000.0),
      "speed of the top drive, + clockwise; the largest speed for oscillate and for a slide that rocks (0: 10 rpm)", rotate,
      rotate | rocks},
  {"speed",                 "m/s",    &Operation::speed,                   above(0.0, 20.0),
      "speed of the block; for drill and slide the largest", no_kind, moves | tag | drills | ream | crew, "0.1; of tag 0.02"},
  {"weight",                "N",      &Operation::weight,                  above(0.0, 2e6),
      "surface weight on bit that drill and slide hold, and at which slack_off and tag end", drills, slack_off | tag | drills,
      "none; of tag 5000"},
  {"toolface_deg",          "deg",    &Operation::toolface,                between(-360.0, 360.0),
      "slide: toolface of the readings, held by the top drive's angle; steer: direction of the force or tilt of a "
      "rotary_steerable", slide | steer, slide | steer},
  {"ratio",                 "-",      &Operation::ratio,                   between(0.0, 1.0),
      "share of the full force or tilt of a rotary_steerable", steer, steer},
  {"amplitude_right_deg",   "deg",    &Operation::amplitude_right,         between(0.0, 1e5),
      "rocking amplitude clockwise; of slide: 0, no rocking", no_kind, rocks},
  {"amplitude_left_deg",    "deg",    &Operation::amplitude_left,          between(0.0, 1e5),
      "rocking amplitude counterclockwise", no_kind, rocks},
  {"times",                 "",       &Operation::times,                   between(1, 1000),     "number of strokes up and down",
      no_kind, ream},
  {"to_depth",              "m",      &Operation::to_depth,                between(0.0, 20000.0),
      "end: measured depth of the bit; of the hole for drill and slide", trip, moves | drills | trip, "none"},
  {"distance",              "m",      &Operation::distance,                above(0.0, 20000.0),
      "end: travel of the block; for drill and slide new hole by the reading of hole_depth, in which the string's shortening "
      "under the weight counts too; for ream each stroke", ream, moves | drills | ream, "none"},
  {"time",                  "s",      &Operation::time,                    between(0.0, 1e7),
      "end: time since the task began; for flow and rotate since the end of the ramp, 0 by default", wait, lasts, "none"},
  {"remove",                "",       Flag<Operation>{&Operation::remove}, none,
      "true: a stand is removed, on the way up; false: a stand is added, on the way down", no_kind, connection, "false"},
  {"overpull",              "N",      &Operation::overpull,                above(0.0, 5e6),
      "end: hook load above that at the task's beginning", no_kind, pick_up, "none"},
}};
// clang-format on

Operation default_operation(OperationKind kind) noexcept
{
  Operation o;
  o.kind = kind;
  if (kind != OperationKind::tag) return o;
  o.speed = 0.02;
  o.weight = 5000.0;
  return o;
}

}  // namespace drill_rig_sim
