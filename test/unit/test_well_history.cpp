// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "drill_rig_sim/math/visit.h"
#include "drill_rig_sim/well/history.h"

namespace drill_rig_sim::test_well_history
{
namespace
{
void push(History<double>& history, std::vector<double>& all, double value)
{
  history.push(value, value, 0.0, 0.0);
  all.push_back(value);
}

void expect_same(const History<double>& history, const std::vector<double>& all)
{
  ASSERT_EQ(history.count(), all.size());
  ASSERT_EQ(history.first(), all.size() > history.capacity() ? all.size() - history.capacity() : 0);
  for (std::size_t i = history.first(); i < history.count(); ++i) ASSERT_EQ(history[i], all[i]) << i;
}

TEST(History, KeepsTheLastEntries)
{
  History<double> history(8);
  std::vector<double> all;
  for (int i = 0; i < 30; ++i)
  {
    push(history, all, i);
    expect_same(history, all);
    EXPECT_EQ(history.back(), i);
  }
}

// Snapshots taken, run past and restored in any order, against plain vectors that keep everything.
TEST(History, AssignmentRestoresWhateverHappenedBetween)
{
  std::mt19937 random(5);
  for (int run = 0; run < 200; ++run)
  {
    std::vector<History<double>> histories(4, History<double>(8));
    std::vector<std::vector<double>> expected(4);
    for (int i = 0; i < 100; ++i)
    {
      const std::size_t a = random() % 4, b = random() % 4;
      if (random() % 3 == 0)
      {
        histories[a] = histories[b];
        expected[a] = expected[b];
      }
      else
      {
        for (unsigned k = random() % 6; k > 0; --k) push(histories[a], expected[a], random() % 100);
      }
      expect_same(histories[a], expected[a]);
      ASSERT_EQ(histories[a].hash() == histories[b].hash(), expected[a] == expected[b]);
    }
  }
}

TEST(History, CopiesKeepTheirCapacity)
{
  History<double> history(4);
  std::vector<double> all;
  push(history, all, 1.0);
  History<double> copy(history);
  for (int i = 0; i < 10; ++i) push(copy, all, i);
  expect_same(copy, all);
  History<double> wider(16);
  wider = copy;
  EXPECT_EQ(wider.capacity(), 4u);
  expect_same(wider, all);
}

TEST(History, BytesHoldTheEntriesStillHeld)
{
  for (const int pushed : {0, 3, 10})
  {
    History<double> history(4);
    std::vector<double> all;
    for (int i = 0; i < pushed; ++i) push(history, all, 1.5 * i);
    History<double> read(4);
    ASSERT_TRUE(from_bytes(to_bytes(history), read));
    expect_same(read, all);
    EXPECT_EQ(history.hash(), read.hash());
    push(history, all, 7.0);
    read.push(7.0, 7.0, 0.0, 0.0);
    expect_same(read, all);
    EXPECT_EQ(history.hash(), read.hash());
  }
}
}  // namespace
}  // namespace drill_rig_sim::test_well_history
