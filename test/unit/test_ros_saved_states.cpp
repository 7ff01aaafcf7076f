// SPDX-License-Identifier: BSD-3-Clause
// Snapshots by name: order, replacing, deleting, and the limits of number and memory.
#include <gtest/gtest.h>

#include <stdexcept>

#include "drill_rig_sim/ros/saved_states.h"
#include "drill_rig_sim/sim/simulator.h"
#include "test_scenes.h"

namespace drill_rig_sim::test_ros_saved_states
{
namespace
{
/// A snapshot of a small rig.
const std::shared_ptr<const SimulatorState>& small_state()
{
  static const std::shared_ptr<const SimulatorState> state = Simulator(vertical_scene(30.0, 29.0)).save();
  return state;
}

/// A snapshot of some 20 MiB: the same rig with very many nodes.
const std::shared_ptr<const SimulatorState>& large_state()
{
  static const std::shared_ptr<const SimulatorState> state = []
  {
    auto large = std::make_shared<SimulatorState>(*small_state());
    large->mechanics.nodes.resize(120000, large->mechanics.nodes.front());
    return large;
  }();
  return state;
}

Saved saved_at(std::int64_t stamp, const std::shared_ptr<const SimulatorState>& state = small_state())
{
  return {state, ScenePlayer(), false, {}, Kernel::scalar, stamp, 0};
}

ListStates::Response listed(const SavedStates& states)
{
  ListStates::Response response;
  states.list(response);
  return response;
}

/// What it says where it refuses; empty where it does not.
template <class Action>
std::string refusal(Action action)
{
  try
  {
    action();
  }
  catch (const std::runtime_error& error)
  {
    return error.what();
  }
  return "";
}
}  // namespace

TEST(SavedStates, areListedByNameWithTheirStampsAndSizes)
{
  SavedStates states;
  states.keep("b", saved_at(2'000'000'002));
  states.keep("a", saved_at(3'000'000'003));
  const ListStates::Response list = listed(states);
  EXPECT_EQ((std::vector<std::string>{"a", "b"}), list.names);
  EXPECT_EQ((std::vector<ros::Time>{ros::Time(3, 3), ros::Time(2, 2)}), list.stamps);
  EXPECT_EQ(std::vector<std::uint64_t>(2, memory_of(*small_state())), list.bytes);
  EXPECT_EQ(268435456u, list.limit);
}

TEST(SavedStates, aLaterOneOfANameReplacesTheEarlier)
{
  SavedStates states;
  states.keep("a", saved_at(1));
  states.keep("a", saved_at(2));
  EXPECT_EQ(1u, listed(states).names.size());
  EXPECT_EQ(2, states.find("a").stamp);
}

TEST(SavedStates, areDeletedAndMissed)
{
  SavedStates states;
  EXPECT_EQ("there is no state a of this rig; saved are: none", refusal([&] { states.find("a"); }));
  states.keep("b", saved_at(1));
  states.keep("a", saved_at(2));
  states.remove("a");
  EXPECT_EQ((std::vector<std::string>{"b"}), listed(states).names);
  EXPECT_EQ("there is no state a of this rig; saved are: b", refusal([&] { states.remove("a"); }));
  states.clear();
  EXPECT_TRUE(listed(states).names.empty());
}

TEST(SavedStates, twentyNamesAreShown)
{
  SavedStates states;
  for (char c = 'a'; c < 'a' + 20; ++c) states.keep(std::string(1, c), saved_at(1));
  const std::string twenty = "saved are: a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t";
  EXPECT_EQ("there is no state ? of this rig; " + twenty, refusal([&] { states.find("?"); }));
  states.keep("u", saved_at(1));
  EXPECT_EQ("there is no state ? of this rig; " + twenty + " and 1 more", refusal([&] { states.find("?"); }));
}

TEST(SavedStates, namesHaveOneToTwoHundredBytes)
{
  SavedStates states;
  EXPECT_NE("", refusal([&] { states.keep("", saved_at(1)); }));
  EXPECT_EQ("", refusal([&] { states.keep(std::string(200, 'x'), saved_at(1)); }));
  EXPECT_EQ("name has 201 bytes; allowed is a text of 1 to 200",
            refusal([&] { states.keep(std::string(201, 'x'), saved_at(1)); }));
  EXPECT_EQ("name has control characters; allowed is one line of text", refusal([&] { states.keep("two\nlines", saved_at(1)); }));
  EXPECT_EQ(1u, listed(states).names.size());
}

TEST(SavedStates, areAThousandAtMost)
{
  SavedStates states;
  for (int i = 0; i < 1000; ++i) ASSERT_EQ("", refusal([&] { states.keep(std::to_string(i), saved_at(i)); })) << i;
  EXPECT_EQ("there are 1000 states; allowed are 1000: delete_state frees one", refusal([&] { states.keep("new", saved_at(1)); }));
  EXPECT_EQ(1000u, listed(states).names.size());
  EXPECT_EQ("", refusal([&] { states.keep("7", saved_at(77)); })) << "in place of another";
  EXPECT_EQ(77, states.find("7").stamp);
  states.remove("0");
  EXPECT_EQ("", refusal([&] { states.keep("new", saved_at(1)); }));
}

TEST(SavedStates, takeAtMost256MiB)
{
  const std::size_t size = memory_of(*large_state()), limit = std::size_t{256} << 20, most = limit / size;
  ASSERT_GE(most, 2u);
  ASSERT_LT(most, 100u);
  SavedStates states;
  for (std::size_t i = 0; i < most; ++i)
    ASSERT_EQ("", refusal([&] { states.keep(std::to_string(i), saved_at(1, large_state())); })) << i;
  const std::string wanted = std::to_string(((most + 1) * size) >> 20);
  EXPECT_EQ(
      "the states saved would take " + wanted + " MiB; allowed is 256 MiB: delete_state frees one of " + std::to_string(most),
      refusal([&] { states.keep("one more", saved_at(1, large_state())); }));
  EXPECT_EQ(most, listed(states).names.size());
  EXPECT_EQ("", refusal([&] { states.keep("0", saved_at(5, large_state())); })) << "in place of another it does not count";
  EXPECT_EQ(5, states.find("0").stamp);
  states.remove("1");
  EXPECT_EQ("", refusal([&] { states.keep("one more", saved_at(1, large_state())); }));
}

TEST(SavedStates, memoryIsThatOfTheNumbers)
{
  auto more = std::make_shared<SimulatorState>(*small_state());
  more->mechanics.nodes.push_back(more->mechanics.nodes.front());
  const std::size_t one = memory_of(*more) - memory_of(*small_state());
  more->mechanics.nodes.push_back(more->mechanics.nodes.front());
  EXPECT_EQ(memory_of(*small_state()) + 2 * one, memory_of(*more));
  EXPECT_GE(one, 13 * sizeof(double)) << "a node has a place, an attitude and their rates";
  EXPECT_GT(memory_of(*small_state()), small_state()->mechanics.nodes.size() * one);
}

}  // namespace drill_rig_sim::test_ros_saved_states
