#include <sas_robot_driver/sas_robot_driver_server.hpp>

#include <sas_core/eigen3_std_conversions.hpp>

#include "message_conversions.hpp"
#include "topics.hpp"

namespace sas
{

RobotDriverServer::RobotDriverServer(
  const std::shared_ptr<rclcpp::Node> & node, const std::string & topic_prefix)
: node_(node), topic_prefix_(topics::prefix(node, topic_prefix))
{
  const auto topic = [this](const std::string & name) {return topic_prefix_ + name;};
  joint_states_publisher_ =
    node_->create_publisher<sensor_msgs::msg::JointState>(topic(topics::joint_states), topics::told);
  joint_positions_min_publisher_ =
    node_->create_publisher<Doubles>(topic(topics::joint_positions_min), topics::told);
  joint_positions_max_publisher_ =
    node_->create_publisher<Doubles>(topic(topics::joint_positions_max), topics::told);
  home_states_publisher_ = node_->create_publisher<Integers>(topic(topics::home_states), topics::told);

  target_joint_positions_subscription_ = hear<Doubles>(
    topics::target_joint_positions, Functionality::PositionControl, target_joint_positions_);
  target_joint_velocities_subscription_ = hear<Doubles>(
    topics::target_joint_velocities, Functionality::VelocityControl, target_joint_velocities_);
  target_joint_forces_subscription_ = hear<Doubles>(
    topics::target_joint_forces, Functionality::ForceControl, target_joint_forces_);
  homing_signal_subscription_ =
    hear<Integers>(topics::homing_signal, Functionality::Homing, homing_signal_);
  clear_positions_subscription_ =
    hear<Integers>(topics::clear_positions, Functionality::ClearPositions, clear_positions_signal_);
}

template<typename Message>
typename rclcpp::Subscription<Message>::SharedPtr RobotDriverServer::hear(
  const std::string & name, Functionality functionality, typename Message::ConstSharedPtr & last)
{
  return node_->create_subscription<Message>(
    topic_prefix_ + name, topics::heard,
    [this, functionality, &last](typename Message::ConstSharedPtr message) {
      last = message;
      active_ = functionality;
    });
}

std::string RobotDriverServer::get_topic_prefix() const
{
  return topic_prefix_;
}

bool RobotDriverServer::is_enabled(const Functionality & control_mode) const
{
  switch (control_mode) {
    case Functionality::Unavailable: return false;
    case Functionality::PositionControl: return target_joint_positions_ != nullptr;
    case Functionality::VelocityControl: return target_joint_velocities_ != nullptr;
    case Functionality::ForceControl: return target_joint_forces_ != nullptr;
    case Functionality::Homing: return homing_signal_ != nullptr;
    case Functionality::ClearPositions: return clear_positions_signal_ != nullptr;
  }
  return false;
}

RobotDriver::Functionality RobotDriverServer::get_currently_active_functionality() const
{
  return active_;
}

Eigen::VectorXd RobotDriverServer::get_target_joint_positions() const
{
  return to_vector(target_joint_positions_, "target joint positions", topic_prefix_);
}

Eigen::VectorXd RobotDriverServer::get_target_joint_velocities() const
{
  return to_vector(target_joint_velocities_, "target joint velocities", topic_prefix_);
}

Eigen::VectorXd RobotDriverServer::get_target_joint_forces() const
{
  return to_vector(target_joint_forces_, "target joint forces", topic_prefix_);
}

Eigen::VectorXi RobotDriverServer::get_homing_signal() const
{
  return to_vector(homing_signal_, "homing signals", topic_prefix_);
}

Eigen::VectorXi RobotDriverServer::get_clear_positions_signal() const
{
  return to_vector(clear_positions_signal_, "signals to clear positions", topic_prefix_);
}

void RobotDriverServer::send_joint_states(
  const Eigen::VectorXd & joint_positions, const Eigen::VectorXd & joint_velocities,
  const Eigen::VectorXd & joint_forces)
{
  sensor_msgs::msg::JointState message;
  message.header.stamp = node_->now();
  message.position = vectorxd_to_std_vector_double(joint_positions);
  message.velocity = vectorxd_to_std_vector_double(joint_velocities);
  message.effort = vectorxd_to_std_vector_double(joint_forces);
  joint_states_publisher_->publish(message);
}

void RobotDriverServer::send_joint_limits(
  const std::tuple<Eigen::VectorXd, Eigen::VectorXd> & joint_limits)
{
  joint_positions_min_publisher_->publish(to_message(std::get<0>(joint_limits)));
  joint_positions_max_publisher_->publish(to_message(std::get<1>(joint_limits)));
}

void RobotDriverServer::send_home_state(const Eigen::VectorXi & home_state)
{
  home_states_publisher_->publish(to_message(home_state));
}

}  // namespace sas
