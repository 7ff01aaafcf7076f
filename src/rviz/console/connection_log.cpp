// SPDX-License-Identifier: BSD-3-Clause
#include "connection_log.h"

#include <cmath>

namespace drill_rig_sim::console
{
namespace
{
constexpr double lasts = 3.0, gap = 5.0;  // [s]
}

void ConnectionLog::begin(const PipeWork& now)
{
  open_.reset();
  slips_since_ = drills_since_ = drilled_at_ = missing;
  if (last_ && now.time < last_->time) number_ = 0;
}

std::optional<Connection> ConnectionLog::take(const PipeWork& now)
{
  if (last_ && (now.time < last_->time || now.time - last_->time > gap)) begin(now);
  if (last_ && now.time == last_->time) return {};
  const std::optional<Connection> made = take_slips(now), drills = take_drilling(now);
  last_ = now;
  return made ? made : drills;
}

std::optional<Connection> ConnectionLog::take_slips(const PipeWork& now)
{
  const bool was_in_slips = last_ && last_->in_slips;
  if (now.in_slips && !was_in_slips && last_)
  {
    slips_since_ = now.time;
    stands_ = now.stand_count;
  }
  if (now.in_slips || !was_in_slips || !std::isfinite(slips_since_)) return {};
  const double time = now.time - slips_since_;
  slips_since_ = missing;
  if (now.stand_count <= stands_) return {};
  open_ = Connection{++number_, time, missing};
  return open_;
}

std::optional<Connection> ConnectionLog::take_drilling(const PipeWork& now)
{
  if (!now.drills)
  {
    drills_since_ = missing;
    return {};
  }
  if (!std::isfinite(drills_since_)) drills_since_ = now.time;
  if (now.time - drills_since_ < lasts) return {};
  std::optional<Connection> done;
  if (open_ && std::isfinite(drilled_at_))
  {
    done = open_;
    done->weight_to_weight = drills_since_ - drilled_at_;
  }
  open_.reset();
  drilled_at_ = now.time;
  return done;
}

}  // namespace drill_rig_sim::console
