// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/instruments/downlink.h"

#include <algorithm>
#include <cmath>

#include "drill_rig_sim/math/units.h"

namespace drill_rig_sim
{
namespace
{
constexpr int directions = 16, most_tenths = 10;

int parity_of(int number) noexcept
{
  int ones = 0;
  for (; number != 0; number >>= 1) ones += number & 1;
  return ones & 1;
}
}  // namespace

std::optional<SteeringSetpoint> DownlinkReceiver::hear(double time, double flow, double bit_time) noexcept
{
  if (heard_ < 0)
  {
    high_ = std::max(high_, flow);
    if (flow >= low * high_ || time < deaf_until_) return {};
    if (flow < stopped * high_)
    {
      high_ = flow;  // the pump stops: no downlink
      return {};
    }
    began_ = time;
    heard_ = word_ = 0;
  }
  if (time < began_ + (heard_ + 0.5) * bit_time) return {};
  const bool is_one = flow < low * high_;
  word_ = 2 * word_ + (is_one ? 1 : 0);
  ++heard_;
  const bool broken = flow < stopped * high_ || (heard_ == 1 && !is_one);
  if (heard_ < bits && !broken) return {};
  heard_ = -1;
  if (is_one || broken) high_ = flow;  // it has changed for good
  if (broken) deaf_until_ = time + bits * bit_time;
  return broken ? std::nullopt : decode();
}

std::optional<SteeringSetpoint> DownlinkReceiver::decode() const noexcept
{
  const int stop = word_ & 1, parity = (word_ >> 1) & 1, data = (word_ >> 2) & 0xff;
  const int tenths = data & 0xf;
  if (stop != 0 || parity != parity_of(data) || tenths > most_tenths) return {};
  return SteeringSetpoint{(data >> 4) * toolface_step, tenths * ratio_step};
}

bool DownlinkReceiver::is_low(const SteeringSetpoint& command, int i) noexcept
{
  const long turns = std::lround(command.toolface / toolface_step) % directions;
  const int direction = static_cast<int>(turns < 0 ? turns + directions : turns);
  const int tenths = std::clamp(static_cast<int>(std::lround(command.ratio / ratio_step)), 0, most_tenths);
  const int data = direction << 4 | tenths;
  const int word = 1 << (bits - 1) | data << 2 | parity_of(data) << 1;
  return i >= 0 && i < bits && ((word >> (bits - 1 - i)) & 1) != 0;
}

}  // namespace drill_rig_sim
