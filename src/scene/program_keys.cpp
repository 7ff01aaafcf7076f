#include <cstddef>

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

namespace
{
constexpr unsigned flow = kind(OperationKind::flow), rotate = kind(OperationKind::rotate), pick_up = kind(OperationKind::pick_up),
                   slack_off = kind(OperationKind::slack_off), tag = kind(OperationKind::tag), drill = kind(OperationKind::drill),
                   slide = kind(OperationKind::slide), oscillate = kind(OperationKind::oscillate), ream = kind(OperationKind::ream),
                   wait = kind(OperationKind::wait), steer = kind(OperationKind::steer),
                   connection = kind(OperationKind::connection), trip = kind(OperationKind::trip);
constexpr unsigned ramps = flow | rotate, rocks = slide | oscillate, drills = drill | slide, moves = pick_up | slack_off, crew = connection | trip;
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
const Table<ProgramStep> program_keys = {"program[]", "Set points and faults at a simulated time; a key that is left out does not change its set point. A ramp begins at the set point in force (at 0 where the winch's brake holds the block, at what the drive does where it is braked or in the other mode) and is followed frame by frame; a later line that sets the same, the other mode or the brake ends it.", {
  {"at",                    "s",      &ProgramStep::at,                    between(0.0, 1e7),    "simulated time, ascending", must},
  {"ramp",                  "s",      &ProgramStep::ramp,                  between(0.0, 1e7),    "the line's block_velocity, top_drive_speed_rpm, top_drive_torque and flow are reached in a straight line over this time; 0: at once"},
  {"block_velocity",        "m/s",    &ProgramStep::block_velocity,        between(-20.0, 20.0), "+ up; releases the brake", no_kind, every_kind, "as before"},
  {"top_drive_speed_rpm",   "rpm",    &ProgramStep::top_drive_speed,       between(-1000.0, 1000.0), "+ clockwise: speed mode, or soft_torque and z_torque; of angle and oscillate the largest", no_kind, every_kind, "as before"},
  {"top_drive_torque",      "N m",    &ProgramStep::top_drive_torque,      between(-1e6, 1e6),   "torque mode, + clockwise", no_kind, every_kind, "as before"},
  {"top_drive_mode",        "",       Choice<ProgramStep>{top_drive_mode_words, [](ProgramStep& s, int word) { s.top_drive_mode = word; },
                                                          [](const ProgramStep& s) { return s.top_drive_mode; }},
                                                                           none,                 "of the top drive", no_kind, every_kind, "by the keys beside it; a speed leaves soft_torque and z_torque"},
  {"top_drive_angle_deg",   "deg",    &ProgramStep::top_drive_angle,       between(-1e7, 1e7),   "of the shaft, since the start: angle mode, or the middle of oscillate", no_kind, every_kind, "as before"},
  {"amplitude_right_deg",   "deg",    &ProgramStep::amplitude_right,       between(0.0, 1e5),    "from there clockwise: oscillate", no_kind, every_kind, "as before"},
  {"amplitude_left_deg",    "deg",    &ProgramStep::amplitude_left,        between(0.0, 1e5),    "from there counterclockwise: oscillate", no_kind, every_kind, "as before"},
  {"top_drive_torque_limit", "N m",   &ProgramStep::torque_limit,          between(0.0, 1e6),    "largest that the drive may use; 0: the rig's", no_kind, every_kind, "as before"},
  {"flow",                  "m3/s",   &ProgramStep::flow,                  between(0.0, 1.0),    "of the mud pump", no_kind, every_kind, "as before"},
  {"steering_toolface_deg", "deg",    &ProgramStep::steering_toolface,     between(-360.0, 360.0), "of the force or the tilt of a rotary_steerable", no_kind, every_kind, "as before"},
  {"steering_ratio",        "-",      &ProgramStep::steering_ratio,        between(0.0, 1.0),    "of its full force or tilt", no_kind, every_kind, "as before"},
  {"top_drive_brake",       "",       Flag<ProgramStep>{&ProgramStep::top_drive_brake}, none,    "sets or releases the top drive's brake; speed and torque release it", no_kind, every_kind, "as before"},
  {"brake",                 "",       Flag<ProgramStep>{&ProgramStep::brake}, none,              "sets or releases the winch's brake", no_kind, every_kind, "as before"},
  {"stuck_at",              "m",      &ProgramStep::stuck_at,              above(0.0, 20000.0),  "measured depth where the hole grips the pipe, not below the bit by then", no_kind, every_kind, "as before"},
  {"free",                  "",       Flag<ProgramStep>{&ProgramStep::free}, none,               "true: it lets go", no_kind, every_kind, "as before"},
  {"slips",                 "",       Flag<ProgramStep>{&ProgramStep::slips}, none,              "sets the slips, block and drive at rest, or pulls them", no_kind, every_kind, "as before"},
  {"connection",            "",       &ProgramStep::connection,            between(-12.0, 12.0), "number of joints added to the string in the slips; negative: taken away", no_kind, every_kind, "none"},
  {"fault",                 "",       Choice<ProgramStep>{fault_words, [](ProgramStep& s, int word) { s.fault = word; }, [](const ProgramStep& s) { return s.fault; }},
                                                                           none,                 "begins, as by the service inject_fault", no_kind, every_kind, "none"},
  {"fault_depth",           "m",      &ProgramStep::fault_depth,           between(0.0, 20000.0), "measured depth of its place, where it has one; pipe must be there by then"},
  {"fault_magnitude",       "signal",       &ProgramStep::fault_magnitude,       between(-1e9, 1e9),   "in the unit of the fault (InjectFault.srv), where it has one"},
  {"fault_target",          "",       Choice<ProgramStep>{gauge_words, [](ProgramStep& s, int word) { s.fault_gauge = word; }, [](const ProgramStep& s) { return s.fault_gauge; }},
                                                                           none,                 "gauge of a sensor's fault that begins or ends", no_kind, every_kind, "none"},
  {"clear_fault",           "",       Choice<ProgramStep>{fault_words, [](ProgramStep& s, int word) { s.clear_fault = word; }, [](const ProgramStep& s) { return s.clear_fault; }},
                                                                           none,                 "ends", no_kind, every_kind, "none"},
  {"free_length",           "m",      &ProgramStep::free_length,           between(0.0, 20000.0), "a coarser level: so far above the bit's face all motions are modelled from now on, above that those along the hole and about it; 0: axial_torsional; not longer than before", no_kind, every_kind, "as before"},
}};

const Table<Operation> operation_keys = {"operations[]", "Tasks of the driller, one after the other, each until the first of its ends is reached; beside `program`, whose lines act at their times. Weights, depths and toolface are those of the readings. Ends are to_depth, distance, time, weight (of slack_off and tag) and overpull.", {
  {"do",                    "",       Choice<Operation>{operation_words, [](Operation& o, int word) { o.kind = static_cast<OperationKind>(word); },
                                                        [](const Operation& o) { return static_cast<int>(o.kind); }},
                                                                           none,                 "what; flow, rotate and steer go on while others follow", every_kind},
  {"ramp",                  "s",      &Operation::ramp,                    between(0.0, 1e5),    "over which flow or speed_rpm is reached", no_kind, ramps},
  {"flow",                  "m3/s",   &Operation::flow,                    between(0.0, 1.0),    "of the mud pump", flow, flow},
  {"speed_rpm",             "rpm",    &Operation::rotary_speed,            between(-1000.0, 1000.0), "of the top drive, + clockwise; of oscillate, and of slide that rocks, the largest, 0: 10 rpm", rotate, rotate | rocks},
  {"speed",                 "m/s",    &Operation::speed,                   above(0.0, 20.0),     "of the block; of drill and slide the largest", no_kind, moves | tag | drills | ream | crew, "0.1; of tag 0.02"},
  {"weight",                "N",      &Operation::weight,                  above(0.0, 2e6),      "surface weight on bit: that drill and slide keep, and at which slack_off and tag end", drills, slack_off | tag | drills, "none; of tag 5000"},
  {"toolface_deg",          "deg",    &Operation::toolface,                between(-360.0, 360.0), "of the readings, to which slide turns the string by the top drive's angle; of the force or the tilt of a rotary_steerable", slide | steer, slide | steer},
  {"ratio",                 "-",      &Operation::ratio,                   between(0.0, 1.0),    "of the full force or tilt of a rotary_steerable", steer, steer},
  {"amplitude_right_deg",   "deg",    &Operation::amplitude_right,         between(0.0, 1e5),    "rocks the string so far clockwise; slide: 0, it does not rock", no_kind, rocks},
  {"amplitude_left_deg",    "deg",    &Operation::amplitude_left,          between(0.0, 1e5),    "and so far counterclockwise", no_kind, rocks},
  {"times",                 "",       &Operation::times,                   between(1, 1000),     "up and down again", no_kind, ream},
  {"to_depth",              "m",      &Operation::to_depth,                between(0.0, 20000.0), "end: measured depth, of the bit; of the hole for drill and slide", trip, moves | drills | trip, "none"},
  {"distance",              "m",      &Operation::distance,                above(0.0, 20000.0),  "end: travel of the block; of drill and slide metres of new hole; of ream each stroke", ream, moves | drills | ream, "none"},
  {"time",                  "s",      &Operation::time,                    between(0.0, 1e7),    "end: since its beginning; of flow and rotate since the ramp was over, 0 by default", wait, lasts, "none"},
  {"remove",                "",       Flag<Operation>{&Operation::remove}, none,                  "true: a stand is taken away, on the way up; else one is added, on the way down", no_kind, connection, "false"},
  {"overpull",              "N",      &Operation::overpull,                above(0.0, 5e6),      "end: hook load above that at the beginning", no_kind, pick_up, "none"},
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
