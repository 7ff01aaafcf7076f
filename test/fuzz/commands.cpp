// SPDX-License-Identifier: BSD-3-Clause
// Fuzz target: bytes as orders to a small rig on bottom: set points, frames, tares, faults, snapshots taken and gone back to.
// Everything reported stays finite, and the same orders from the same start lead to the same bits.
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "../unit/test_scenes.h"
#include "counters.h"
#include "drill_rig_sim/sim/simulator.h"
#include "shown.h"

namespace drill_rig_sim
{
namespace fuzz
{
namespace
{
constexpr int most_frames = 40;

/// Reads the input; zeros after its end.
class Orders
{
public:
  Orders(const std::uint8_t* data, std::size_t size) : next_(data), end_(data + size) {}
  bool finished() const { return next_ == end_; }
  unsigned byte() { return finished() ? 0u : *next_++; }
  /// One byte: -scale .. scale in steps, or one that is never right.
  double number(double scale)
  {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
    constexpr double most = std::numeric_limits<double>::max(), least = std::numeric_limits<double>::denorm_min();
    constexpr std::array<double, 10> wild = {nan, infinity, -infinity, most, -most, least, -least, 1e9, -1e9, -0.0};
    const unsigned code = byte();
    return code < 200 ? scale * (static_cast<double>(code) - 100.0) / 100.0 : wild[code % wild.size()];
  }

private:
  const std::uint8_t* next_;
  const std::uint8_t* end_;
};

/// A bit, a bent motor, an mwd and pipe in a short inclined hole; the bit a centimetre above the bottom, noisy gauges.
Scene small_scene()
{
  Scene scene = scene_in({{0.0, 0.0, 0.0}, {15.0, 4.0 * degree, 1.0}, {40.0, 10.0 * degree, 1.0}}, 40.0, 39.99, 0.25);
  scene.string = {bit_part(0.2159), motor_part(), mwd_part(), pipe_part(0, 9.5, tool_jointed_mass)};
  scene.string[0].bit->side_cutting = 0.1;
  scene.start.block_height = 12.0;
  scene.contact.static_ratio = 1.2;
  scene.instruments.hook_load = {100.0, 5.0, 0.05, 0.1};
  scene.instruments.mwd = {0.2, 0.1, 0.0, 1e-3, 0.0};
  scene.instruments.toolface = {0.1, 0.05};
  return scene;
}

/// Carries out orders, one after the other.
class Driller
{
public:
  explicit Driller(Simulator& rig) : rig_(rig), saved_(rig.save()) {}

  void obey(Orders orders)
  {
    while (!orders.finished() && frames_ < most_frames) one(orders);
    check_signals(rig_);
    check_reports(rig_);
  }
  bool failed() const { return failed_; }

private:
  void one(Orders& orders)
  {
    switch (orders.byte() % 16)
    {
      case 0:
        rig_.command(WinchSetpoint{orders.number(1.0), orders.byte() % 4 == 0});
        break;
      case 1:
        drive(orders);
        break;
      case 2:
        rig_.command(PumpSetpoint{orders.number(0.06)});
        break;
      case 3:
        saved_ = rig_.save();
        break;
      case 4:
        rig_.restore(*saved_);
        break;
      case 5:
        rig_.tare();
        break;
      case 6:
        rig_.stick_pipe(orders.number(50.0));
        break;
      case 7:
        rig_.free_pipe();
        break;
      case 8:
        rig_.set_command_timeout(orders.number(0.2));
        break;
      case 9:
        rig_.balance_energy(orders.byte() % 2 == 1);
        break;
      case 10:
        check_reports(rig_);
        break;
      case 11:
        fault(orders);
        break;
      case 12:
        rig_.clear(static_cast<FaultKind>(orders.byte() % fault_count), static_cast<Gauge>(orders.byte() % gauge_count));
        break;
      default:
        frame(static_cast<double>(1 + orders.byte() % 4));
        break;
    }
  }

  /// Of any kind, by anything from a thousandth to ten million.
  void fault(Orders& orders)
  {
    Fault fault;
    fault.kind = static_cast<FaultKind>(orders.byte() % fault_count);
    fault.gauge = static_cast<Gauge>(orders.byte() % gauge_count);
    fault.depth = orders.number(50.0);
    fault.magnitude = orders.number(std::pow(10.0, orders.byte() % 11 - 3.0));
    rig_.inject(fault);
  }

  void drive(Orders& orders)
  {
    TopDriveSetpoint c;
    c.mode = static_cast<TopDriveMode>(orders.byte() % (top_drive_mode_count + 1));
    c.speed = orders.number(20.0);
    c.torque = orders.number(3e4);
    c.torque_limit = orders.number(3e4);
    if (is_known(c.mode) && turns_to_angle(c.mode)) c.angle = orders.number(20.0);
    if (is_known(c.mode) && goal_of(c.mode) == DriveGoal::swing)
    {
      c.amplitude_right = orders.number(10.0);
      c.amplitude_left = orders.number(10.0);
    }
    rig_.command(c);
  }

  void frame(double steps)
  {
    ++frames_;
    const FrameStatus status = rig_.frame(steps * rig_.scene().numerics.step);
    failed_ = failed_ || status == FrameStatus::failed;
    check((status == FrameStatus::failed) == (rig_.failure()[0] != '\0'), "a frame's status and the failure's text disagree");
    check_signals(rig_);
    check(std::isfinite(rig_.energy().residual()), "the energy balance is not finite");
  }

  Simulator& rig_;
  std::shared_ptr<const SimulatorState> saved_;
  int frames_ = 0;
  bool failed_ = false;
};

void start_over(Simulator& rig, const SimulatorState& start)
{
  rig.restore(start);
  rig.set_command_timeout(0.0);
  rig.balance_energy(false);
}
}  // namespace

void take(const std::uint8_t* data, std::size_t size)
{
  static Simulator rig(small_scene());
  static const auto start = rig.save();
  const Orders orders(data, size);
  start_over(rig, *start);
  Driller first(rig);
  first.obey(orders);
  const std::vector<double> end = everything(rig);
  start_over(rig, *start);
  Driller(rig).obey(orders);
  check(bit_identical(everything(rig), end), "the same orders lead to other bits");
  ++counters().inputs;
  ++counters().accepted;
  if (first.failed()) ++counters().failed;
}
}  // namespace fuzz
}  // namespace drill_rig_sim

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  drill_rig_sim::fuzz::take(data, size);
  return 0;
}
