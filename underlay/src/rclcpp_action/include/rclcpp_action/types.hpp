#pragma once

#include <algorithm>
#include <array>
#include <climits>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "action_msgs/msg/goal_info.hpp"
#include "action_msgs/msg/goal_status.hpp"
#include "rcl_action/types.h"
#include "rclcpp_action/visibility_control.hpp"

namespace rclcpp_action
{

using GoalUUID = std::array<std::uint8_t, UUID_SIZE>;
using GoalStatus = action_msgs::msg::GoalStatus;
using GoalInfo = action_msgs::msg::GoalInfo;

/// In the usual form: 00000000-0000-0000-0000-000000000000.
inline std::string to_string(const GoalUUID & goal_id)
{
  std::string text;
  for (const std::uint8_t byte : goal_id) {
    const bool dash = text.size() == 8 || text.size() == 13 || text.size() == 18 || text.size() == 23;
    text += dash ? "-" : "";
    text += "0123456789abcdef"[byte >> 4];
    text += "0123456789abcdef"[byte & 15];
  }
  return text;
}

inline void convert(const GoalUUID & goal_id, rcl_action_goal_info_t * info)
{
  std::copy(goal_id.begin(), goal_id.end(), info->goal_id.uuid);
}

inline void convert(const rcl_action_goal_info_t & info, GoalUUID * goal_id)
{
  std::copy_n(info.goal_id.uuid, UUID_SIZE, goal_id->begin());
}

}  // namespace rclcpp_action

/// GoalUUIDs can be keys of an unordered map.
template<>
struct std::hash<rclcpp_action::GoalUUID>
{
  std::size_t operator()(const rclcpp_action::GoalUUID & uuid) const noexcept
  {
    return std::hash<std::string_view>()({reinterpret_cast<const char *>(uuid.data()), uuid.size()});
  }
};
