// SPDX-License-Identifier: BSD-3-Clause
// What comes from downhole: every field against the number that was put into it, stamped when it was measured.
#include <gtest/gtest.h>

#include "drill_rig_sim/ros/conversions.h"
#include "drill_rig_sim/ros/frame_messages.h"
#include "frame_header.h"
#include "numbered_frame.h"

namespace drill_rig_sim::test_ros_telemetry
{
TEST(Telemetry, isStampedWhenItWasMeasured)
{
  FrameRecord frame = numbered_record();
  const MwdSurvey survey = to_mwd_survey(frame, floor_name);
  expect_header(survey.header, 10, 845678901);  // 1.5 s before the frame
  EXPECT_EQ(501.0, survey.md);
  EXPECT_EQ(502.0, survey.inclination);
  EXPECT_EQ(503.0, survey.azimuth);
  const MwdToolface toolface = to_mwd_toolface(frame, floor_name);
  expect_header(toolface.header, 11, 595678901);  // 0.75 s before it
  EXPECT_EQ(511.0, toolface.toolface);
  EXPECT_EQ(MwdToolface::GRAVITY, toolface.reference);
  frame.readings.toolface.magnetic = true;
  EXPECT_EQ(MwdToolface::MAGNETIC, to_mwd_toolface(frame, floor_name).reference);
  const MwdInclination inclination = to_mwd_inclination(frame, floor_name);
  expect_header(inclination.header, 11, 95678901);  // 1.25 s before it
  EXPECT_EQ(521.0, inclination.md);
  EXPECT_EQ(522.0, inclination.inclination);
  const DownholeDynamics dynamics = to_downhole_dynamics(frame, floor_name);
  expect_header(dynamics.header, 10, 95678901);  // 2.25 s before it
  EXPECT_EQ(531.0, dynamics.md);
  EXPECT_EQ(532.0, dynamics.duration);
  EXPECT_EQ(533.0, dynamics.weight);
  EXPECT_EQ(534.0, dynamics.torque);
  EXPECT_EQ(535.0, dynamics.bending_moment);
  EXPECT_EQ(536.0, dynamics.speed);
  EXPECT_EQ(537.0, dynamics.least_speed);
  EXPECT_EQ(538.0, dynamics.largest_speed);
  EXPECT_EQ(539.0, dynamics.stick_slip);
  EXPECT_EQ(540.0, dynamics.axial_acceleration);
  EXPECT_EQ(541.0, dynamics.lateral_acceleration);
}

}  // namespace drill_rig_sim::test_ros_telemetry
