#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "rcl/subscription.h"
#include "rclcpp/detail/entity.hpp"
#include "rclcpp/macros.hpp"
#include "rclcpp/message_info.hpp"
#include "rclcpp/node_interfaces/node_base_interface.hpp"
#include "rclcpp/qos.hpp"
#include "rclcpp/serialized_message.hpp"
#include "rclcpp/subscription_options.hpp"
#include "rosidl_runtime_c/message_type_support_struct.h"

namespace rclcpp
{

/// What subscriptions of all types have in common.
class SubscriptionBase : public detail::Entity, public std::enable_shared_from_this<SubscriptionBase>
{
public:
  RCLCPP_SMART_PTR_ALIASES_ONLY(SubscriptionBase)
  RCLCPP_DISABLE_COPY(SubscriptionBase)

  /// Throws InvalidTopicNameError, RCLError.
  SubscriptionBase(
    const node_interfaces::NodeBaseInterface::SharedPtr & node, const std::string & topic,
    const rosidl_message_type_support_t & type_support, const QoS & qos,
    const SubscriptionOptionsBase & options, bool is_serialized = false);
  ~SubscriptionBase() override;

  const char * get_topic_name() const;
  std::size_t get_publisher_count() const;
  QoS get_actual_qos() const;
  std::shared_ptr<rcl_subscription_t> get_subscription_handle() {return handle_;}

  /// Whether messages are given to the callback as bytes.
  bool is_serialized() const {return is_serialized_;}

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
  virtual void handle_message(std::shared_ptr<void> & message, const MessageInfo & message_info) = 0;
  virtual void handle_serialized_message(
    const std::shared_ptr<SerializedMessage> & message, const MessageInfo & message_info) = 0;

  detail::EntityKind kind() const noexcept override {return detail::EntityKind::subscription;}
  const void * rcl_entity() const noexcept override {return handle_.get();}
  void execute() override;

private:
  std::shared_ptr<rcl_subscription_t> handle_;
  std::vector<std::shared_ptr<detail::Entity>> events_;
  bool is_serialized_;
};

}  // namespace rclcpp
