#pragma once

#include <cmath>
#include <string>

#include "geometry_msgs/msg/transform_stamped.hpp"

inline bool near(double one, double other) {return std::abs(one - other) < 1e-9;}

/// `child` is at x, y in `parent`, turned around z by `yaw`, `seconds` after the beginning of time.
inline geometry_msgs::msg::TransformStamped placed(
  const std::string & parent, const std::string & child, double seconds, double x, double y = 0,
  double yaw = 0)
{
  geometry_msgs::msg::TransformStamped transform;
  transform.header.stamp.sec = static_cast<int>(seconds);
  transform.header.stamp.nanosec = static_cast<unsigned>(std::lround((seconds - std::floor(seconds)) * 1e9));
  transform.header.frame_id = parent;
  transform.child_frame_id = child;
  transform.transform.translation.x = x;
  transform.transform.translation.y = y;
  transform.transform.rotation.z = std::sin(yaw / 2);
  transform.transform.rotation.w = std::cos(yaw / 2);
  return transform;
}

inline bool is_at(
  const geometry_msgs::msg::TransformStamped & transform, double x, double y, double yaw = 0)
{
  const auto & rotation = transform.transform.rotation;
  return near(transform.transform.translation.x, x) && near(transform.transform.translation.y, y) &&
         near(std::remainder(2 * std::atan2(rotation.z, rotation.w) - yaw, 2 * M_PI), 0);
}
