#pragma once

#include <stdexcept>
#include <string>

namespace rclcpp_action::exceptions
{

/// The goal is over, or it was sent by another client.
class UnknownGoalHandleError : public std::invalid_argument
{
public:
  UnknownGoalHandleError() : std::invalid_argument("Goal handle is not known to this client.") {}
};

/// Nobody asked for the result of the goal.
class UnawareGoalHandleError : public std::runtime_error
{
public:
  explicit UnawareGoalHandleError(
    const std::string & message = "Goal handle is not tracking the goal result.")
  : std::runtime_error(message) {}
};

}  // namespace rclcpp_action::exceptions
