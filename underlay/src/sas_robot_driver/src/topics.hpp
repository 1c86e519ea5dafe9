// The names that a robot's driver and its clients agree on, below their prefix.

#pragma once

#include <cstddef>
#include <memory>
#include <string>

#include <rclcpp/rclcpp.hpp>

namespace sas::topics
{

inline constexpr auto joint_states = "/get/joint_states";
inline constexpr auto joint_positions_min = "/get/joint_positions_min";
inline constexpr auto joint_positions_max = "/get/joint_positions_max";
inline constexpr auto home_states = "/get/home_states";

inline constexpr auto target_joint_positions = "/set/target_joint_positions";
inline constexpr auto target_joint_velocities = "/set/target_joint_velocities";
inline constexpr auto target_joint_forces = "/set/target_joint_forces";
inline constexpr auto homing_signal = "/set/homing_signal";
inline constexpr auto clear_positions = "/set/clear_positions";

// How many messages wait. Of what is heard only the latest counts: a loop wants to know what is true now.
inline constexpr std::size_t heard = 1;
inline constexpr std::size_t told = 10;

inline std::string prefix(const std::shared_ptr<rclcpp::Node> & node, const std::string & wanted)
{
  return wanted == "GET_FROM_NODE" ? node->get_name() : wanted;
}

}  // namespace sas::topics
