#include "tf2_ros/transform_listener.h"

#include <cinttypes>
#include <cstdio>
#include <future>
#include <string>
#include <thread>
#include <utility>

#include "rclcpp/detail/qos_parameters.hpp"

namespace tf2_ros
{

using tf2_msgs::msg::TFMessage;
using namespace std::chrono_literals;

namespace
{

rclcpp::SubscriptionOptions options_with(const rclcpp::QosOverridingOptions & overriding)
{
  rclcpp::SubscriptionOptions options;
  options.qos_overriding_options = overriding;
  return options;
}

/// Its name differs from that of all others, whatever the command line says.
rclcpp::Node::SharedPtr listening_node(const void * owner)
{
  char name[48];
  std::snprintf(name, sizeof name, "transform_listener_impl_%" PRIxPTR, reinterpret_cast<std::uintptr_t>(owner));
  rclcpp::NodeOptions options;
  options.arguments({"--ros-args", "-r", std::string("__node:=") + name});
  options.start_parameter_event_publisher(false);
  options.start_parameter_services(false);
  return std::make_shared<rclcpp::Node>("_", options);
}

}  // namespace

rclcpp::SubscriptionOptions detail::get_default_transform_listener_sub_options()
{
  using Kind = rclcpp::QosPolicyKind;
  return options_with({Kind::Depth, Kind::Durability, Kind::History, Kind::Reliability});
}

rclcpp::SubscriptionOptions detail::get_default_transform_listener_static_sub_options()
{
  using Kind = rclcpp::QosPolicyKind;
  return options_with({Kind::Depth, Kind::History, Kind::Reliability});
}

/// Spins one callback group until it is destroyed.
class TransformListener::Thread
{
public:
  Thread(
    const rclcpp::CallbackGroup::SharedPtr & group,
    const rclcpp::node_interfaces::NodeBaseInterface::SharedPtr & node)
  : executor_(options_of(node))
  {
    executor_.add_callback_group(group, node);
    thread_ = std::thread([this] {executor_.spin(); ended_.set_value();});
  }
  Thread(const Thread &) = delete;
  Thread & operator=(const Thread &) = delete;
  ~Thread()
  {
    const auto ended = ended_.get_future();
    do {  // again, for it may not have begun to spin
      executor_.cancel();
    } while (ended.wait_for(10ms) != std::future_status::ready);
    thread_.join();
  }

private:
  static rclcpp::ExecutorOptions options_of(
    const rclcpp::node_interfaces::NodeBaseInterface::SharedPtr & node)
  {
    rclcpp::ExecutorOptions options;
    options.context = node->get_context();
    return options;
  }

  rclcpp::executors::SingleThreadedExecutor executor_;
  std::promise<void> ended_;
  std::thread thread_;
};

TransformListener::TransformListener(tf2::BufferCore & buffer, bool spin_thread)
: TransformListener(buffer, Own{listening_node(this)}, spin_thread) {}

TransformListener::TransformListener(tf2::BufferCore & buffer, Own own, bool spin_thread)
: TransformListener(buffer, own.node, spin_thread)
{
  own_node_ = std::move(own.node);
}

TransformListener::TransformListener(
  tf2::BufferCore & buffer, rclcpp::node_interfaces::NodeBaseInterface::SharedPtr node_base,
  rclcpp::node_interfaces::NodeLoggingInterface::SharedPtr,
  rclcpp::node_interfaces::NodeParametersInterface::SharedPtr node_parameters,
  rclcpp::node_interfaces::NodeTopicsInterface::SharedPtr node_topics, bool spin_thread,
  const rclcpp::QoS & qos, const rclcpp::QoS & static_qos, const rclcpp::SubscriptionOptions & options,
  const rclcpp::SubscriptionOptions & static_options)
: buffer_(buffer)
{
  if (spin_thread) {
    group_ = node_base->create_callback_group(rclcpp::CallbackGroupType::MutuallyExclusive, false);
  }
  const auto subscription =
    [&](const char * topic, const rclcpp::QoS & default_qos, rclcpp::SubscriptionOptions given, bool is_static) {
      if (group_) {
        given.callback_group = group_;
      }
      const auto overridden = rclcpp::detail::declare_qos_parameters(
        given.qos_overriding_options, node_parameters, node_topics->resolve_topic_name(topic), default_qos,
        rclcpp::detail::SubscriptionQosParametersTraits());
      return rclcpp::create_subscription<TFMessage>(
        node_topics, topic, overridden,
        [this, is_static](TFMessage::ConstSharedPtr message) {subscription_callback(message, is_static);}, given);
    };
  moving_ = subscription("/tf", qos, options, false);
  static_ = subscription("/tf_static", static_qos, static_options, true);
  if (spin_thread) {
    thread_ = std::make_unique<Thread>(group_, node_base);
    buffer_.setUsingDedicatedThread(true);
  }
}

TransformListener::~TransformListener() = default;

void TransformListener::subscription_callback(TFMessage::ConstSharedPtr msg, bool is_static)
{
  for (const auto & transform : msg->transforms) {
    buffer_.setTransform(transform, "Authority undetectable", is_static);
  }
}

}  // namespace tf2_ros
