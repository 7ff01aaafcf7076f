// SPDX-License-Identifier: BSD-3-Clause
// Names and priorities of threads; what a machine does not permit is told in one line.
#include <gtest/gtest.h>
#include <pthread.h>
#include <sched.h>

#include <string>
#include <thread>

#include "drill_rig_sim/realtime/threads.h"

namespace test_realtime_threads
{
using namespace drill_rig_sim;

TEST(Threads, haveNames)
{
  std::thread(
      []
      {
        char name[16] = {};
        name_thread("simulation");
        pthread_getname_np(pthread_self(), name, sizeof name);
        EXPECT_STREQ(name, "simulation");
      })
      .join();
}

TEST(Threads, areLeftAloneByDefault)
{
  EXPECT_FALSE(RealtimeSpec().any());
  EXPECT_EQ(try_realtime(RealtimeSpec()), "");
  std::thread(
      []
      {
        EXPECT_TRUE(prioritise_thread(0, -1));
        EXPECT_EQ(sched_getscheduler(0), SCHED_OTHER);
      })
      .join();
}

// Whether the machine that runs this permits it or not.
TEST(Threads, getTheirPriorityOrSayWhyNot)
{
  const std::string problem = try_realtime({10, false, -1});
  std::thread(
      [&problem]
      {
        EXPECT_EQ(prioritise_thread(10, -1), problem.empty());
        EXPECT_EQ(sched_getscheduler(0), problem.empty() ? SCHED_FIFO : SCHED_OTHER);
      })
      .join();
  const bool told = problem.find("realtime/fifo_priority: the system does not permit it") != std::string::npos;
  EXPECT_EQ(told, !problem.empty()) << problem;
  EXPECT_EQ(problem.find('\n'), std::string::npos);
}

TEST(Threads, stayOnTheirCoreOrSayWhyNot)
{
  cpu_set_t mine;
  CPU_ZERO(&mine);
  ASSERT_EQ(sched_getaffinity(0, sizeof mine, &mine), 0);
  int core = 0;
  while (!CPU_ISSET(core, &mine)) ++core;
  EXPECT_EQ(try_realtime({0, false, core}), "");
  const std::string problem = try_realtime({0, false, 100000});
  EXPECT_NE(problem.find("realtime/core"), std::string::npos);
  EXPECT_NE(problem.find("allowed"), std::string::npos);
}

// The others leave a core to the simulation, unless it is all they have.
TEST(Threads, leaveACoreWithThoseTheyStart)
{
  std::thread(
      []
      {
        cpu_set_t mine, left, all;
        sched_getaffinity(0, sizeof all, &all);
        int core = 0;
        while (!CPU_ISSET(core, &all)) ++core;
        leave_core(core);
        sched_getaffinity(0, sizeof mine, &mine);
        std::thread([&left] { sched_getaffinity(0, sizeof left, &left); }).join();
        EXPECT_EQ(CPU_COUNT(&all) > 1 ? CPU_COUNT(&all) - 1 : 1, CPU_COUNT(&mine));
        EXPECT_EQ(CPU_COUNT(&all) > 1, !CPU_ISSET(core, &mine));
        EXPECT_TRUE(CPU_EQUAL(&mine, &left));
        leave_core(-1);
        sched_getaffinity(0, sizeof left, &left);
        EXPECT_TRUE(CPU_EQUAL(&mine, &left));
        EXPECT_TRUE(prioritise_thread(0, core)) << "whose core it is may go there still";
        sched_getaffinity(0, sizeof left, &left);
        EXPECT_TRUE(CPU_ISSET(core, &left));
      })
      .join();
}
}  // namespace test_realtime_threads
