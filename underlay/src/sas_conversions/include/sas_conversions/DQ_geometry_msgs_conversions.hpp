// Dual quaternions as messages of geometry_msgs, and back.

#pragma once

#include <dqrobotics/DQ.h>
#include <geometry_msgs/msg/point.hpp>
#include <geometry_msgs/msg/point_stamped.hpp>
#include <geometry_msgs/msg/pose.hpp>
#include <geometry_msgs/msg/pose_stamped.hpp>
#include <geometry_msgs/msg/quaternion.hpp>
#include <geometry_msgs/msg/twist.hpp>
#include <geometry_msgs/msg/wrench.hpp>
#include <geometry_msgs/msg/wrench_stamped.hpp>
#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/header.hpp>

using namespace DQ_robotics;  // NOLINT: programs of this family write DQ without a namespace

namespace sas
{

// Points, forces, torques and velocities are imaginary quaternions: x*i_ + y*j_ + z*k_. A quaternion becomes
// a unit one. A pose must be one: translation and rotation throw std::range_error otherwise.
//
// What is stamped has the time of the system's clock, and no frame.

DQ geometry_msgs_point_to_dq(const geometry_msgs::msg::Point & msg);
geometry_msgs::msg::Point dq_to_geometry_msgs_point(const DQ & dq);
DQ geometry_msgs_point_stamped_to_dq(const geometry_msgs::msg::PointStamped & msg);
geometry_msgs::msg::PointStamped dq_to_geometry_msgs_point_stamped(const DQ & dq);

DQ geometry_msgs_pose_to_dq(const geometry_msgs::msg::Pose & msg);
geometry_msgs::msg::Pose dq_to_geometry_msgs_pose(const DQ & dq);
DQ geometry_msgs_pose_stamped_to_dq(const geometry_msgs::msg::PoseStamped & msg);
geometry_msgs::msg::PoseStamped dq_to_geometry_msgs_pose_stamped(const DQ & dq);

DQ geometry_msgs_quaternion_to_dq(const geometry_msgs::msg::Quaternion & msg);
geometry_msgs::msg::Quaternion dq_to_geometry_msgs_quaternion(const DQ & dq);

void geometry_msgs_wrench_to_dq(const geometry_msgs::msg::Wrench & msg, DQ & force, DQ & torque);
geometry_msgs::msg::Wrench dq_to_geometry_msgs_wrench(const DQ & force, const DQ & torque);
void geometry_msgs_wrench_stamped_to_dq(
  const geometry_msgs::msg::WrenchStamped & msg, DQ & force, DQ & torque);
geometry_msgs::msg::WrenchStamped dq_to_geometry_msgs_wrench_stamped(const DQ & force, const DQ & torque);

void geometry_msgs_twist_to_dq(const geometry_msgs::msg::Twist & msg, DQ & linear, DQ & angular);
geometry_msgs::msg::Twist dq_to_geometry_msgs_twist(const DQ & linear, const DQ & angular);

}  // namespace sas
