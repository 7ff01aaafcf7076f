// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_TEST_RUNNING_LOOP_H
#define DRILL_RIG_SIM_TEST_RUNNING_LOOP_H

#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <thread>
#include <vector>

#include "drill_rig_sim/realtime/frame_ring.h"
#include "drill_rig_sim/ros/mailbox.h"
#include "drill_rig_sim/ros/simulation_loop.h"
#include "test_scenes.h"

namespace drill_rig_sim
{
constexpr std::int64_t ms = 1'000'000, period = 10 * ms;  // [ns]; 100 frames a second

inline Parameters lockstep()
{
  Parameters p;
  p.clock = ClockMode::lockstep;
  return p;
}

inline Parameters in_real_time()
{
  return {};
}

inline WinchCommand winch(double velocity)
{
  WinchCommand c;
  c.block_velocity = velocity;
  return c;
}

inline MudPumpCommand flow(double rate)
{
  MudPumpCommand c;
  c.flow = rate;
  return c;
}

/// A simulation loop with a thread that takes what it hands over, in order, and keeps it.
class RunningLoop
{
public:
  explicit RunningLoop(const Parameters& p, const Scene& scene = vertical_scene(30.0, 29.0))
      : parameters_(p), loop(parameters_, std::make_unique<Simulator>(scene), mailbox, ring), reader_([this] { read(); })
  {
  }
  ~RunningLoop()
  {
    loop.halt();
    loop.join();
    ring.close();
    reader_.join();
  }

  /// Begins; what the start hands over.
  FrameOutput start()
  {
    loop.start();
    return output(0);
  }

  /// Lockstep: what this number of frames hands over.
  std::vector<FrameOutput> step(std::uint32_t frames)
  {
    std::uint64_t before = 0;
    loop.between_frames(
        [&](SimulationLoop& l)
        {
          before = ring.handed_over();
          l.begin_step(frames);
        });
    result = loop.wait_for_step();
    std::vector<FrameOutput> all;
    for (std::uint64_t i = before; i < result.handed_over; ++i) all.push_back(output(i));
    return all;
  }

  /// The i-th that was handed over; waits for it.
  FrameOutput output(std::size_t i)
  {
    std::unique_lock<std::mutex> lock(mutex_);
    const bool came = arrived_.wait_for(lock, std::chrono::seconds(60), [&] { return outputs_.size() > i; });
    if (!came) throw std::runtime_error("nothing is handed over");
    return outputs_[i];
  }

  /// How many were handed over by now, while the loop stands between two frames.
  std::size_t count()
  {
    std::size_t all = 0;
    loop.between_frames([&](SimulationLoop&) { all = ring.handed_over(); });
    return all;
  }

  /// What `act` hands over between two frames, first of all.
  template <class Act>
  FrameOutput between(Act act)
  {
    std::size_t first = 0;
    loop.between_frames(
        [&](SimulationLoop& l)
        {
          first = ring.handed_over();
          act(l);
        });
    return output(first);
  }

private:
  Parameters parameters_;

public:
  Mailbox mailbox;
  FrameRing ring;
  SimulationLoop loop;
  StepResult result;  ///< of the last step()

private:
  void read()
  {
    while (const FrameOutput* s = ring.next())
    {
      {
        const std::lock_guard<std::mutex> lock(mutex_);
        outputs_.push_back(*s);
      }
      ring.release();
      arrived_.notify_all();
    }
  }

  std::mutex mutex_;
  std::condition_variable arrived_;
  std::vector<FrameOutput> outputs_;
  std::thread reader_;
};

}  // namespace drill_rig_sim

#endif
