#pragma once

#include <chrono>
#include <cstddef>
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

#include "rcl/event.h"
#include "rcl/publisher.h"
#include "rclcpp/detail/entity.hpp"
#include "rclcpp/detail/local_message.hpp"
#include "rclcpp/macros.hpp"
#include "rclcpp/network_flow_endpoint.hpp"
#include "rclcpp/node_interfaces/node_base_interface.hpp"
#include "rclcpp/publisher_options.hpp"
#include "rclcpp/qos.hpp"
#include "rosidl_runtime_c/message_type_support_struct.h"

namespace rclcpp
{

namespace detail
{
class LocalTopic;
struct LocalOutbox;
}  // namespace detail

/// What publishers of all types have in common.
class PublisherBase
{
public:
  RCLCPP_SMART_PTR_ALIASES_ONLY(PublisherBase)
  RCLCPP_DISABLE_COPY(PublisherBase)
  using EventHandlers = std::unordered_map<rcl_publisher_event_type_t, std::shared_ptr<detail::Entity>>;

  /// Throws InvalidTopicNameError, RCLError, and std::invalid_argument where messages cannot be handed over
  /// to subscriptions of this process as the QoS demands. Without `clone` they are not handed over at all.
  PublisherBase(
    const node_interfaces::NodeBaseInterface::SharedPtr & node, const std::string & topic,
    const rosidl_message_type_support_t & type_support, const QoS & qos,
    const PublisherOptionsBase & options, detail::CloneMessage clone = nullptr);
  /// The same, of options of rcl.
  PublisherBase(
    node_interfaces::NodeBaseInterface * node_base, const std::string & topic,
    const rosidl_message_type_support_t & type_support, const rcl_publisher_options_t & publisher_options,
    const PublisherEventCallbacks & event_callbacks, bool use_default_callbacks);
  virtual ~PublisherBase();

  const char * get_topic_name() const;
  std::size_t get_queue_size() const;
  const rmw_gid_t & get_gid() const;
  std::size_t get_subscription_count() const;
  /// Of those in this process to which messages are handed over.
  std::size_t get_intra_process_subscription_count() const;
  bool assert_liveliness() const;
  QoS get_actual_qos() const;
  /// Throws RCLError where the middleware cannot tell.
  std::vector<NetworkFlowEndpoint> get_network_flow_endpoints() const;
  bool can_loan_messages() const;
  /// Those of the QoS that are looked at.
  const EventHandlers & get_event_handlers() const {return events_;}

  /// Logs once when the middleware cannot loan messages.
  void tell_of_loans() const;
  std::shared_ptr<rcl_publisher_t> get_publisher_handle() {return handle_;}
  std::shared_ptr<const rcl_publisher_t> get_publisher_handle() const {return handle_;}

  /// Waits until every reliable subscription has what was published; a negative time waits for ever.
  template<typename Rep = std::int64_t, typename Period = std::milli>
  bool wait_for_all_acked(
    std::chrono::duration<Rep, Period> timeout = std::chrono::duration<Rep, Period>(-1)) const
  {
    return wait_for_all_acked(std::chrono::duration_cast<std::chrono::nanoseconds>(timeout));
  }
  bool wait_for_all_acked(std::chrono::nanoseconds timeout) const;

protected:
  bool hands_over() const {return local_ != nullptr;}
  void publish_untyped(const void * message);
  void publish_owned(std::shared_ptr<void> message);
  void publish_serialized(const rcl_serialized_message_t & message);

private:
  bool needs_middleware() const;
  void publish_elsewhere(const void * message);
  void check_published(rcl_ret_t ret, const char * doing) const;

  Context::SharedPtr context_;
  std::shared_ptr<rcl_publisher_t> handle_;
  EventHandlers events_;
  rmw_gid_t gid_;
  // Only where messages are handed over to subscriptions of this process.
  std::shared_ptr<detail::LocalTopic> local_;
  std::shared_ptr<detail::LocalOutbox> outbox_;
};

}  // namespace rclcpp
