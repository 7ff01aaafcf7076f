// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_TEST_FRAME_HEADER_H
#define DRILL_RIG_SIM_TEST_FRAME_HEADER_H

#include <geometry_msgs/Quaternion.h>
#include <gtest/gtest.h>
#include <std_msgs/Header.h>

#include <Eigen/Geometry>
#include <cstdint>
#include <string>

/// What the tests of a frame's messages expect of headers and directions.
namespace drill_rig_sim
{
const std::string floor_name = "rig_b/rig_floor";

inline void expect_header(const std_msgs::Header& header, std::uint32_t sec, std::uint32_t nsec)
{
  EXPECT_EQ(floor_name, header.frame_id);
  EXPECT_EQ(ros::Time(sec, nsec), header.stamp);
}

inline void expect_turns(const geometry_msgs::Quaternion& q, const Eigen::Vector3d& from, const Eigen::Vector3d& to)
{
  const Eigen::Vector3d turned = Eigen::Quaterniond(q.w, q.x, q.y, q.z) * from;
  EXPECT_NEAR(0.0, (turned - to).norm(), 1e-12) << turned.transpose() << " for " << to.transpose();
}

}  // namespace drill_rig_sim

#endif
