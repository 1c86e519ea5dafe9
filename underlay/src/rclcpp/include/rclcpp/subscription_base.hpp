#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

#include "rcl/event.h"
#include "rcl/subscription.h"
#include "rclcpp/detail/entity.hpp"
#include "rclcpp/detail/event_callback.hpp"
#include "rclcpp/macros.hpp"
#include "rclcpp/message_info.hpp"
#include "rclcpp/network_flow_endpoint.hpp"
#include "rclcpp/node_interfaces/node_base_interface.hpp"
#include "rclcpp/qos.hpp"
#include "rclcpp/serialized_message.hpp"
#include "rclcpp/subscription_options.hpp"
#include "rosidl_runtime_c/message_type_support_struct.h"

namespace rclcpp
{

namespace detail
{
class LocalInbox;
class LocalTopic;
class TopicStatistics;
}  // namespace detail

/// What subscriptions of all types have in common.
class SubscriptionBase : public detail::Entity, public std::enable_shared_from_this<SubscriptionBase>
{
public:
  RCLCPP_SMART_PTR_ALIASES_ONLY(SubscriptionBase)
  RCLCPP_DISABLE_COPY(SubscriptionBase)
  using EventHandlers = std::unordered_map<rcl_subscription_event_type_t, std::shared_ptr<detail::Entity>>;

  /// How a callback wants its messages.
  enum class Form {shared, owned, bytes};

  /// Throws InvalidTopicNameError, RCLError, and std::invalid_argument where messages of this process cannot
  /// be handed over as the QoS demands.
  SubscriptionBase(
    const node_interfaces::NodeBaseInterface::SharedPtr & node, const std::string & topic,
    const rosidl_message_type_support_t & type_support, const QoS & qos,
    const SubscriptionOptionsBase & options, Form form = Form::shared);
  ~SubscriptionBase() override;

  const char * get_topic_name() const;
  std::size_t get_publisher_count() const;
  QoS get_actual_qos() const;
  /// Throws RCLError where the middleware cannot tell.
  std::vector<NetworkFlowEndpoint> get_network_flow_endpoints() const;
  std::shared_ptr<rcl_subscription_t> get_subscription_handle() {return handle_;}
  std::shared_ptr<const rcl_subscription_t> get_subscription_handle() const {return handle_;}

  /// Whether messages are given to the callback as bytes.
  bool is_serialized() const {return form_ == Form::bytes;}

  /// Whether the middleware leaves messages away by the filter of the options.
  bool is_cft_enabled() const;
  /// Throws RCLError where the middleware cannot filter.
  void set_content_filter(
    const std::string & filter_expression, const std::vector<std::string> & expression_parameters = {});
  ContentFilterOptions get_content_filter() const;

  // These take the next message without an executor; false when there is none.
  bool take_type_erased(void * message_out, MessageInfo & message_info_out);
  bool take_serialized(SerializedMessage & message_out, MessageInfo & message_info_out);

  virtual std::shared_ptr<void> create_message() = 0;
  virtual std::shared_ptr<SerializedMessage> create_serialized_message()
  {
    return std::make_shared<SerializedMessage>();
  }
  virtual void return_message(std::shared_ptr<void> & message) {message.reset();}
  virtual void return_serialized_message(std::shared_ptr<SerializedMessage> & message) {message.reset();}
  virtual void handle_message(std::shared_ptr<void> & message, const MessageInfo & message_info) = 0;
  virtual void handle_serialized_message(
    const std::shared_ptr<SerializedMessage> & message, const MessageInfo & message_info) = 0;

  /// Called with the number of messages that have come, from a thread of the middleware, also for those that
  /// came before. Throws std::invalid_argument for an empty function, RCLError.
  void set_on_new_message_callback(std::function<void(std::size_t)> callback);
  void clear_on_new_message_callback();

  detail::EntityKind kind() const noexcept override {return detail::EntityKind::subscription;}
  const void * rcl_entity() const noexcept override {return handle_.get();}
  std::shared_ptr<detail::Entity> companion() override;
  /// Those of the QoS that are looked at.
  const EventHandlers & get_event_handlers() const {return events_;}
  void execute() override;

private:
  bool is_handed_over(const MessageInfo & info) const;
  void measure(const MessageInfo & info) const;

  std::shared_ptr<rcl_subscription_t> handle_;
  detail::EventCallback on_new_;
  EventHandlers events_;
  Form form_;
  Context::SharedPtr context_;
  // Only where messages of this process are handed over without the middleware.
  std::shared_ptr<detail::LocalTopic> local_;
  std::shared_ptr<detail::LocalInbox> inbox_;
  // Only where they are wanted.
  std::shared_ptr<detail::TopicStatistics> statistics_;
};

}  // namespace rclcpp
