#pragma once

#include <memory>

#include "rclcpp/clock.hpp"
#include "rclcpp/node_interfaces/node_base_interface.hpp"
#include "rclcpp/node_interfaces/node_clock_interface.hpp"
#include "rclcpp/node_interfaces/node_graph_interface.hpp"
#include "rclcpp/node_interfaces/node_logging_interface.hpp"
#include "rclcpp/node_interfaces/node_parameters_interface.hpp"
#include "rclcpp/node_interfaces/node_services_interface.hpp"
#include "rclcpp/node_interfaces/node_topics_interface.hpp"
#include "rclcpp/qos.hpp"
#include "rosgraph_msgs/msg/clock.hpp"

namespace rclcpp
{

class Node;
namespace node_interfaces
{
class NodeTimeSourceInterface;
}  // namespace node_interfaces

/// Lets clocks follow the messages on /clock while the parameter use_sim_time of a node is true.
class TimeSource
{
public:
  explicit TimeSource(
    std::shared_ptr<Node> node, const QoS & qos = ClockQoS(), bool use_clock_thread = true);
  explicit TimeSource(const QoS & qos = ClockQoS(), bool use_clock_thread = true);
  TimeSource(const TimeSource &) = delete;
  TimeSource & operator=(const TimeSource &) = delete;
  TimeSource(TimeSource &&) = default;
  TimeSource & operator=(TimeSource &&) = default;
  ~TimeSource();

  /// The node's parameter is declared if it is not there. Throws std::invalid_argument if it is not a bool.
  void attachNode(std::shared_ptr<Node> node);
  void attachNode(
    node_interfaces::NodeBaseInterface::SharedPtr node_base_interface,
    node_interfaces::NodeTopicsInterface::SharedPtr node_topics_interface,
    node_interfaces::NodeGraphInterface::SharedPtr node_graph_interface,
    node_interfaces::NodeServicesInterface::SharedPtr node_services_interface,
    node_interfaces::NodeLoggingInterface::SharedPtr node_logging_interface,
    node_interfaces::NodeClockInterface::SharedPtr node_clock_interface,
    node_interfaces::NodeParametersInterface::SharedPtr node_parameters_interface);
  /// Forgets the clocks, too.
  void detachNode();

  /// Throws std::invalid_argument if simulated time is active and the clock is not a ROS clock.
  void attachClock(Clock::SharedPtr clock);
  void detachClock(Clock::SharedPtr clock);

  /// Whether /clock is heard in a thread of its own, so that time goes on while callbacks run.
  bool get_use_clock_thread();
  void set_use_clock_thread(bool use_clock_thread);
  bool clock_thread_is_joinable();

private:
  friend class node_interfaces::NodeTimeSourceInterface;
  struct Impl;

  void attach(
    const node_interfaces::NodeBaseInterface::SharedPtr & node,
    const node_interfaces::NodeParametersInterface::SharedPtr & parameters);

  QoS qos_;
  bool constructed_use_clock_thread_;
  std::shared_ptr<Impl> impl_;
};

}  // namespace rclcpp
