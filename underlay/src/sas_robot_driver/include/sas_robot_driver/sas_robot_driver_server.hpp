// The robot's end of the topics: tells what the robot does, hears what it should do.

#pragma once

#include <memory>
#include <string>
#include <tuple>

#include <Eigen/Dense>
#include <rclcpp/rclcpp.hpp>
#include <sas_core/sas_robot_driver.hpp>
#include <sensor_msgs/msg/joint_state.hpp>
#include <std_msgs/msg/float64_multi_array.hpp>
#include <std_msgs/msg/int32_multi_array.hpp>

namespace sas
{

/// Publishes on <prefix>/get/..., subscribes to <prefix>/set/...; it hears only while the node spins, and is
/// to be used in the thread that spins.
class RobotDriverServer
{
public:
  /// "GET_FROM_NODE" makes the node's name the prefix.
  explicit RobotDriverServer(
    const std::shared_ptr<rclcpp::Node> & node, const std::string & topic_prefix = "GET_FROM_NODE");
  RobotDriverServer(const RobotDriverServer &) = delete;
  RobotDriverServer & operator=(const RobotDriverServer &) = delete;

  std::string get_topic_prefix() const;

  /// Whether a target (or signal) of that kind has come.
  bool is_enabled(
    const RobotDriver::Functionality & control_mode = RobotDriver::Functionality::PositionControl) const;

  /// The kind that came last.
  RobotDriver::Functionality get_currently_active_functionality() const;

  /// What came last of that kind. Throw std::runtime_error when nothing has.
  Eigen::VectorXd get_target_joint_positions() const;
  Eigen::VectorXd get_target_joint_velocities() const;
  Eigen::VectorXd get_target_joint_forces() const;
  Eigen::VectorXi get_homing_signal() const;
  Eigen::VectorXi get_clear_positions_signal() const;

  /// An empty vector stands for what the robot does not measure.
  void send_joint_states(
    const Eigen::VectorXd & joint_positions, const Eigen::VectorXd & joint_velocities,
    const Eigen::VectorXd & joint_forces);
  void send_joint_limits(const std::tuple<Eigen::VectorXd, Eigen::VectorXd> & joint_limits);
  void send_home_state(const Eigen::VectorXi & home_state);

private:
  using Doubles = std_msgs::msg::Float64MultiArray;
  using Integers = std_msgs::msg::Int32MultiArray;
  using Functionality = RobotDriver::Functionality;

  template<typename Message>
  typename rclcpp::Subscription<Message>::SharedPtr hear(
    const std::string & name, Functionality functionality, typename Message::ConstSharedPtr & last);

  std::shared_ptr<rclcpp::Node> node_;
  std::string topic_prefix_;
  Functionality active_ = Functionality::Unavailable;

  Doubles::ConstSharedPtr target_joint_positions_;
  Doubles::ConstSharedPtr target_joint_velocities_;
  Doubles::ConstSharedPtr target_joint_forces_;
  Integers::ConstSharedPtr homing_signal_;
  Integers::ConstSharedPtr clear_positions_signal_;

  rclcpp::Publisher<sensor_msgs::msg::JointState>::SharedPtr joint_states_publisher_;
  rclcpp::Publisher<Doubles>::SharedPtr joint_positions_min_publisher_;
  rclcpp::Publisher<Doubles>::SharedPtr joint_positions_max_publisher_;
  rclcpp::Publisher<Integers>::SharedPtr home_states_publisher_;

  rclcpp::Subscription<Doubles>::SharedPtr target_joint_positions_subscription_;
  rclcpp::Subscription<Doubles>::SharedPtr target_joint_velocities_subscription_;
  rclcpp::Subscription<Doubles>::SharedPtr target_joint_forces_subscription_;
  rclcpp::Subscription<Integers>::SharedPtr homing_signal_subscription_;
  rclcpp::Subscription<Integers>::SharedPtr clear_positions_subscription_;
};

}  // namespace sas
