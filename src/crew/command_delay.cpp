// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/crew/command_delay.h"

#include <algorithm>

#include "drill_rig_sim/math/units.h"

namespace drill_rig_sim
{
namespace
{
constexpr std::size_t samples = 400;  // in the longest dead time
constexpr double long_ago = -1e30;    // [s]
}  // namespace

CommandDelay::CommandDelay(double plc, double drawworks)
    : plc_(plc), drawworks_(drawworks), spacing_((plc + drawworks) / static_cast<double>(samples))
{
  if (!is_on()) return;
  line_.resize(samples + 2);
  line_[0].time = long_ago;
  next_ = held_ = 1;
}

void CommandDelay::take(const Setpoints& given, double now) noexcept
{
  if (!is_on()) return;
  const std::size_t newest = (next_ + line_.size() - 1) % line_.size();
  if (now < line_[newest].time + spacing_ - time_rounding)
  {
    line_[newest].given = given;  // frames shorter than the steps of a long dead time
  }
  else
  {
    line_[next_] = {now, given};
    next_ = (next_ + 1) % line_.size();
    held_ = std::min(held_ + 1, line_.size());
  }
  passed_ = given_before(now - plc_);
  passed_.winch = given_before(now - plc_ - drawworks_).winch;
}

const Setpoints& CommandDelay::given_before(double time) const noexcept
{
  std::size_t back = 1;
  const auto at = [this](std::size_t k) -> const Sample& { return line_[(next_ + line_.size() - k) % line_.size()]; };
  while (back < held_ && at(back).time > time + time_rounding) ++back;
  return at(back).given;
}

}  // namespace drill_rig_sim
