#include <sas_robot_driver/sas_robot_driver_client.hpp>

#include <sas_core/eigen3_std_conversions.hpp>

#include "message_conversions.hpp"
#include "topics.hpp"

namespace sas
{

RobotDriverClient::RobotDriverClient(
  const std::shared_ptr<rclcpp::Node> & node, const std::string & topic_prefix)
: node_(node), topic_prefix_(topics::prefix(node, topic_prefix))
{
  joint_states_subscription_ = hear<JointState>(topics::joint_states, joint_states_);
  joint_positions_min_subscription_ = hear<Doubles>(topics::joint_positions_min, joint_positions_min_);
  joint_positions_max_subscription_ = hear<Doubles>(topics::joint_positions_max, joint_positions_max_);
  home_states_subscription_ = hear<Integers>(topics::home_states, home_states_);

  const auto topic = [this](const std::string & name) {return topic_prefix_ + name;};
  target_joint_positions_publisher_ =
    node_->create_publisher<Doubles>(topic(topics::target_joint_positions), topics::told);
  target_joint_velocities_publisher_ =
    node_->create_publisher<Doubles>(topic(topics::target_joint_velocities), topics::told);
  target_joint_forces_publisher_ =
    node_->create_publisher<Doubles>(topic(topics::target_joint_forces), topics::told);
  homing_signal_publisher_ =
    node_->create_publisher<Integers>(topic(topics::homing_signal), topics::told);
  clear_positions_publisher_ =
    node_->create_publisher<Integers>(topic(topics::clear_positions), topics::told);
}

template<typename Message>
typename rclcpp::Subscription<Message>::SharedPtr RobotDriverClient::hear(
  const std::string & name, typename Message::ConstSharedPtr & last)
{
  return node_->create_subscription<Message>(
    topic_prefix_ + name, topics::heard,
    [&last](typename Message::ConstSharedPtr message) {last = message;});
}

std::string RobotDriverClient::get_topic_prefix() const
{
  return topic_prefix_;
}

bool RobotDriverClient::is_enabled(const RobotDriver::Functionality & control_mode) const
{
  switch (control_mode) {
    case RobotDriver::Functionality::PositionControl:
      return has_told(&JointState::position) && joint_positions_min_ && joint_positions_max_;
    case RobotDriver::Functionality::VelocityControl:
      return has_told(&JointState::velocity);
    case RobotDriver::Functionality::ForceControl:
      return has_told(&JointState::effort);
    case RobotDriver::Functionality::Homing:
    case RobotDriver::Functionality::ClearPositions:
      return home_states_ != nullptr;
    case RobotDriver::Functionality::Unavailable:
      return false;
  }
  return false;
}

bool RobotDriverClient::has_told(OfJoints what) const
{
  return joint_states_ && !(*joint_states_.*what).empty();
}

Eigen::VectorXd RobotDriverClient::get_joint_positions() const
{
  return of_joint_states(&JointState::position, "joint positions");
}

Eigen::VectorXd RobotDriverClient::get_joint_velocities() const
{
  return of_joint_states(&JointState::velocity, "joint velocities");
}

Eigen::VectorXd RobotDriverClient::get_joint_forces() const
{
  return of_joint_states(&JointState::effort, "joint forces");
}

Eigen::VectorXd RobotDriverClient::of_joint_states(OfJoints what, const std::string & name) const
{
  if (!has_told(what)) {
    throw_nothing_yet(name, topic_prefix_);
  }
  return std_vector_double_to_vectorxd(*joint_states_.*what);
}

std::tuple<Eigen::VectorXd, Eigen::VectorXd> RobotDriverClient::get_joint_limits() const
{
  return {
    to_vector(joint_positions_min_, "least joint positions", topic_prefix_),
    to_vector(joint_positions_max_, "greatest joint positions", topic_prefix_)};
}

Eigen::VectorXi RobotDriverClient::get_home_states() const
{
  return to_vector(home_states_, "home states", topic_prefix_);
}

void RobotDriverClient::send_target_joint_positions(const Eigen::VectorXd & target_joint_positions)
{
  target_joint_positions_publisher_->publish(to_message(target_joint_positions));
}

void RobotDriverClient::send_target_joint_velocities(const Eigen::VectorXd & target_joint_velocities)
{
  target_joint_velocities_publisher_->publish(to_message(target_joint_velocities));
}

void RobotDriverClient::send_target_joint_forces(const Eigen::VectorXd & target_joint_forces)
{
  target_joint_forces_publisher_->publish(to_message(target_joint_forces));
}

void RobotDriverClient::send_homing_signal(const Eigen::VectorXi & homing_signal)
{
  homing_signal_publisher_->publish(to_message(homing_signal));
}

void RobotDriverClient::send_clear_positions_signal(const Eigen::VectorXi & clear_positions_signal)
{
  clear_positions_publisher_->publish(to_message(clear_positions_signal));
}

}  // namespace sas
