// Runs a robot driver as a node.

#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <rclcpp/rclcpp.hpp>
#include <sas_core/sas_clock.hpp>
#include <sas_core/sas_robot_driver.hpp>
#include <sas_core/sas_shutdown_signaler.hpp>
#include <sas_robot_driver/sas_robot_driver_server.hpp>

namespace sas
{

struct RobotDriverROSConfiguration
{
  std::string robot_driver_provider_prefix;  ///< what the robot's topics begin with
  double thread_sampling_time_sec = 0.0;     ///< the robot is read and commanded once in this time
  double watchdog_period_in_seconds = 0.0;   ///< not used: there is no watchdog
  std::vector<double> q_min = {};            ///< least positions, for the program's own use
  std::vector<double> q_max = {};            ///< greatest positions, for the program's own use
};

/// Reads and commands the robot at a fixed rate, and speaks for it on the topics of RobotDriverServer.
class RobotDriverROS
{
public:
  /// `*kill_this_node` ends the loop; it is set when the driver fails, so that the driver's own loops end.
  /// Throws std::invalid_argument when something is missing, or the sampling time is not positive.
  RobotDriverROS(
    const std::shared_ptr<rclcpp::Node> & node, const std::shared_ptr<RobotDriver> & robot_driver,
    const RobotDriverROSConfiguration & configuration, std::atomic_bool * kill_this_node);
  /// The same; `shutdown_signaler` ends the loop, and is told when the driver fails.
  RobotDriverROS(
    const std::shared_ptr<rclcpp::Node> & node, const std::shared_ptr<RobotDriver> & robot_driver,
    const RobotDriverROSConfiguration & configuration,
    const std::shared_ptr<ShutdownSignaler> & shutdown_signaler);
  RobotDriverROS() = delete;
  RobotDriverROS(const RobotDriverROS &) = delete;
  RobotDriverROS & operator=(const RobotDriverROS &) = delete;

  /// Connect and initialize the robot, run until the end, deinitialize and disconnect it.
  ///
  /// The last two come in any case. What the driver throws is logged as an error and ends the loop, and 1 is
  /// returned instead of 0.
  int control_loop();

private:
  bool carry_out(const std::string & step, const std::function<void()> & action) const;
  bool should_shutdown() const;
  void loop();
  void tell();
  void obey();

  std::shared_ptr<rclcpp::Node> node_;
  std::shared_ptr<RobotDriver> robot_driver_;
  std::shared_ptr<ShutdownSignaler> shutdown_signaler_;
  Clock clock_;
  RobotDriverServer robot_driver_server_;
};

}  // namespace sas
