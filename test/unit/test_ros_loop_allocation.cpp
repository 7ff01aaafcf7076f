// SPDX-License-Identifier: BSD-3-Clause
// The simulation thread allocates nothing, with pictures, histograms and snapshots that find no room too: operator new is counted
// on it.
#include <gtest/gtest.h>
#include <pthread.h>

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <new>
#include <thread>

#include "drill_rig_sim/realtime/frame_ring.h"
#include "drill_rig_sim/ros/mailbox.h"
#include "drill_rig_sim/ros/simulation_loop.h"
#include "test_scenes.h"

namespace
{
std::atomic<long> allocations{0};

void* counted(std::size_t size, std::size_t alignment)
{
  char name[16] = {};
  pthread_getname_np(pthread_self(), name, sizeof name);
  if (std::strcmp(name, "simulation") == 0) ++allocations;
  if (void* p = std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment)) return p;
  throw std::bad_alloc();
}
}  // namespace

void* operator new(std::size_t size)
{
  return counted(size, alignof(std::max_align_t));
}
void* operator new(std::size_t size, std::align_val_t alignment)
{
  return counted(size, static_cast<std::size_t>(alignment));
}
void operator delete(void* p) noexcept
{
  std::free(p);
}
void operator delete(void* p, std::size_t) noexcept
{
  std::free(p);
}
void operator delete(void* p, std::align_val_t) noexcept
{
  std::free(p);
}
void operator delete(void* p, std::size_t, std::align_val_t) noexcept
{
  std::free(p);
}

namespace drill_rig_sim
{
TEST(Loop, itsThreadAllocatesNothing)
{
  Parameters p;
  p.clock = ClockMode::realtime;
  p.drillstring_rate = p.marker_rate = p.rate;
  Mailbox mailbox;
  FrameRing ring(8, 2);
  SimulationLoop loop(p, std::make_unique<Simulator>(vertical_scene(30.0, 29.0)), mailbox, ring);
  loop.subscriptions().profile = loop.subscriptions().markers = loop.subscriptions().tf = true;
  loop.start();
  LoopStatistics seen;
  const auto take = [&](int count)
  {
    for (int i = 0; i < count; ++i)
    {
      seen = ring.next()->frame.loop;
      ring.release();
    }
  };
  take(50);
  std::this_thread::sleep_for(std::chrono::milliseconds(200));  // twenty frames, room for eight, arrays for two
  take(30);
  loop.halt();
  loop.join();
  EXPECT_GT(seen.frame_times.number(), 60u);
  EXPECT_GT(seen.pictures_left_out, 0u);
  EXPECT_GT(seen.unpublished_frames, 0u);
  EXPECT_EQ(0, allocations);
}
}  // namespace drill_rig_sim
