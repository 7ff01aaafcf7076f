// SPDX-License-Identifier: BSD-3-Clause
// The transforms of a frame against the numbers that were put into it.
#include <gtest/gtest.h>

#include <vector>

#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/ros/conversions.h"
#include "drill_rig_sim/ros/frame_messages.h"
#include "frame_header.h"
#include "numbered_frame.h"

namespace drill_rig_sim::test_ros_transforms
{
TEST(Transforms, theRigFloorStandsInTheWorld)
{
  const geometry_msgs::TransformStamped t = to_rig_pose({1.0, 2.0, 3.0, 90.0 * degree, 0.0, 90.0 * degree}, floor_name);
  EXPECT_EQ("world", t.header.frame_id);
  EXPECT_EQ(floor_name, t.child_frame_id);
  EXPECT_EQ(1.0, t.transform.translation.x);
  EXPECT_EQ(2.0, t.transform.translation.y);
  EXPECT_EQ(3.0, t.transform.translation.z);
  // rolled about x first: y becomes z; then yawed about z: x becomes y
  expect_turns(t.transform.rotation, Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY());
  expect_turns(t.transform.rotation, Eigen::Vector3d::UnitY(), Eigen::Vector3d::UnitZ());
  // pitch about y: x becomes -z
  expect_turns(to_rig_pose({0.0, 0.0, 0.0, 0.0, 90.0 * degree, 0.0}, "").transform.rotation, Eigen::Vector3d::UnitX(),
               -Eigen::Vector3d::UnitZ());
}

TEST(Transforms, blockTopDriveAndPartsHangOnTheRigFloor)
{
  FrameOutput s = numbered_output();
  s.frame.truth.block_height = 25.0;
  s.frame.truth.floor_height = 0.5;  // heaves: what stands on it in the still frame rig_floor
  s.frame.truth.top_drive_angle = 90.0 * degree;
  s.parts = {{"bit", {1.0, 2.0, 3.0}, Eigen::Quaterniond(0.0, 1.0, 0.0, 0.0)},
             {"pipe_5", {4.0, 5.0, 6.0}, Eigen::Quaterniond(1.0, 0.0, 0.0, 0.0)}};
  std::vector<geometry_msgs::TransformStamped> all(7);  // more than there are now
  fill_transforms(s, "rig_b/", all);
  ASSERT_EQ(4u, all.size());
  for (const auto& t : all) expect_header(t.header, 12, 345678901);
  EXPECT_EQ("rig_b/traveling_block", all[0].child_frame_id);
  EXPECT_EQ("rig_b/top_drive", all[1].child_frame_id);
  for (int i : {0, 1})
  {
    EXPECT_EQ(0.0, all[i].transform.translation.x);
    EXPECT_EQ(0.0, all[i].transform.translation.y);
    EXPECT_EQ(25.5, all[i].transform.translation.z);
  }
  expect_turns(all[0].transform.rotation, Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitX());
  expect_turns(all[1].transform.rotation, Eigen::Vector3d::UnitX(), -Eigen::Vector3d::UnitY());  // clockwise seen from above
  EXPECT_EQ("rig_b/bit", all[2].child_frame_id);
  EXPECT_EQ("rig_b/pipe_5", all[3].child_frame_id);
  EXPECT_EQ(2.0, all[2].transform.translation.y);
  EXPECT_EQ(6.0, all[3].transform.translation.z);
  EXPECT_EQ(1.0, all[2].transform.rotation.x);
  EXPECT_EQ(1.0, all[3].transform.rotation.w);
}

}  // namespace drill_rig_sim::test_ros_transforms
