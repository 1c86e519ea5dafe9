#pragma once

#include <stdexcept>
#include <string>

#include "rclcpp/qos.hpp"

namespace rclcpp_action::detail
{

/// Of the services and topics of which an action consists: "send_goal", "cancel_goal", "get_result",
/// "feedback", "status". Throws std::invalid_argument for an empty name.
inline std::string part_of(const std::string & action, const char * part)
{
  if (action.empty()) {
    throw std::invalid_argument("the name of an action must not be empty");
  }
  return action + "/_action/" + part;
}

inline rclcpp::QoS qos_of(const rmw_qos_profile_t & profile)
{
  return rclcpp::QoS(rclcpp::QoSInitialization::from_rmw(profile), profile);
}

}  // namespace rclcpp_action::detail
