// SPDX-License-Identifier: BSD-3-Clause
// The triple buffer: the latest value wins, each is read once, and under two threads none is torn or out of order.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <thread>

#include "drill_rig_sim/realtime/triple_buffer.h"

namespace drill_rig_sim::test_realtime_triple_buffer
{
TEST(TripleBuffer, isEmptyUntilSomethingIsWritten)
{
  TripleBuffer<int> buffer;
  EXPECT_EQ(nullptr, buffer.read());
}

TEST(TripleBuffer, theLatestWinsAndIsReadOnce)
{
  TripleBuffer<int> buffer;
  for (int i = 1; i <= 5; ++i) buffer.write(i);
  const int* read = buffer.read();
  ASSERT_NE(nullptr, read);
  EXPECT_EQ(5, *read);
  EXPECT_EQ(nullptr, buffer.read());
  buffer.write(6);
  read = buffer.read();
  ASSERT_NE(nullptr, read);
  EXPECT_EQ(6, *read);
}

TEST(TripleBuffer, whatIsBeingReadIsNotOverwritten)
{
  TripleBuffer<int> buffer;
  buffer.write(1);
  const int* read = buffer.read();
  for (int i = 2; i <= 9; ++i) buffer.write(i);
  EXPECT_EQ(1, *read);
  EXPECT_EQ(9, *buffer.read());
}

TEST(TripleBuffer, underTwoThreadsValuesAreWholeAndOnlyGrow)
{
  constexpr long last = 300000;
  using Value = std::array<long, 16>;
  TripleBuffer<Value> buffer;
  std::thread writer(
      [&]
      {
        Value v;
        for (long i = 1; i <= last; ++i)
        {
          v.fill(i);
          buffer.write(v);
        }
      });
  long seen = 0;
  bool whole = true, grows = true;
  while (seen < last)
  {
    const Value* v = buffer.read();
    if (v == nullptr)
    {
      std::this_thread::yield();
      continue;
    }
    whole = whole && std::all_of(v->begin(), v->end(), [&](long x) { return x == v->front(); });
    grows = grows && v->front() > seen;
    seen = std::max(seen, v->front());
  }
  writer.join();
  EXPECT_TRUE(whole);
  EXPECT_TRUE(grows);
  EXPECT_EQ(nullptr, buffer.read()) << "the last value is read once";
}

}  // namespace drill_rig_sim::test_realtime_triple_buffer
