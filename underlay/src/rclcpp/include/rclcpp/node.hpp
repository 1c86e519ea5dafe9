#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <functional>
#include <list>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <tuple>
#include <utility>
#include <vector>

#include "rclcpp/callback_group.hpp"
#include "rclcpp/client.hpp"
#include "rclcpp/clock.hpp"
#include "rclcpp/context.hpp"
#include "rclcpp/create_timer.hpp"
#include "rclcpp/event.hpp"
#include "rclcpp/generic_client.hpp"
#include "rclcpp/generic_publisher.hpp"
#include "rclcpp/generic_subscription.hpp"
#include "rclcpp/logger.hpp"
#include "rclcpp/logging.hpp"
#include "rclcpp/macros.hpp"
#include "rclcpp/message_memory_strategy.hpp"
#include "rclcpp/node_interfaces/node_base_interface.hpp"
#include "rclcpp/node_interfaces/node_clock_interface.hpp"
#include "rclcpp/node_interfaces/node_graph_interface.hpp"
#include "rclcpp/node_interfaces/node_logging_interface.hpp"
#include "rclcpp/node_interfaces/node_parameters_interface.hpp"
#include "rclcpp/node_interfaces/node_services_interface.hpp"
#include "rclcpp/node_interfaces/node_time_source_interface.hpp"
#include "rclcpp/node_interfaces/node_timers_interface.hpp"
#include "rclcpp/node_interfaces/node_topics_interface.hpp"
#include "rclcpp/node_interfaces/node_type_descriptions_interface.hpp"
#include "rclcpp/node_interfaces/node_waitables_interface.hpp"
#include "rclcpp/node_options.hpp"
#include "rclcpp/publisher.hpp"
#include "rclcpp/qos.hpp"
#include "rclcpp/service.hpp"
#include "rclcpp/subscription.hpp"
#include "rclcpp/time.hpp"
#include "rclcpp/timer.hpp"
#include "rclcpp/utilities.hpp"

namespace rclcpp
{

/// A node. Make one with std::make_shared, or derive a class from it.
class Node : public std::enable_shared_from_this<Node>
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Node)
  RCLCPP_DISABLE_COPY(Node)
  using PreSetParametersCallbackType =
    node_interfaces::PreSetParametersCallbackHandle::PreSetParametersCallbackType;
  using OnSetParametersCallbackType =
    node_interfaces::OnSetParametersCallbackHandle::OnSetParametersCallbackType;
  using OnParametersSetCallbackType = OnSetParametersCallbackType;
  using PostSetParametersCallbackType =
    node_interfaces::PostSetParametersCallbackHandle::PostSetParametersCallbackType;
  using PreSetParametersCallbackHandle = node_interfaces::PreSetParametersCallbackHandle;
  using OnSetParametersCallbackHandle = node_interfaces::OnSetParametersCallbackHandle;
  using PostSetParametersCallbackHandle = node_interfaces::PostSetParametersCallbackHandle;
  using NamesAndTypes = std::map<std::string, std::vector<std::string>>;

  explicit Node(const std::string & node_name, const NodeOptions & options = NodeOptions());
  explicit Node(
    const std::string & node_name, const std::string & namespace_,
    const NodeOptions & options = NodeOptions());
  virtual ~Node();

  const char * get_name() const;
  const char * get_namespace() const;
  const char * get_fully_qualified_name() const;
  Logger get_logger() const;
  const NodeOptions & get_node_options() const {return options_;}

  Clock::SharedPtr get_clock() {return clock_;}
  Clock::ConstSharedPtr get_clock() const {return clock_;}
  Time now() const {return clock_->now();}

  /// A node object of the same node, whose relative names begin with `sub_namespace`.
  Node::SharedPtr create_sub_node(const std::string & sub_namespace);
  const std::string & get_sub_namespace() const {return sub_namespace_;}
  const std::string & get_effective_namespace() const {return effective_namespace_;}

  CallbackGroup::SharedPtr create_callback_group(
    CallbackGroupType group_type, bool automatically_add_to_executor_with_node = true);
  void for_each_callback_group(const std::function<void(CallbackGroup::SharedPtr)> & function);

  // ---- topics, timers, services

  template<typename MessageT, typename AllocatorT = std::allocator<void>,
    typename PublisherT = Publisher<MessageT, AllocatorT>>
  std::shared_ptr<PublisherT> create_publisher(
    const std::string & topic_name, const QoS & qos,
    const PublisherOptionsWithAllocator<AllocatorT> & options =
    PublisherOptionsWithAllocator<AllocatorT>())
  {
    const std::string topic = extended(topic_name);
    return std::make_shared<PublisherT>(base_, topic, overridden(topic, qos, options), options);
  }

  /// `callback` takes the message by const reference, shared or unique pointer, and a MessageInfo.
  template<typename MessageT, typename CallbackT, typename AllocatorT = std::allocator<void>,
    typename SubscriptionT = Subscription<MessageT, AllocatorT>>
  std::shared_ptr<SubscriptionT> create_subscription(
    const std::string & topic_name, const QoS & qos, CallbackT && callback,
    const SubscriptionOptionsWithAllocator<AllocatorT> & options =
    SubscriptionOptionsWithAllocator<AllocatorT>(),
    std::shared_ptr<message_memory_strategy::MessageMemoryStrategy<MessageT, AllocatorT>> = nullptr)
  {
    const std::string topic = extended(topic_name);
    auto subscription = std::make_shared<SubscriptionT>(
      base_, topic, overridden(topic, qos, options),
      detail::subscription_handler<MessageT>(std::forward<CallbackT>(callback)), options);
    base_->add(subscription, options.callback_group);
    return subscription;
  }

  /// `topic_type` as std_msgs/msg/String. Throws std::runtime_error for a type that is not there.
  template<typename AllocatorT = std::allocator<void>>
  GenericPublisher::SharedPtr create_generic_publisher(
    const std::string & topic_name, const std::string & topic_type, const QoS & qos,
    const PublisherOptionsWithAllocator<AllocatorT> & options =
    PublisherOptionsWithAllocator<AllocatorT>())
  {
    const std::string topic = extended(topic_name);
    return std::make_shared<GenericPublisher>(
      base_, topic, topic_type, overridden(topic, qos, options), options);
  }

  /// `callback` takes an rclcpp::SerializedMessage as others take a message.
  template<typename CallbackT, typename AllocatorT = std::allocator<void>>
  GenericSubscription::SharedPtr create_generic_subscription(
    const std::string & topic_name, const std::string & topic_type, const QoS & qos, CallbackT && callback,
    const SubscriptionOptionsWithAllocator<AllocatorT> & options =
    SubscriptionOptionsWithAllocator<AllocatorT>())
  {
    const std::string topic = extended(topic_name);
    auto subscription = std::make_shared<GenericSubscription>(
      base_, topic, topic_type, overridden(topic, qos, options),
      detail::message_handler<SerializedMessage>(std::forward<CallbackT>(callback)), options);
    base_->add(subscription, options.callback_group);
    return subscription;
  }

  template<typename DurationRepT = std::int64_t, typename DurationT = std::milli, typename CallbackT>
  typename WallTimer<CallbackT>::SharedPtr create_wall_timer(
    std::chrono::duration<DurationRepT, DurationT> period, CallbackT callback,
    CallbackGroup::SharedPtr group = nullptr, bool autostart = true)
  {
    return rclcpp::create_wall_timer(
      period, std::move(callback), std::move(group), base_.get(), timers_.get(), autostart);
  }

  /// A timer that follows the clock of the node, also where that is simulated.
  template<typename DurationRepT = std::int64_t, typename DurationT = std::milli, typename CallbackT>
  typename GenericTimer<CallbackT>::SharedPtr create_timer(
    std::chrono::duration<DurationRepT, DurationT> period, CallbackT callback,
    CallbackGroup::SharedPtr group = nullptr)
  {
    return rclcpp::create_timer(
      clock_, period, std::move(callback), std::move(group), base_.get(), timers_.get());
  }

  template<typename ServiceT>
  std::shared_ptr<Client<ServiceT>> create_client(
    const std::string & service_name, const QoS & qos = ServicesQoS(),
    CallbackGroup::SharedPtr group = nullptr)
  {
    auto client = std::make_shared<Client<ServiceT>>(base_, extended(service_name), qos);
    base_->add(client, group);
    return client;
  }
  template<typename ServiceT>
  std::shared_ptr<Client<ServiceT>> create_client(
    const std::string & service_name, const rmw_qos_profile_t & qos_profile,
    CallbackGroup::SharedPtr group = nullptr)
  {
    return create_client<ServiceT>(
      service_name, QoS(QoSInitialization::from_rmw(qos_profile), qos_profile), group);
  }

  /// `service_type` as example_interfaces/srv/AddTwoInts. Throws std::runtime_error if there is no such type.
  GenericClient::SharedPtr create_generic_client(
    const std::string & service_name, const std::string & service_type, const QoS & qos = ServicesQoS(),
    CallbackGroup::SharedPtr group = nullptr)
  {
    auto client = std::make_shared<GenericClient>(base_, extended(service_name), service_type, qos);
    base_->add(client, group);
    return client;
  }

  /// `callback` takes shared pointers to the request and to the response, which is sent when it returns.
  template<typename ServiceT, typename CallbackT>
  std::shared_ptr<Service<ServiceT>> create_service(
    const std::string & service_name, CallbackT && callback, const QoS & qos = ServicesQoS(),
    CallbackGroup::SharedPtr group = nullptr)
  {
    auto service = std::make_shared<Service<ServiceT>>(
      base_, extended(service_name),
      detail::service_handler<ServiceT>(std::forward<CallbackT>(callback)), qos);
    base_->add(service, group);
    return service;
  }
  template<typename ServiceT, typename CallbackT>
  std::shared_ptr<Service<ServiceT>> create_service(
    const std::string & service_name, CallbackT && callback, const rmw_qos_profile_t & qos_profile,
    CallbackGroup::SharedPtr group = nullptr)
  {
    return create_service<ServiceT>(
      service_name, std::forward<CallbackT>(callback),
      QoS(QoSInitialization::from_rmw(qos_profile), qos_profile), group);
  }

  // ---- parameters

  const ParameterValue & declare_parameter(
    const std::string & name, const ParameterValue & default_value,
    const rcl_interfaces::msg::ParameterDescriptor & parameter_descriptor =
    rcl_interfaces::msg::ParameterDescriptor(), bool ignore_override = false);

  /// Without a default: the value comes from outside. Reading it before that is an error.
  const ParameterValue & declare_parameter(
    const std::string & name, ParameterType type,
    const rcl_interfaces::msg::ParameterDescriptor & parameter_descriptor =
    rcl_interfaces::msg::ParameterDescriptor(), bool ignore_override = false);

  /// Gives the value: the default, or what command line, file or options say instead.
  template<typename ParameterT>
  auto declare_parameter(
    const std::string & name, const ParameterT & default_value,
    const rcl_interfaces::msg::ParameterDescriptor & parameter_descriptor =
    rcl_interfaces::msg::ParameterDescriptor(), bool ignore_override = false)
  {
    try {
      return declare_parameter(
        name, ParameterValue(default_value), parameter_descriptor, ignore_override).get<ParameterT>();
    } catch (const ParameterTypeException & error) {
      throw exceptions::InvalidParameterTypeException(name, error.what());
    }
  }

  /// Without a default. Throws ParameterUninitializedException when no value is given from outside.
  template<typename ParameterT>
  auto declare_parameter(
    const std::string & name,
    const rcl_interfaces::msg::ParameterDescriptor & parameter_descriptor =
    rcl_interfaces::msg::ParameterDescriptor(), bool ignore_override = false)
  {
    const ParameterType type = ParameterValue(ParameterT{}).get_type();
    try {
      return declare_parameter(name, type, parameter_descriptor, ignore_override).get<ParameterT>();
    } catch (const ParameterTypeException &) {
      throw exceptions::ParameterUninitializedException(name);
    }
  }

  template<typename ParameterT>
  std::vector<ParameterT> declare_parameters(
    const std::string & namespace_, const std::map<std::string, ParameterT> & parameters,
    bool ignore_overrides = false)
  {
    std::vector<ParameterT> values;
    for (const auto & [name, value] : parameters) {
      values.push_back(
        declare_parameter(
          namespace_.empty() ? name : namespace_ + "." + name, value,
          rcl_interfaces::msg::ParameterDescriptor(), ignore_overrides));
    }
    return values;
  }
  template<typename ParameterT>
  std::vector<ParameterT> declare_parameters(
    const std::string & namespace_,
    const std::map<std::string, std::pair<ParameterT, rcl_interfaces::msg::ParameterDescriptor>> & parameters,
    bool ignore_overrides = false)
  {
    std::vector<ParameterT> values;
    for (const auto & [name, given] : parameters) {
      values.push_back(
        declare_parameter(
          namespace_.empty() ? name : namespace_ + "." + name, given.first, given.second,
          ignore_overrides));
    }
    return values;
  }

  void undeclare_parameter(const std::string & name);
  bool has_parameter(const std::string & name) const;
  rcl_interfaces::msg::SetParametersResult set_parameter(const Parameter & parameter);
  std::vector<rcl_interfaces::msg::SetParametersResult> set_parameters(
    const std::vector<Parameter> & parameters);
  rcl_interfaces::msg::SetParametersResult set_parameters_atomically(
    const std::vector<Parameter> & parameters);

  Parameter get_parameter(const std::string & name) const;
  bool get_parameter(const std::string & name, Parameter & parameter) const;
  template<typename ParameterT>
  bool get_parameter(const std::string & name, ParameterT & parameter) const
  {
    Parameter found;
    const bool is_there = get_parameter(name, found);
    if (is_there) {
      parameter = static_cast<ParameterT>(found.get_value<ParameterT>());
    }
    return is_there;
  }
  template<typename ParameterT>
  bool get_parameter_or(
    const std::string & name, ParameterT & parameter, const ParameterT & alternative_value) const
  {
    const bool is_there = get_parameter(name, parameter);
    if (!is_there) {
      parameter = alternative_value;
    }
    return is_there;
  }
  template<typename ParameterT>
  ParameterT get_parameter_or(const std::string & name, const ParameterT & alternative_value) const
  {
    ParameterT parameter;
    get_parameter_or(name, parameter, alternative_value);
    return parameter;
  }
  std::vector<Parameter> get_parameters(const std::vector<std::string> & names) const;
  template<typename ParameterT>
  bool get_parameters(const std::string & prefix, std::map<std::string, ParameterT> & values) const
  {
    std::map<std::string, Parameter> found;
    const bool any = parameters_->get_parameters_by_prefix(prefix, found);
    for (const auto & one : found) {
      const Parameter & parameter = one.second;
      values[one.first] = static_cast<ParameterT>(parameter.get_value<ParameterT>());
    }
    return any;
  }

  rcl_interfaces::msg::ParameterDescriptor describe_parameter(const std::string & name) const;
  std::vector<rcl_interfaces::msg::ParameterDescriptor> describe_parameters(
    const std::vector<std::string> & names) const;
  std::vector<std::uint8_t> get_parameter_types(const std::vector<std::string> & names) const;
  rcl_interfaces::msg::ListParametersResult list_parameters(
    const std::vector<std::string> & prefixes, std::uint64_t depth) const;

  // Callbacks live as long as what these give back.
  [[nodiscard]] PreSetParametersCallbackHandle::SharedPtr add_pre_set_parameters_callback(
    PreSetParametersCallbackType callback);
  [[nodiscard]] OnSetParametersCallbackHandle::SharedPtr add_on_set_parameters_callback(
    OnSetParametersCallbackType callback);
  [[nodiscard]] PostSetParametersCallbackHandle::SharedPtr add_post_set_parameters_callback(
    PostSetParametersCallbackType callback);
  void remove_pre_set_parameters_callback(const PreSetParametersCallbackHandle * handler);
  void remove_on_set_parameters_callback(const OnSetParametersCallbackHandle * handler);
  void remove_post_set_parameters_callback(const PostSetParametersCallbackHandle * handler);

  // ---- the other nodes

  std::vector<std::string> get_node_names() const;
  NamesAndTypes get_topic_names_and_types() const;
  NamesAndTypes get_service_names_and_types() const;
  NamesAndTypes get_service_names_and_types_by_node(
    const std::string & node_name, const std::string & namespace_) const;
  std::size_t count_publishers(const std::string & topic_name) const;
  std::size_t count_subscribers(const std::string & topic_name) const;
  std::size_t count_clients(const std::string & service_name) const;
  std::size_t count_services(const std::string & service_name) const;
  std::vector<TopicEndpointInfo> get_publishers_info_by_topic(
    const std::string & topic_name, bool no_mangle = false) const;
  std::vector<TopicEndpointInfo> get_subscriptions_info_by_topic(
    const std::string & topic_name, bool no_mangle = false) const;

  /// An event for wait_for_graph_change, which sets it when nodes, topics or services come or go.
  Event::SharedPtr get_graph_event();
  void wait_for_graph_change(Event::SharedPtr event, std::chrono::nanoseconds timeout);

  node_interfaces::NodeBaseInterface::SharedPtr get_node_base_interface() {return base_;}
  node_interfaces::NodeParametersInterface::SharedPtr get_node_parameters_interface() {return parameters_;}
  node_interfaces::NodeGraphInterface::SharedPtr get_node_graph_interface() {return graph_;}
  node_interfaces::NodeClockInterface::SharedPtr get_node_clock_interface() {return clock_interface_;}
  node_interfaces::NodeLoggingInterface::SharedPtr get_node_logging_interface() {return logging_;}
  node_interfaces::NodeServicesInterface::SharedPtr get_node_services_interface()
  {
    return services_interface_;
  }
  node_interfaces::NodeTimeSourceInterface::SharedPtr get_node_time_source_interface()
  {
    return time_source_;
  }
  node_interfaces::NodeTimersInterface::SharedPtr get_node_timers_interface() {return timers_;}
  node_interfaces::NodeTopicsInterface::SharedPtr get_node_topics_interface() {return topics_;}
  node_interfaces::NodeTypeDescriptionsInterface::SharedPtr get_node_type_descriptions_interface()
  {
    return type_descriptions_;
  }
  node_interfaces::NodeWaitablesInterface::SharedPtr get_node_waitables_interface() {return waitables_;}

protected:
  Node(const Node & other, const std::string & sub_namespace);

private:
  struct Services;

  std::string extended(const std::string & name) const;
  QoS overridden(const std::string & topic, const QoS & qos, const PublisherOptionsBase & options);
  QoS overridden(const std::string & topic, const QoS & qos, const SubscriptionOptionsBase & options);

  NodeOptions options_;
  node_interfaces::NodeBaseInterface::SharedPtr base_;
  node_interfaces::NodeGraphInterface::SharedPtr graph_;
  Clock::SharedPtr clock_;
  node_interfaces::NodeClockInterface::SharedPtr clock_interface_;
  node_interfaces::NodeLoggingInterface::SharedPtr logging_;
  node_interfaces::NodeServicesInterface::SharedPtr services_interface_;
  node_interfaces::NodeTimersInterface::SharedPtr timers_;
  node_interfaces::NodeTopicsInterface::SharedPtr topics_;
  node_interfaces::NodeWaitablesInterface::SharedPtr waitables_;
  node_interfaces::NodeParametersInterface::SharedPtr parameters_;
  node_interfaces::NodeTypeDescriptionsInterface::SharedPtr type_descriptions_;
  node_interfaces::NodeTimeSourceInterface::SharedPtr time_source_;
  // What serves in the background; it uses all that stands above.
  std::shared_ptr<Services> services_;
  std::string sub_namespace_, effective_namespace_;
};

}  // namespace rclcpp
