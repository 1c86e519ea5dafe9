// The other end of a robot's topics: for programs that want to know what it does, and command it.

#pragma once

#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include <Eigen/Dense>
#include <rclcpp/rclcpp.hpp>
#include <sas_core/sas_robot_driver.hpp>
#include <sensor_msgs/msg/joint_state.hpp>
#include <std_msgs/msg/float64_multi_array.hpp>
#include <std_msgs/msg/int32_multi_array.hpp>

namespace sas
{

/// Subscribes to <prefix>/get/..., publishes on <prefix>/set/...; it hears only while the node spins, and is
/// to be used in the thread that spins.
class RobotDriverClient
{
public:
  /// "GET_FROM_NODE" makes the node's name the prefix.
  explicit RobotDriverClient(
    const std::shared_ptr<rclcpp::Node> & node, const std::string & topic_prefix = "GET_FROM_NODE");
  RobotDriverClient(const RobotDriverClient &) = delete;
  RobotDriverClient & operator=(const RobotDriverClient &) = delete;

  std::string get_topic_prefix() const;

  /// Whether the robot has told what is needed for that: the state of its joints, and for positions their
  /// limits, too; for homing, which joints are home.
  bool is_enabled(
    const RobotDriver::Functionality & control_mode = RobotDriver::Functionality::PositionControl) const;

  /// What the robot told last. Throw std::runtime_error when it has told nothing.
  Eigen::VectorXd get_joint_positions() const;
  Eigen::VectorXd get_joint_velocities() const;
  Eigen::VectorXd get_joint_forces() const;
  std::tuple<Eigen::VectorXd, Eigen::VectorXd> get_joint_limits() const;
  Eigen::VectorXi get_home_states() const;

  void send_target_joint_positions(const Eigen::VectorXd & target_joint_positions);
  void send_target_joint_velocities(const Eigen::VectorXd & target_joint_velocities);
  void send_target_joint_forces(const Eigen::VectorXd & target_joint_forces);
  void send_homing_signal(const Eigen::VectorXi & homing_signal);
  void send_clear_positions_signal(const Eigen::VectorXi & clear_positions_signal);

private:
  using JointState = sensor_msgs::msg::JointState;
  using Doubles = std_msgs::msg::Float64MultiArray;
  using Integers = std_msgs::msg::Int32MultiArray;
  using OfJoints = std::vector<double> JointState::*;

  template<typename Message>
  typename rclcpp::Subscription<Message>::SharedPtr hear(
    const std::string & name, typename Message::ConstSharedPtr & last);

  bool has_told(OfJoints what) const;
  Eigen::VectorXd of_joint_states(OfJoints what, const std::string & name) const;

  std::shared_ptr<rclcpp::Node> node_;
  std::string topic_prefix_;

  JointState::ConstSharedPtr joint_states_;
  Doubles::ConstSharedPtr joint_positions_min_;
  Doubles::ConstSharedPtr joint_positions_max_;
  Integers::ConstSharedPtr home_states_;

  rclcpp::Subscription<JointState>::SharedPtr joint_states_subscription_;
  rclcpp::Subscription<Doubles>::SharedPtr joint_positions_min_subscription_;
  rclcpp::Subscription<Doubles>::SharedPtr joint_positions_max_subscription_;
  rclcpp::Subscription<Integers>::SharedPtr home_states_subscription_;

  rclcpp::Publisher<Doubles>::SharedPtr target_joint_positions_publisher_;
  rclcpp::Publisher<Doubles>::SharedPtr target_joint_velocities_publisher_;
  rclcpp::Publisher<Doubles>::SharedPtr target_joint_forces_publisher_;
  rclcpp::Publisher<Integers>::SharedPtr homing_signal_publisher_;
  rclcpp::Publisher<Integers>::SharedPtr clear_positions_publisher_;
};

}  // namespace sas
