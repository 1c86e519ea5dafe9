#include "message_conversions.hpp"

#include <stdexcept>

#include <sas_core/eigen3_std_conversions.hpp>

namespace sas
{

std_msgs::msg::Float64MultiArray to_message(const Eigen::VectorXd & vector)
{
  std_msgs::msg::Float64MultiArray message;
  message.data = vectorxd_to_std_vector_double(vector);
  return message;
}

std_msgs::msg::Int32MultiArray to_message(const Eigen::VectorXi & vector)
{
  std_msgs::msg::Int32MultiArray message;
  message.data = vectorxi_to_std_vector_int(vector);
  return message;
}

Eigen::VectorXd to_vector(
  const std_msgs::msg::Float64MultiArray::ConstSharedPtr & message, const std::string & what,
  const std::string & prefix)
{
  if (!message) {
    throw_nothing_yet(what, prefix);
  }
  return std_vector_double_to_vectorxd(message->data);
}

Eigen::VectorXi to_vector(
  const std_msgs::msg::Int32MultiArray::ConstSharedPtr & message, const std::string & what,
  const std::string & prefix)
{
  if (!message) {
    throw_nothing_yet(what, prefix);
  }
  return std_vector_int_to_vectorxi(message->data);
}

void throw_nothing_yet(const std::string & what, const std::string & prefix)
{
  throw std::runtime_error(
    "sas_robot_driver: no " + what + " have come on " + prefix +
    " yet. Spin the node until is_enabled() is true.");
}

}  // namespace sas
