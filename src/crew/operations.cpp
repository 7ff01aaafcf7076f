// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/crew/operations.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "drill_rig_sim/crew/rig_controls.h"
#include "drill_rig_sim/instruments/zero_mean.h"
#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/rig/drive_reference.h"
#include "drill_rig_sim/rig/hoisting.h"
#include "drill_rig_sim/scene/scene_mesh.h"

namespace drill_rig_sim
{
namespace
{
constexpr double arrived = 0.01;  // from where a trip ends [m]

/// 1 once `value` has come from `from` to `to`.
double share(double value, double from, double to) noexcept
{
  if (to == from) return 1.0;
  return std::clamp((value - from) / (to - from), 0.0, 1.0) + 0.0;  // no -0
}

/// All pipe between bit and shaft, and the lines at the start's block height.
HookedString string_of(const Scene& scene)
{
  const double height = scene.start.block_height;
  const HungString hung(build_mesh(scene, scene.start.bit_depth + height), scene.rig.hoisting, height);
  return {1.0 / (1.0 / hung.stiffness + 1.0 / hung.lines), hung.mass + scene.rig.hoisting.block_mass,
          ZeroMean::mean_time(hung.ring_period(scene.rig.hoisting.block_mass))};
}

/// Whether an operation raises the block, that began with the bit at a depth [m MD].
bool goes_up(const Operation& o, double began_bit) noexcept
{
  return o.kind == OperationKind::pick_up || (o.kind == OperationKind::trip && o.to_depth < began_bit) || o.remove == 1.0;
}

/// The least turn that leads from one direction to another [rad].
double turn_between(double from, double to) noexcept
{
  return std::remainder(to - from, 2.0 * pi);
}
}  // namespace

std::string text_of(const HungUp& hung_up)
{
  if (hung_up.number == 0) return "";
  char text[120];
  std::snprintf(text, sizeof text, "number %d, tag, ended %.2f m above the bottom: drag or an obstacle took its weight",
                hung_up.number, hung_up.above);
  return text;
}

std::size_t operations_over(const std::vector<double>& began) noexcept
{
  std::size_t over = 0;
  while (over + 1 < began.size() && is_set(began[over + 1])) ++over;
  return over;
}

double WeightFeed::velocity(double weight, double wanted, double stiffness, double most, double duration) noexcept
{
  const double held = 1.0 / (stiffness * learn_time);  // without a derivative: the lag of dW/dt is W less its own
  if (!begun) *this = {weight * held, weight, true};
  const double rop = std::max(0.0, rate - weight * held);
  const double least = mean_weight > felt * wanted ? 0.25 : 1.0;  // of what is wanted: a bit that runs off bottom gives way too
  const double drillability = rop / std::max(mean_weight, least * wanted);
  const double down = std::clamp(drillability * wanted + (wanted - weight) / (stiffness * feed_time), 0.0, most);
  const double share = std::min(1.0, duration / learn_time);
  rate += share * (down - (rate - weight * held));
  mean_weight += share * (weight - mean_weight);
  return -down;
}

OperationsPlayer::OperationsPlayer(const Scene& scene)
    : operations_(scene.operations),
      acceleration_(scene.rig.hoisting.max_acceleration),
      wave_period_(scene.rig.heave.wave_period()),
      began_(operations_.size() + 1, Operation::unset),
      watch_(scene)
{
  if (!operations_.empty()) string_ = string_of(scene);
}

void OperationsPlayer::rewind() noexcept
{
  next_ = 0;
  trouble_ = OperationTrouble::none;
  hung_up_ = HungUp();
  pressure_ = PressureTrend();
  std::fill(began_.begin(), began_.end(), Operation::unset);
}

OperationStatus OperationsPlayer::status() const noexcept
{
  OperationStatus status;
  status.count = static_cast<int>(operations_.size());
  status.hung_up = hung_up_;
  if (finished()) return status;
  status.number = static_cast<int>(next_) + 1;
  status.kind = operations_[next_].kind;
  status.progress = progress_;
  status.trouble = trouble_;
  return status;
}

void OperationsPlayer::apply(RigControls& rig) noexcept
{
  if (trouble_ != OperationTrouble::none) return;  // what is to be done now is the driller's decision
  pressure_.take(rig.readings().stand_pipe_pressure, rig.readings().time);
  if (rig.truth().crew != CrewTask::none)
  {
    feed_ = WeightFeed();  // the crew has the rig, and zeroes the weight
    approach_ = BottomApproach();
    zeroes_ = false;
    crew_came_ = true;
    // a stroke goes on with a stand more or less: its way is that of the bit
    began_block_ = rig.readings().block_height - (began_bit_ - rig.readings().bit_depth);
    watch_.begin(rig.truth().time);
    followed_at_ = rig.truth().time;
    return;
  }
  while (!finished())
  {
    if (!is_set(began_[next_])) begin(rig);
    if (trouble_ == OperationTrouble::none) trouble_ = watch_.look(operations_[next_], rig.readings());
    if (trouble_ == OperationTrouble::none) follow(rig);
    if (trouble_ != OperationTrouble::none) return stop(rig);
    progress_ = progress(rig);
    if (progress_ < 1.0) return;
    note_hang_up(rig.readings());
    end(rig);
    ++next_;
    if (finished()) began_[next_] = rig.truth().time;
  }
}

void OperationsPlayer::stop(RigControls& rig) const noexcept
{
  if (!finished()) end(rig);
}

void OperationsPlayer::begin(RigControls& rig) noexcept
{
  const Operation& o = operations_[next_];
  const Readings& now = rig.readings();
  began_[next_] = followed_at_ = now.time;
  began_bit_ = now.bit_depth;
  began_hole_ = now.hole_depth;
  began_block_ = now.block_height;
  began_load_ = now.hook_load;
  feed_ = WeightFeed();
  approach_ = BottomApproach();
  watch_.begin(now.time);
  legs_ = 0;
  crew_came_ = false;
  const TopDriveSetpoint drive = rig.asked().top_drive;
  if (o.kind == OperationKind::flow) ramp_ = {rig.asked().pump.flow, o.flow, now.time, o.ramp, true};
  if (o.kind == OperationKind::rotate)
    ramp_ = {keeps_speed(drive.mode) ? drive.speed : now.top_drive_speed, o.rotary_speed, now.time, o.ramp, true};
  if (o.kind == OperationKind::pick_up) rig.command(WinchSetpoint{o.speed, false});
  if (needs_crew(o.kind)) rig.call_crew(true);
  if (o.kind == OperationKind::trip && o.to_depth > now.hole_depth + arrived) trouble_ = OperationTrouble::below_bottom;
  if (o.kind == OperationKind::slack_off || o.kind == OperationKind::tag)
  {
    const bool zeroed = is_set(o.weight) && rig.tare();  // on bottom it keeps the zero it had
    if (o.kind == OperationKind::tag) begin_tag(rig, zeroed);
    if (o.kind == OperationKind::slack_off) rig.command(WinchSetpoint{-o.speed, false});
  }
  const bool by_weight = traits_of(o.kind).drills;
  zeroes_ = by_weight && !now.tared;
  if (zeroes_ && !rig.tare()) trouble_ = OperationTrouble::no_zero;
  if (o.kind == OperationKind::steer) rig.command(SteeringSetpoint{o.toolface, o.ratio});
  if (o.kind == OperationKind::slide || o.kind == OperationKind::oscillate)
  {
    angle_ = now.top_drive_angle;
    turned_at_ = now.time - toolface_settles;
    toolface_seen_ = 0;
    follow_toolface(rig);
  }
}

void OperationsPlayer::begin_tag(RigControls& rig, bool zeroed) noexcept
{
  const Operation& o = operations_[next_];
  const Readings& now = rig.readings();
  const bool heaves = wave_period_ > 0.0;
  const TagTask task{o.speed, is_set(o.weight) ? o.weight : 0.0, string_.mean_time, heaves ? tag_settles + wave_period_ : 0.0,
                     zeroed && !heaves};
  tag_.begin(now, task);
  if (!zeroed && !now.tared) trouble_ = OperationTrouble::tag_on_bottom;
}

void OperationsPlayer::follow(RigControls& rig) noexcept
{
  using Follow = void (OperationsPlayer::*)(RigControls&) noexcept;
  static constexpr Follow follow_of_kind[] = {
#define OPERATION(name, moves, drills, by_crew, follow) &OperationsPlayer::follow,
#include "drill_rig_sim/scene/operation_list.h"
  };
  (this->*follow_of_kind[static_cast<std::size_t>(operations_[next_].kind)])(rig);
}

void OperationsPlayer::follow_nothing(RigControls& /*rig*/) noexcept
{
}

void OperationsPlayer::follow_slide(RigControls& rig) noexcept
{
  follow_toolface(rig);
  follow_weight(rig);
}

void OperationsPlayer::follow_ramp(RigControls& rig) noexcept
{
  if (!ramp_.running) return;
  const double now = rig.truth().time, value = ramp_.value(now);
  ramp_.running = !ramp_.over(now);
  if (operations_[next_].kind == OperationKind::flow)
  {
    rig.command(PumpSetpoint{value});
    return;
  }
  TopDriveSetpoint drive = rig.asked().top_drive;
  if (!keeps_speed(drive.mode)) drive.mode = TopDriveMode::speed;
  drive.brake = false;
  drive.speed = value;
  rig.command(drive);
}

void OperationsPlayer::follow_weight(RigControls& rig) noexcept
{
  const Operation& o = operations_[next_];
  const Readings& now = rig.readings();
  const double duration = now.time - followed_at_;
  followed_at_ = now.time;
  if (!approach_.begun && zeroes_ && waits_for_pressure(now)) return static_cast<void>(rig.tare());
  if (!approach_.begun) approach_.begin(now, string_, o.weight, o.speed, zeroes_, rig.scene().rig.heave.amplitude > 0.0);
  if (approach_.goes_on(now, duration))
  {
    feed_ = WeightFeed();
    if (zeroes_) rig.tare();  // refused on bottom
    rig.command(WinchSetpoint{approach_.velocity(now, duration), false});
    return;
  }
  rig.command(WinchSetpoint{feed_.velocity(now.mean_surface_wob, o.weight, string_.stiffness, o.speed, duration), false});
}

/// How far the block still rises until it stands, if it is stopped or turned back now [m].
double OperationsPlayer::rise(const Readings& now) const noexcept
{
  return now.block_velocity * std::abs(now.block_velocity) / (2.0 * acceleration_);
}

void OperationsPlayer::follow_strokes(RigControls& rig) noexcept
{
  const Operation& o = operations_[next_];
  const double height = rig.readings().block_height + rise(rig.readings());
  const bool up = legs_ % 2 == 0;
  if (up ? height >= began_block_ + o.distance : height <= began_block_) ++legs_;
  rig.command(WinchSetpoint{legs_ % 2 == 0 ? o.speed : -o.speed, false});
}

void OperationsPlayer::follow_tag(RigControls& rig) noexcept
{
  const Readings& now = rig.readings();
  const bool refused = tag_.zeroes() && !rig.tare();
  const WinchSetpoint winch{tag_.velocity(now, refused, rise(now), waits_for_pressure(now)), false};
  if (!(winch == rig.asked().winch)) rig.command(winch);
}

/// The hook load follows the pressure of the mud: while that changes, so does the zero of the weight.
bool OperationsPlayer::waits_for_pressure(const Readings& now) const noexcept
{
  return !pressure_.is_steady() && now.time < began_[next_] + tag_settles + wave_period_ + pressure_settles - time_rounding;
}

/// How far the bit still goes: to a trip's depth; without one as far as the hole [m].
double OperationsPlayer::way_to_go(const Readings& now) const noexcept
{
  const Operation& o = operations_[next_];
  if (goes_up(o, began_bit_)) return now.bit_depth - (is_set(o.to_depth) ? o.to_depth : 0.0);
  return (is_set(o.to_depth) ? o.to_depth : now.hole_depth) - now.bit_depth;
}

/// The block runs no faster than it can still be stopped from after another frame h: v h + v^2/(2 a) = what is left.
void OperationsPlayer::follow_trip(RigControls& rig) noexcept
{
  const Operation& o = operations_[next_];
  const Readings& now = rig.readings();
  const HoistingSpec& hoisting = rig.scene().rig.hoisting;
  const bool up = goes_up(o, began_bit_), has_begun = now.time > began_[next_];
  const bool is_high = now.block_height > 0.5 * (hoisting.lowest_block_height + hoisting.highest_block_height);
  const double left = std::max(0.0, way_to_go(now)), lost = acceleration_ * (now.time - followed_at_);
  followed_at_ = now.time;
  if (has_begun && now.stop_reached && up == is_high)
    trouble_ = up ? OperationTrouble::nothing_to_take : OperationTrouble::no_room_to_add;
  if (has_begun && o.kind == OperationKind::connection && !crew_came_ && !up && left < arrived)
    trouble_ = OperationTrouble::bottom_too_near;
  if (trouble_ != OperationTrouble::none) return;
  const double speed = std::min(o.speed, std::sqrt(lost * lost + 2.0 * acceleration_ * left) - lost);
  rig.command(WinchSetpoint{up ? speed : -speed, false});
}

void OperationsPlayer::follow_toolface(RigControls& rig) noexcept
{
  const Operation& o = operations_[next_];
  const ToolfaceReading& toolface = rig.readings().toolface;
  const bool is_new = toolface.sequence != toolface_seen_ && toolface.time >= turned_at_ + toolface_settles;
  if (o.kind == OperationKind::slide && toolface.sequence > 0 && is_new)
  {
    toolface_seen_ = toolface.sequence;
    angle_ += turn_between(toolface.toolface, o.toolface);
    turned_at_ = rig.truth().time;
  }
  TopDriveSetpoint drive = rig.asked().top_drive;
  const bool rocks = o.amplitude_right + o.amplitude_left > 0.0;
  drive.mode = rocks ? TopDriveMode::oscillate : TopDriveMode::angle;
  drive.brake = false;
  drive.speed = o.rotary_speed;
  drive.angle = angle_;
  drive.amplitude_right = o.amplitude_right;
  drive.amplitude_left = o.amplitude_left;
  if (!(drive == rig.asked().top_drive)) rig.command(drive);
}

void OperationsPlayer::note_hang_up(const Readings& now) noexcept
{
  const double above = now.hole_depth - now.bit_depth;
  if (operations_[next_].kind == OperationKind::tag && above > hangs_up) hung_up_ = {static_cast<int>(next_) + 1, above};
}

void OperationsPlayer::end(RigControls& rig) const noexcept
{
  const OperationTraits& traits = traits_of(operations_[next_].kind);
  if (traits.by_crew) rig.call_crew(false);
  if (traits.moves) rig.command(WinchSetpoint{0.0, true});
}

double OperationsPlayer::progress(const RigControls& rig) const noexcept
{
  const Operation& o = operations_[next_];
  const Readings& now = rig.readings();
  if (o.kind == OperationKind::flow || o.kind == OperationKind::rotate)
  {
    const double lasts = o.ramp + (is_set(o.time) ? o.time : 0.0);
    return lasts > 0.0 ? share(now.time + time_rounding, began_[next_], began_[next_] + lasts) : 1.0;
  }
  if (o.kind == OperationKind::steer || (o.kind == OperationKind::oscillate && !is_set(o.time))) return 1.0;
  double nearest = progress_in_place(rig);
  if (is_set(o.time))
    nearest = std::max(nearest, o.time > 0.0 ? share(now.time + time_rounding, began_[next_], began_[next_] + o.time) : 1.0);
  if (is_set(o.overpull)) nearest = std::max(nearest, share(now.hook_load, began_load_, began_load_ + o.overpull));
  const bool by_weight = o.kind == OperationKind::slack_off || (o.kind == OperationKind::tag && tag_.counts());
  if (by_weight && is_set(o.weight)) nearest = std::max(nearest, share(now.mean_surface_wob, 0.0, o.weight));
  return nearest;
}

double OperationsPlayer::progress_in_place(const RigControls& rig) const noexcept
{
  const Operation& o = operations_[next_];
  const Readings& now = rig.readings();
  if (o.kind == OperationKind::ream)
  {
    const double height = now.block_height - began_block_, done = legs_ % 2 == 0 ? height : o.distance - height;
    return std::min((legs_ + std::clamp(done / o.distance, 0.0, 0.99)) / (2.0 * o.times), 1.0);
  }
  const bool drills = traits_of(o.kind).drills;
  const double from = drills ? began_hole_ : began_bit_, here = drills ? now.hole_depth : now.bit_depth - rise(now);
  if (o.kind == OperationKind::connection) return crew_came_ ? 1.0 : 0.0;
  if (o.kind == OperationKind::trip) return way_to_go(now) < arrived ? 1.0 : share(now.bit_depth, began_bit_, o.to_depth);
  double nearest = 0.0;
  if (is_set(o.to_depth))
    nearest = (o.kind == OperationKind::pick_up ? here <= o.to_depth : here >= o.to_depth) ? 1.0 : share(here, from, o.to_depth);
  if (is_set(o.distance))
    nearest = std::max(nearest, std::abs((drills ? here - from : now.block_height + rise(now) - began_block_) / o.distance));
  return std::min(nearest, 1.0);
}

}  // namespace drill_rig_sim
