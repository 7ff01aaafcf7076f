// SPDX-License-Identifier: BSD-3-Clause
// The ring of frames: every frame in order, full and waiting for room, closed with frames still inside, two threads.
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>
#include <vector>

#include "drill_rig_sim/realtime/frame_ring.h"

namespace drill_rig_sim::test_realtime_ring
{
namespace
{
void write(FrameRing& ring, std::int64_t stamp)
{
  ring.claim()->frame.stamp = stamp;
  ring.hand_over();
}

std::int64_t read(FrameRing& ring)
{
  const FrameOutput* output = ring.next();
  const std::int64_t stamp = output == nullptr ? -1 : output->frame.stamp;
  if (output != nullptr) ring.release();
  return stamp;
}
}  // namespace

TEST(FrameRing, handsFramesOverInOrderRoundAndRound)
{
  FrameRing ring(3);
  for (std::int64_t i = 1; i <= 20; i += 2)
  {
    write(ring, i);
    write(ring, i + 1);
    EXPECT_EQ(i, read(ring));
    EXPECT_EQ(i + 1, read(ring));
  }
  EXPECT_EQ(20u, ring.handed_over());
}

TEST(FrameRing, isFullWhenEverySlotIsHandedOver)
{
  FrameRing ring(2);
  write(ring, 1);
  write(ring, 2);
  EXPECT_EQ(nullptr, ring.try_claim());
  EXPECT_EQ(2u, ring.handed_over()) << "what found no room is not counted as handed over";
  EXPECT_EQ(1, read(ring));
  FrameOutput* slot = ring.try_claim();
  ASSERT_NE(nullptr, slot);
  slot->frame.stamp = 3;
  ring.hand_over();
  EXPECT_EQ(2, read(ring));
  EXPECT_EQ(3, read(ring));
}

TEST(FrameRing, aSlotBeingReadIsNotGivenToTheWriter)
{
  FrameRing ring(1);
  write(ring, 1);
  const FrameOutput* output = ring.next();
  EXPECT_EQ(nullptr, ring.try_claim());
  EXPECT_EQ(1, output->frame.stamp);
  ring.release();
  EXPECT_NE(nullptr, ring.try_claim());
}

TEST(FrameRing, claimWaitsForRoom)
{
  FrameRing ring(1);
  write(ring, 1);
  std::atomic<bool> written{false};
  std::thread writer(
      [&]
      {
        write(ring, 2);
        written = true;
      });
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  EXPECT_FALSE(written);
  EXPECT_EQ(1, read(ring));
  EXPECT_EQ(2, read(ring));
  writer.join();
}

TEST(FrameRing, afterCloseWhatIsLeftIsReadThenNull)
{
  FrameRing ring(3);
  write(ring, 1);
  write(ring, 2);
  ring.close();
  EXPECT_EQ(1, read(ring));
  EXPECT_EQ(2, read(ring));
  EXPECT_EQ(nullptr, ring.next());
}

TEST(FrameRing, everySetOfArraysIsPreparedAndLentInTurn)
{
  FrameRing ring(8, 3);
  int prepared = 0;
  ring.with_every_set(
      [&](FrameArrays& set)
      {
        set.well.reserve(1000);
        ++prepared;
      });
  EXPECT_EQ(3, prepared);
  for (int turn = 0; turn < 7; ++turn)
  {
    FrameOutput* slot = ring.claim();
    EXPECT_EQ(0u, slot->well.capacity()) << "a frame that shows nothing needs no memory";
    ASSERT_TRUE(ring.lend_arrays(*slot, false));
    EXPECT_GE(slot->well.capacity(), 1000u);
    EXPECT_TRUE(slot->has_arrays);
    ring.hand_over();
    read(ring);
    EXPECT_FALSE(slot->has_arrays);
  }
}

TEST(FrameRing, whereAllArraysAreLentFramesGoOnWithoutThem)
{
  FrameRing ring(8, 2);
  for (int i = 0; i < 4; ++i)
  {
    FrameOutput* slot = ring.try_claim();
    ASSERT_NE(nullptr, slot);
    EXPECT_EQ(i < 2, ring.lend_arrays(*slot, false)) << i;
    if (slot->has_arrays) slot->well.resize(static_cast<std::size_t>(i) + 1);
    ring.hand_over();
  }
  EXPECT_EQ(1u, ring.next()->well.size());
  ring.release();
  EXPECT_TRUE(ring.lend_arrays(*ring.claim(), true)) << "one has come back";
  ring.hand_over();
  EXPECT_EQ(2u, ring.next()->well.size());
}

TEST(FrameRing, underTwoThreadsEveryFrameComesOnceAndInOrder)
{
  constexpr std::int64_t last = 20000;
  FrameRing ring(8, 2);
  std::thread writer(
      [&]
      {
        for (std::int64_t i = 1; i <= last; ++i)
        {
          FrameOutput* slot = ring.claim();
          slot->frame.stamp = i;
          if (i % 7 != 0 && ring.lend_arrays(*slot, true)) slot->well.resize(static_cast<std::size_t>(i % 7));
          ring.hand_over();
        }
        ring.close();
      });
  std::int64_t expected = 1;
  bool in_order = true, whole = true;
  while (const FrameOutput* output = ring.next())
  {
    in_order = in_order && output->frame.stamp == expected;
    whole = whole && output->well.size() == static_cast<std::size_t>(expected % 7);
    ++expected;
    ring.release();
  }
  writer.join();
  EXPECT_TRUE(in_order);
  EXPECT_TRUE(whole);
  EXPECT_EQ(last, expected - 1);
}

}  // namespace drill_rig_sim::test_realtime_ring
