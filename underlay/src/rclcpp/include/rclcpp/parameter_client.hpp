#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <future>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "rcl_interfaces/msg/parameter_event.hpp"
#include "rclcpp/create_subscription.hpp"
#include "rclcpp/executors.hpp"
#include "rclcpp/macros.hpp"
#include "rclcpp/node.hpp"
#include "rclcpp/parameter.hpp"
#include "rclcpp/parameter_map.hpp"

namespace rclcpp
{

/// Reads and sets the parameters of a node, mostly another one. Futures are ready once one's node has spun.
class AsyncParametersClient
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(AsyncParametersClient)
  using Result = rcl_interfaces::msg::SetParametersResult;
  using Descriptor = rcl_interfaces::msg::ParameterDescriptor;
  using Listed = rcl_interfaces::msg::ListParametersResult;
  template<typename T>
  using Callback = std::function<void (std::shared_future<T>)>;

  /// With no name: of the node itself.
  AsyncParametersClient(
    node_interfaces::NodeBaseInterface::SharedPtr node, const std::string & remote_node_name = "",
    const QoS & qos_profile = ParametersQoS(), CallbackGroup::SharedPtr group = nullptr);
  AsyncParametersClient(
    node_interfaces::NodeBaseInterface::SharedPtr node_base_interface,
    node_interfaces::NodeTopicsInterface::SharedPtr, node_interfaces::NodeGraphInterface::SharedPtr,
    node_interfaces::NodeServicesInterface::SharedPtr, const std::string & remote_node_name = "",
    const QoS & qos_profile = ParametersQoS(), CallbackGroup::SharedPtr group = nullptr)
  : AsyncParametersClient(
      std::move(node_base_interface), remote_node_name, qos_profile, std::move(group)) {}
  template<typename NodeT>
  explicit AsyncParametersClient(
    const std::shared_ptr<NodeT> & node, const std::string & remote_node_name = "",
    const QoS & qos_profile = ParametersQoS(), CallbackGroup::SharedPtr group = nullptr)
  : AsyncParametersClient(node.get(), remote_node_name, qos_profile, std::move(group)) {}
  template<typename NodeT>
  explicit AsyncParametersClient(
    NodeT * node, const std::string & remote_node_name = "",
    const QoS & qos_profile = ParametersQoS(), CallbackGroup::SharedPtr group = nullptr)
  : AsyncParametersClient(
      node->get_node_base_interface(), remote_node_name, qos_profile, std::move(group)) {}

  std::shared_future<std::vector<Parameter>> get_parameters(
    const std::vector<std::string> & names, Callback<std::vector<Parameter>> callback = nullptr);
  std::shared_future<std::vector<Descriptor>> describe_parameters(
    const std::vector<std::string> & names, Callback<std::vector<Descriptor>> callback = nullptr);
  std::shared_future<std::vector<ParameterType>> get_parameter_types(
    const std::vector<std::string> & names, Callback<std::vector<ParameterType>> callback = nullptr);
  std::shared_future<std::vector<Result>> set_parameters(
    const std::vector<Parameter> & parameters, Callback<std::vector<Result>> callback = nullptr);
  std::shared_future<Result> set_parameters_atomically(
    const std::vector<Parameter> & parameters, Callback<Result> callback = nullptr);
  std::shared_future<std::vector<Result>> delete_parameters(
    const std::vector<std::string> & parameters_names);
  std::shared_future<Listed> list_parameters(
    const std::vector<std::string> & prefixes, std::uint64_t depth, Callback<Listed> callback = nullptr);

  /// Sets what a file, or a map, has for the node. Throws InvalidParametersException if that is nothing.
  std::shared_future<std::vector<Result>> load_parameters(const std::string & yaml_filename);
  std::shared_future<std::vector<Result>> load_parameters(const ParameterMap & parameter_map);

  /// Changes of all nodes.
  template<typename CallbackT>
  Subscription<rcl_interfaces::msg::ParameterEvent>::SharedPtr on_parameter_event(
    CallbackT && callback, const QoS & qos = ParameterEventsQoS(),
    const SubscriptionOptions & options = SubscriptionOptions())
  {
    using Event = rcl_interfaces::msg::ParameterEvent;
    auto subscription = std::make_shared<Subscription<Event>>(
      node_, "/parameter_events", qos,
      detail::message_handler<Event>(std::forward<CallbackT>(callback)), options);
    node_->add(subscription, options.callback_group);
    return subscription;
  }
  template<typename CallbackT, typename NodeT>
  static Subscription<rcl_interfaces::msg::ParameterEvent>::SharedPtr on_parameter_event(
    NodeT && node, CallbackT && callback, const QoS & qos = ParameterEventsQoS(),
    const SubscriptionOptions & options = SubscriptionOptions())
  {
    return rclcpp::create_subscription<rcl_interfaces::msg::ParameterEvent>(
      node, "/parameter_events", qos, std::forward<CallbackT>(callback), options);
  }

  bool service_is_ready() const;
  template<typename RepT = std::int64_t, typename RatioT = std::milli>
  bool wait_for_service(
    std::chrono::duration<RepT, RatioT> timeout = std::chrono::duration<RepT, RatioT>(-1))
  {
    return wait_for_service_nanoseconds(std::chrono::duration_cast<std::chrono::nanoseconds>(timeout));
  }

private:
  struct Clients;

  bool wait_for_service_nanoseconds(std::chrono::nanoseconds timeout);

  node_interfaces::NodeBaseInterface::SharedPtr node_;
  std::string remote_name_;
  std::shared_ptr<Clients> clients_;
};

/// The same for who waits for answers: spins the node, which must be with no other executor, for each.
class SyncParametersClient
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(SyncParametersClient)
  using Result = AsyncParametersClient::Result;
  using Descriptor = AsyncParametersClient::Descriptor;
  using Listed = AsyncParametersClient::Listed;

  SyncParametersClient(
    Executor::SharedPtr executor, node_interfaces::NodeBaseInterface::SharedPtr node,
    const std::string & remote_node_name = "", const QoS & qos_profile = ParametersQoS());
  SyncParametersClient(
    Executor::SharedPtr executor, node_interfaces::NodeBaseInterface::SharedPtr node_base_interface,
    node_interfaces::NodeTopicsInterface::SharedPtr, node_interfaces::NodeGraphInterface::SharedPtr,
    node_interfaces::NodeServicesInterface::SharedPtr, const std::string & remote_node_name = "",
    const QoS & qos_profile = ParametersQoS())
  : SyncParametersClient(
      std::move(executor), std::move(node_base_interface), remote_node_name, qos_profile) {}
  template<typename NodeT>
  explicit SyncParametersClient(
    const std::shared_ptr<NodeT> & node, const std::string & remote_node_name = "",
    const QoS & qos_profile = ParametersQoS())
  : SyncParametersClient(node.get(), remote_node_name, qos_profile) {}
  template<typename NodeT>
  explicit SyncParametersClient(
    NodeT * node, const std::string & remote_node_name = "", const QoS & qos_profile = ParametersQoS())
  : SyncParametersClient(nullptr, node->get_node_base_interface(), remote_node_name, qos_profile) {}
  template<typename NodeT>
  SyncParametersClient(
    Executor::SharedPtr executor, const std::shared_ptr<NodeT> & node,
    const std::string & remote_node_name = "", const QoS & qos_profile = ParametersQoS())
  : SyncParametersClient(
      std::move(executor), node->get_node_base_interface(), remote_node_name, qos_profile) {}
  template<typename NodeT>
  SyncParametersClient(
    Executor::SharedPtr executor, NodeT * node, const std::string & remote_node_name = "",
    const QoS & qos_profile = ParametersQoS())
  : SyncParametersClient(
      std::move(executor), node->get_node_base_interface(), remote_node_name, qos_profile) {}

  // Empty when no answer came in time; a negative time waits for ever.
  std::vector<Parameter> get_parameters(
    const std::vector<std::string> & names, std::chrono::nanoseconds timeout = no_timeout);
  std::vector<Descriptor> describe_parameters(
    const std::vector<std::string> & names, std::chrono::nanoseconds timeout = no_timeout);
  std::vector<ParameterType> get_parameter_types(
    const std::vector<std::string> & names, std::chrono::nanoseconds timeout = no_timeout);
  std::vector<Result> set_parameters(
    const std::vector<Parameter> & parameters, std::chrono::nanoseconds timeout = no_timeout);
  std::vector<Result> delete_parameters(
    const std::vector<std::string> & parameters_names, std::chrono::nanoseconds timeout = no_timeout);
  std::vector<Result> load_parameters(
    const std::string & yaml_filename, std::chrono::nanoseconds timeout = no_timeout);

  // These throw std::runtime_error when no answer came in time.
  Result set_parameters_atomically(
    const std::vector<Parameter> & parameters, std::chrono::nanoseconds timeout = no_timeout);
  Listed list_parameters(
    const std::vector<std::string> & parameter_prefixes, std::uint64_t depth,
    std::chrono::nanoseconds timeout = no_timeout);

  bool has_parameter(const std::string & parameter_name);
  template<typename T>
  T get_parameter(const std::string & parameter_name, const T & default_value)
  {
    const auto found = get_parameters({parameter_name});
    const bool is_set = found.size() == 1 && found.front().get_type() != PARAMETER_NOT_SET;
    return is_set ? static_cast<T>(found.front().get_value<T>()) : default_value;
  }
  /// Throws std::runtime_error when it is not set.
  template<typename T>
  T get_parameter(const std::string & parameter_name)
  {
    const auto found = get_parameters({parameter_name});
    if (found.size() != 1 || found.front().get_type() == PARAMETER_NOT_SET) {
      throw std::runtime_error("Parameter '" + parameter_name + "' is not set");
    }
    return static_cast<T>(found.front().get_value<T>());
  }

  template<typename CallbackT>
  Subscription<rcl_interfaces::msg::ParameterEvent>::SharedPtr on_parameter_event(CallbackT && callback)
  {
    return async_->on_parameter_event(std::forward<CallbackT>(callback));
  }
  template<typename CallbackT, typename NodeT>
  static Subscription<rcl_interfaces::msg::ParameterEvent>::SharedPtr on_parameter_event(
    NodeT && node, CallbackT && callback, const QoS & qos = ParameterEventsQoS())
  {
    return AsyncParametersClient::on_parameter_event(node, std::forward<CallbackT>(callback), qos);
  }

  bool service_is_ready() const {return async_->service_is_ready();}
  template<typename RepT = std::int64_t, typename RatioT = std::milli>
  bool wait_for_service(
    std::chrono::duration<RepT, RatioT> timeout = std::chrono::duration<RepT, RatioT>(-1))
  {
    return async_->wait_for_service(timeout);
  }

private:
  static constexpr std::chrono::nanoseconds no_timeout{-1};

  template<typename T>
  bool wait(const std::shared_future<T> & future, std::chrono::nanoseconds timeout);

  Executor::SharedPtr executor_;
  node_interfaces::NodeBaseInterface::SharedPtr node_;
  AsyncParametersClient::SharedPtr async_;
};

}  // namespace rclcpp
