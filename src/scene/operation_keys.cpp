#include <cstddef>

#include "scene_keys.h"

namespace drill_rig_sim
{
const std::vector<const char*> operation_words = {"flow", "rotate", "pick_up", "slack_off", "tag", "drill", "slide", "oscillate", "ream", "wait"};

namespace
{
constexpr unsigned flow = kind(OperationKind::flow), rotate = kind(OperationKind::rotate), pick_up = kind(OperationKind::pick_up),
                   slack_off = kind(OperationKind::slack_off), tag = kind(OperationKind::tag), drill = kind(OperationKind::drill),
                   slide = kind(OperationKind::slide), oscillate = kind(OperationKind::oscillate), ream = kind(OperationKind::ream),
                   wait = kind(OperationKind::wait);
constexpr unsigned ramps = flow | rotate, rocks = slide | oscillate, drills = drill | slide, moves = pick_up | slack_off;
constexpr unsigned lasts = every_kind & ~(tag | ream);
constexpr Range none{};
}  // namespace

// clang-format off
const Table<Operation> operation_keys = {"operations[]", "What the driller does, one operation after the other, each until the first of its ends has come; beside `program`, whose lines act at their times. Weights, depths and toolface are those of the readings. Ends are to_depth, distance, time, weight (of slack_off and tag) and overpull.", {
  {"do",                    "",       Choice<Operation>{operation_words, [](Operation& o, int word) { o.kind = static_cast<OperationKind>(word); },
                                                        [](const Operation& o) { return static_cast<int>(o.kind); }},
                                                                           none,                 "what; flow and rotate go on while others follow", every_kind},
  {"ramp",                  "s",      &Operation::ramp,                    between(0.0, 1e5),    "over which flow or speed_rpm is reached", no_kind, ramps},
  {"flow",                  "m3/s",   &Operation::flow,                    between(0.0, 1.0),    "of the mud pump", flow, flow},
  {"speed_rpm",             "rpm",    &Operation::rotary_speed,            between(-1000.0, 1000.0), "of the top drive, + clockwise; of oscillate, and of slide that rocks, the largest, 0: 10 rpm", rotate, rotate | rocks},
  {"speed",                 "m/s",    &Operation::speed,                   above(0.0, 20.0),     "of the block; of drill and slide the largest", no_kind, moves | tag | drills | ream, "0.1; of tag 0.02"},
  {"weight",                "N",      &Operation::weight,                  above(0.0, 2e6),      "surface weight on bit: that drill and slide keep, and at which slack_off and tag end", drills, slack_off | tag | drills, "none; of tag 5000"},
  {"toolface_deg",          "deg",    &Operation::toolface,                between(-360.0, 360.0), "of the readings, to which slide turns the string by the top drive's angle", slide, slide},
  {"amplitude_right_deg",   "deg",    &Operation::amplitude_right,         between(0.0, 1e5),    "rocks the string so far clockwise; slide: 0, it does not rock", no_kind, rocks},
  {"amplitude_left_deg",    "deg",    &Operation::amplitude_left,          between(0.0, 1e5),    "and so far counterclockwise", no_kind, rocks},
  {"times",                 "",       &Operation::times,                   between(1, 1000),     "up and down again", no_kind, ream},
  {"to_depth",              "m",      &Operation::to_depth,                between(0.0, 20000.0), "end: measured depth, of the bit; of the hole for drill and slide", no_kind, moves | drills, "none"},
  {"distance",              "m",      &Operation::distance,                above(0.0, 20000.0),  "end: travel of the block; of drill and slide metres of new hole; of ream each stroke", ream, moves | drills | ream, "none"},
  {"time",                  "s",      &Operation::time,                    between(0.0, 1e7),    "end: since its beginning; of flow and rotate since the ramp was over, 0 by default", wait, lasts, "none"},
  {"overpull",              "N",      &Operation::overpull,                above(0.0, 5e6),      "end: hook load above that at the beginning", no_kind, pick_up, "none"},
}};
// clang-format on

const char* word_of(OperationKind kind) noexcept
{
  return operation_words[static_cast<std::size_t>(kind)];
}

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
