// SPDX-License-Identifier: BSD-3-Clause
// Whether the simulator is there, by what was heard of it and when.
#include <gtest/gtest.h>

#include "rviz/console/link_state.h"

namespace test_rviz_link_state
{
using namespace drill_rig_sim::console;

namespace
{
Heard heard(RunState run_state, double state_age, double diagnostics_age)
{
  Heard h;
  h.shown = h.master = h.publisher = true;
  h.run_state = run_state;
  h.state_age = state_age;
  h.diagnostics_age = diagnostics_age;
  return h;
}
}  // namespace

TEST(ConsoleLinkState, RunsUntilItIsLateThenGone)
{
  EXPECT_EQ(LinkState::running, link_state(heard(RunState::running, 0.1, 0.5)));
  EXPECT_EQ(LinkState::late, link_state(heard(RunState::running, 1.5, 0.5)));
  EXPECT_EQ(LinkState::late, link_state(heard(RunState::running, 5.0, 5.0)));
  EXPECT_EQ(LinkState::absent, link_state(heard(RunState::running, 7.0, 7.0))) << "a killed node leaves its connection";
}

TEST(ConsoleLinkState, WhoIsSlowedDownIsNotLate)
{
  Heard h = heard(RunState::running, 20.0, 0.5);
  h.speed = 0.01;
  EXPECT_EQ(LinkState::running, link_state(h));
  h.speed = 0.0;  // as fast as possible
  EXPECT_EQ(LinkState::late, link_state(h));
}

TEST(ConsoleLinkState, APauseSendsNothingButDiagnostics)
{
  EXPECT_EQ(LinkState::paused, link_state(heard(RunState::paused, 1000.0, 0.9)));
  EXPECT_EQ(LinkState::late, link_state(heard(RunState::paused, 1000.0, 4.0)));
  EXPECT_EQ(LinkState::absent, link_state(heard(RunState::paused, 1000.0, 7.0)));
  EXPECT_EQ(LinkState::waiting, link_state(heard(RunState::waiting, 50.0, 0.9)));
  EXPECT_EQ(LinkState::failed, link_state(heard(RunState::failed, 50.0, 0.9)));
}

TEST(ConsoleLinkState, NobodyThere)
{
  Heard h = heard(RunState::running, 0.1, 0.1);
  h.publisher = false;
  EXPECT_EQ(LinkState::absent, link_state(h));
  h.master = false;
  EXPECT_EQ(LinkState::no_master, link_state(h));
  h.shown = false;
  EXPECT_EQ(LinkState::hidden, link_state(h));
  EXPECT_EQ(LinkState::expected, link_state(heard(RunState::unknown, 2.0, 2.0)));
}

TEST(ConsoleLinkState, WhoHearsCommands)
{
  for (const LinkState state :
       {LinkState::running, LinkState::late, LinkState::paused, LinkState::waiting, LinkState::failed, LinkState::expected})
    EXPECT_TRUE(hears(state)) << name_of(state);
  for (const LinkState state : {LinkState::hidden, LinkState::no_master, LinkState::absent})
    EXPECT_FALSE(hears(state)) << name_of(state);
}

TEST(ConsoleLinkState, WordsOfTheDiagnostics)
{
  EXPECT_EQ(RunState::waiting, run_state_of("waiting for a step"));
  EXPECT_EQ(RunState::failed, run_state_of("failed"));
  EXPECT_EQ(RunState::unknown, run_state_of("asleep"));
}
}  // namespace test_rviz_link_state
