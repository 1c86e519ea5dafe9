#include "qos_events.hpp"

#include <functional>
#include <string>
#include <utility>

#include "rclcpp/detail/check.hpp"
#include "rclcpp/logging.hpp"

namespace rclcpp::detail
{

namespace
{

/// Calls back with what happened to `Parent`, a publisher or a subscription.
template<typename Info, typename Parent>
class Event : public Entity
{
public:
  Event(std::shared_ptr<Parent> parent, std::function<void(Info &)> callback)
  : parent_(std::move(parent)), callback_(std::move(callback))
  {
  }
  Event(const Event &) = delete;
  Event & operator=(const Event &) = delete;
  ~Event() override
  {
    if (rcl_event_fini(&event_) != RCL_RET_OK) {
      rcl_reset_error();
    }
  }

  rcl_event_t & get() {return event_;}
  EntityKind kind() const noexcept override {return EntityKind::event;}
  const void * rcl_entity() const noexcept override {return &event_;}

  void execute() override
  {
    Info info{};
    if (rcl_take_event(&event_, &info) != RCL_RET_OK) {
      rcl_reset_error();
      return;
    }
    callback_(info);
  }

private:
  std::shared_ptr<Parent> parent_;
  rcl_event_t event_ = rcl_get_zero_initialized_event();
  std::function<void(Info &)> callback_;
};

rcl_ret_t begin(rcl_event_t & event, const rcl_publisher_t & publisher, rcl_publisher_event_type_t type)
{
  return rcl_publisher_event_init(&event, &publisher, type);
}

rcl_ret_t begin(
  rcl_event_t & event, const rcl_subscription_t & subscription, rcl_subscription_event_type_t type)
{
  return rcl_subscription_event_init(&event, &subscription, type);
}

template<typename Parent, typename Type>
class Events
{
public:
  explicit Events(std::shared_ptr<Parent> parent) : parent_(std::move(parent)) {}

  template<typename Info>
  void add(const std::function<void(Info &)> & callback, Type type, bool is_asked_for = true)
  {
    if (!callback) {
      return;
    }
    auto event = std::make_shared<Event<Info, Parent>>(parent_, callback);
    const rcl_ret_t ret = begin(event->get(), *parent_, type);
    if (ret == RCL_RET_OK) {
      found_[type] = std::move(event);
    } else if (!is_asked_for) {
      rcl_reset_error();
    } else if (ret == RCL_RET_UNSUPPORTED) {
      const exceptions::UnsupportedEventTypeException error(
        ret, rcl_get_error_state(), "Failed to initialize event");
      rcl_reset_error();
      throw error;
    } else {
      exceptions::throw_from_rcl_error(ret, "Failed to initialize event");
    }
  }

  std::unordered_map<Type, std::shared_ptr<Entity>> take() {return std::move(found_);}

private:
  std::shared_ptr<Parent> parent_;
  std::unordered_map<Type, std::shared_ptr<Entity>> found_;
};

QOSOfferedIncompatibleQoSCallbackType warn_of_subscriptions(Logger logger, std::string topic)
{
  return [logger = std::move(logger), topic = std::move(topic)](QOSOfferedIncompatibleQoSInfo & info) {
           RCLCPP_WARN(
             logger,
             "New subscription discovered on topic '%s', requesting incompatible QoS. "
             "No messages will be sent to it. Last incompatible policy: %s",
             topic.c_str(), qos_policy_name_from_kind(info.last_policy_kind).c_str());
         };
}

QOSRequestedIncompatibleQoSCallbackType warn_of_publishers(Logger logger, std::string topic)
{
  return [logger = std::move(logger), topic = std::move(topic)](QOSRequestedIncompatibleQoSInfo & info) {
           RCLCPP_WARN(
             logger,
             "New publisher discovered on topic '%s', offering incompatible QoS. "
             "No messages will be sent to it. Last incompatible policy: %s",
             topic.c_str(), qos_policy_name_from_kind(info.last_policy_kind).c_str());
         };
}

}  // namespace

std::unordered_map<rcl_publisher_event_type_t, std::shared_ptr<Entity>> publisher_events(
  const std::shared_ptr<rcl_publisher_t> & publisher, const rcl_node_t & node,
  const PublisherOptionsBase & options)
{
  const auto & callbacks = options.event_callbacks;
  Events<rcl_publisher_t, rcl_publisher_event_type_t> events(publisher);
  events.add(callbacks.deadline_callback, RCL_PUBLISHER_OFFERED_DEADLINE_MISSED);
  events.add(callbacks.liveliness_callback, RCL_PUBLISHER_LIVELINESS_LOST);
  events.add(callbacks.incompatible_type_callback, RCL_PUBLISHER_INCOMPATIBLE_TYPE);
  events.add(callbacks.matched_callback, RCL_PUBLISHER_MATCHED);
  if (callbacks.incompatible_qos_callback) {
    events.add(callbacks.incompatible_qos_callback, RCL_PUBLISHER_OFFERED_INCOMPATIBLE_QOS);
  } else if (options.use_default_callbacks) {
    const auto warn =
      warn_of_subscriptions(get_node_logger(&node), rcl_publisher_get_topic_name(publisher.get()));
    events.add(warn, RCL_PUBLISHER_OFFERED_INCOMPATIBLE_QOS, false);
  }
  return events.take();
}

std::unordered_map<rcl_subscription_event_type_t, std::shared_ptr<Entity>> subscription_events(
  const std::shared_ptr<rcl_subscription_t> & subscription, const rcl_node_t & node,
  const SubscriptionOptionsBase & options)
{
  const auto & callbacks = options.event_callbacks;
  Events<rcl_subscription_t, rcl_subscription_event_type_t> events(subscription);
  events.add(callbacks.deadline_callback, RCL_SUBSCRIPTION_REQUESTED_DEADLINE_MISSED);
  events.add(callbacks.liveliness_callback, RCL_SUBSCRIPTION_LIVELINESS_CHANGED);
  events.add(callbacks.message_lost_callback, RCL_SUBSCRIPTION_MESSAGE_LOST);
  events.add(callbacks.incompatible_type_callback, RCL_SUBSCRIPTION_INCOMPATIBLE_TYPE);
  events.add(callbacks.matched_callback, RCL_SUBSCRIPTION_MATCHED);
  if (callbacks.incompatible_qos_callback) {
    events.add(callbacks.incompatible_qos_callback, RCL_SUBSCRIPTION_REQUESTED_INCOMPATIBLE_QOS);
  } else if (options.use_default_callbacks) {
    const auto warn =
      warn_of_publishers(get_node_logger(&node), rcl_subscription_get_topic_name(subscription.get()));
    events.add(warn, RCL_SUBSCRIPTION_REQUESTED_INCOMPATIBLE_QOS, false);
  }
  return events.take();
}

}  // namespace rclcpp::detail
