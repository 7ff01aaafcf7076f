// SPDX-License-Identifier: BSD-3-Clause
#include "drill_progress.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <string>

namespace drill_rig_sim
{
Progress::Progress() : terminal_(isatty(STDERR_FILENO) == 1), begin_(Clock::now()), next_(begin_)
{
}

Progress::~Progress()
{
  // leave a clean line for the next writer
  if (drawn_) std::fputs("\r\033[K", stderr);
}

void Progress::show(double fraction, double time, double hole_depth)
{
  if (!terminal_) return;
  const Clock::time_point now = Clock::now();
  if (now < next_) return;
  next_ = now + std::chrono::milliseconds(100);
  constexpr int width = 30;
  const int filled = static_cast<int>(width * std::min(1.0, std::max(0.0, fraction)));
  const std::string bar =
      std::string(static_cast<std::size_t>(filled), '#') + std::string(static_cast<std::size_t>(width - filled), '.');
  const double wall = std::chrono::duration<double>(now - begin_).count();
  std::fprintf(stderr, "\r[%s] %8.1f s  hole %9.3f m  %6.1fx real time\033[K", bar.c_str(), time, hole_depth,
               wall > 0.0 ? time / wall : 0.0);
  std::fflush(stderr);
  drawn_ = true;
}

}  // namespace drill_rig_sim
