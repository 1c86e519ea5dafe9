#pragma once

#include <cstddef>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "rclcpp/detail/entity.hpp"
#include "rclcpp/detail/local_message.hpp"
#include "rclcpp/guard_condition.hpp"
#include "rclcpp/qos.hpp"
#include "rmw/types.h"
#include "rosidl_runtime_c/message_type_support_struct.h"

namespace rclcpp
{
class SubscriptionBase;

namespace detail
{

/// Where messages of publishers of the same process wait for a subscription.
class LocalInbox : public Entity
{
public:
  LocalInbox(
    const Context::SharedPtr & context, std::weak_ptr<SubscriptionBase> subscription, const QoS & qos,
    bool owns_messages);

  const QoS & qos() const {return qos_;}
  /// Whether the callback may change what it gets, so that nobody else may have the same message.
  bool owns_messages() const {return owns_messages_;}
  /// The oldest one goes when there is no room.
  void put(std::shared_ptr<void> message);

  EntityKind kind() const noexcept override {return EntityKind::guard_condition;}
  const void * rcl_entity() const noexcept override {return &condition_.get_rcl_guard_condition();}
  void before_wait() override;
  void execute() override;

private:
  std::shared_ptr<void> next();

  GuardCondition condition_;
  std::weak_ptr<SubscriptionBase> subscription_;
  const QoS qos_;
  const bool owns_messages_;
  std::mutex mutex_;
  std::deque<std::shared_ptr<void>> messages_;
};

/// What a publisher has told those of its process. Where it keeps messages, those that come later get them.
struct LocalOutbox
{
  rmw_gid_t gid;
  QoS qos;
  CloneMessage clone;
  std::deque<std::shared_ptr<void>> kept;

  bool keeps() const {return qos.durability() == DurabilityPolicy::TransientLocal;}
};

/// A topic within one context: of publishers and subscriptions that hand messages over without the middleware.
class LocalTopic
{
public:
  /// The one for this name and type.
  static std::shared_ptr<LocalTopic> get(
    const std::shared_ptr<rcl_context_t> & context, const std::string & name,
    const rosidl_message_type_support_t & type);

  /// They leave when nobody holds them any more.
  void add(const std::shared_ptr<LocalOutbox> & outbox);
  void add(const std::shared_ptr<LocalInbox> & inbox);

  /// Whether the publisher of this identity hands its messages over itself.
  bool has_publisher(const rmw_gid_t & gid);
  /// How many inboxes hear the publisher.
  std::size_t count(const LocalOutbox & outbox);

  /// Gives the message to all who hear the publisher; each that owns messages gets one that nobody else has.
  /// With `is_needed`, it is given back unchanged for further use; else what is given back may be empty.
  std::shared_ptr<void> publish(LocalOutbox & outbox, std::shared_ptr<void> message, bool is_needed);

private:
  std::vector<std::shared_ptr<LocalInbox>> hearing(const LocalOutbox & outbox);

  std::mutex mutex_;
  std::vector<std::weak_ptr<LocalOutbox>> outboxes_;
  std::vector<std::weak_ptr<LocalInbox>> inboxes_;
};

/// Throws std::invalid_argument unless a queue of this kind can be kept within the process.
void check_local_qos(const QoS & qos, const char * topic);

}  // namespace detail
}  // namespace rclcpp
