// Messages from vectors of Eigen, and back.

#pragma once

#include <string>

#include <Eigen/Dense>
#include <std_msgs/msg/float64_multi_array.hpp>
#include <std_msgs/msg/int32_multi_array.hpp>

namespace sas
{

std_msgs::msg::Float64MultiArray to_message(const Eigen::VectorXd & vector);
std_msgs::msg::Int32MultiArray to_message(const Eigen::VectorXi & vector);

/// Throw std::runtime_error when `message` is null: nothing of `what` has come on `prefix` yet.
Eigen::VectorXd to_vector(
  const std_msgs::msg::Float64MultiArray::ConstSharedPtr & message, const std::string & what,
  const std::string & prefix);
Eigen::VectorXi to_vector(
  const std_msgs::msg::Int32MultiArray::ConstSharedPtr & message, const std::string & what,
  const std::string & prefix);

[[noreturn]] void throw_nothing_yet(const std::string & what, const std::string & prefix);

}  // namespace sas
