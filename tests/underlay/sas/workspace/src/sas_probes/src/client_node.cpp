// Commands the robot whose name is the first word of the command line, and prints what it hears.

#include <chrono>
#include <iostream>
#include <thread>

#include <rclcpp/rclcpp.hpp>
#include <sas_robot_driver/sas_robot_driver_client.hpp>

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("client_of_a_probe");
  sas::RobotDriverClient client(node, argv[1]);
  std::cout << client.get_topic_prefix() << " " << client.is_enabled() << std::endl;
  try {
    client.get_joint_positions();
  } catch (const std::runtime_error & error) {
    std::cout << error.what() << std::endl;
  }
  while (!client.is_enabled() && rclcpp::ok()) {
    rclcpp::spin_some(node);
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  const VectorXd before = client.get_joint_positions();
  const auto [least, greatest] = client.get_joint_limits();
  const VectorXd target = (before.array() + 0.25).matrix();
  while (client.get_joint_positions() != target && rclcpp::ok()) {
    client.send_target_joint_positions(target);
    rclcpp::spin_some(node);
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  std::cout << before.transpose() << "\n" << client.get_joint_positions().transpose() << "\n";
  std::cout << least.size() << " " << greatest.size() << std::endl;
  rclcpp::shutdown();
  return 0;
}
