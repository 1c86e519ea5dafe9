#include "rclcpp/detail/local_topic.hpp"

#include <algorithm>
#include <cstring>
#include <map>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "rclcpp/subscription_base.hpp"

namespace rclcpp::detail
{

namespace
{

/// Those that are still there; the others are forgotten.
template<typename T>
std::vector<std::shared_ptr<T>> living(std::vector<std::weak_ptr<T>> & known)
{
  std::vector<std::shared_ptr<T>> found;
  for (const auto & one : known) {
    if (auto lives = one.lock()) {
      found.push_back(std::move(lives));
    }
  }
  if (found.size() < known.size()) {
    known.assign(found.begin(), found.end());
  }
  return found;
}

/// As the middleware decides, of what matters within a process.
bool can_hear(const QoS & publisher, const QoS & subscription)
{
  const bool is_too_loose = publisher.reliability() == ReliabilityPolicy::BestEffort &&
    subscription.reliability() == ReliabilityPolicy::Reliable;
  const bool is_too_short = publisher.durability() == DurabilityPolicy::Volatile &&
    subscription.durability() == DurabilityPolicy::TransientLocal;
  return !is_too_loose && !is_too_short;
}

bool is_same(const rmw_gid_t & a, const rmw_gid_t & b)
{
  return std::memcmp(a.data, b.data, sizeof(a.data)) == 0;
}

/// Of messages that must not go on as they are.
std::shared_ptr<void> copied(const LocalOutbox & outbox, const std::shared_ptr<void> & message)
{
  return outbox.clone(message.get());
}

void keep(LocalOutbox & outbox, const std::shared_ptr<void> & message)
{
  outbox.kept.push_back(message);
  if (outbox.kept.size() > outbox.qos.depth()) {
    outbox.kept.pop_front();
  }
}

}  // namespace

LocalInbox::LocalInbox(
  const Context::SharedPtr & context, std::weak_ptr<SubscriptionBase> subscription, const QoS & qos,
  bool owns_messages)
: condition_(context), subscription_(std::move(subscription)), qos_(qos), owns_messages_(owns_messages)
{
}

void LocalInbox::put(std::shared_ptr<void> message)
{
  std::shared_ptr<void> dropped;  // what its destructor does is not to be waited for
  {
    const std::lock_guard lock(mutex_);
    messages_.push_back(std::move(message));
    if (messages_.size() > qos_.depth()) {
      dropped = std::move(messages_.front());
      messages_.pop_front();
    }
  }
  condition_.trigger();
}

void LocalInbox::before_wait()
{
  const std::lock_guard lock(mutex_);
  if (!messages_.empty()) {
    condition_.trigger();
  }
}

std::shared_ptr<void> LocalInbox::next()
{
  const std::lock_guard lock(mutex_);
  if (messages_.empty()) {
    return nullptr;
  }
  auto message = std::move(messages_.front());
  messages_.pop_front();
  return message;
}

void LocalInbox::execute()
{
  const auto subscription = subscription_.lock();
  auto message = subscription ? next() : nullptr;
  if (message) {
    MessageInfo info;
    info.get_rmw_message_info().from_intra_process = true;
    subscription->handle_message(message, info);
  }
}

std::shared_ptr<LocalTopic> LocalTopic::get(
  const std::shared_ptr<rcl_context_t> & context, const std::string & name,
  const rosidl_message_type_support_t & type)
{
  using Key = std::tuple<const rcl_context_t *, std::string, const void *>;
  static std::mutex mutex;
  static std::map<Key, std::weak_ptr<LocalTopic>> topics;
  const std::lock_guard lock(mutex);
  for (auto known = topics.begin(); known != topics.end(); ) {
    known = known->second.expired() ? topics.erase(known) : std::next(known);
  }
  auto & known = topics[{context.get(), name, &type}];
  auto topic = known.lock();
  if (!topic) {
    topic = std::make_shared<LocalTopic>();
    known = topic;
  }
  return topic;
}

void LocalTopic::add(const std::shared_ptr<LocalOutbox> & outbox)
{
  const std::lock_guard lock(mutex_);
  outboxes_.push_back(outbox);
}

void LocalTopic::add(const std::shared_ptr<LocalInbox> & inbox)
{
  const std::lock_guard lock(mutex_);
  inboxes_.push_back(inbox);
  if (inbox->qos().durability() != DurabilityPolicy::TransientLocal) {
    return;
  }
  for (const auto & outbox : living(outboxes_)) {
    for (const auto & message : outbox->kept) {
      inbox->put(inbox->owns_messages() ? copied(*outbox, message) : message);
    }
  }
}

bool LocalTopic::has_publisher(const rmw_gid_t & gid)
{
  const std::lock_guard lock(mutex_);
  const auto outboxes = living(outboxes_);
  return std::any_of(
    outboxes.begin(), outboxes.end(), [&](const auto & outbox) {return is_same(outbox->gid, gid);});
}

std::size_t LocalTopic::count(const LocalOutbox & outbox)
{
  const std::lock_guard lock(mutex_);
  return hearing(outbox).size();
}

std::vector<std::shared_ptr<LocalInbox>> LocalTopic::hearing(const LocalOutbox & outbox)
{
  auto found = living(inboxes_);
  const auto cannot = [&](const auto & inbox) {return !can_hear(outbox.qos, inbox->qos());};
  found.erase(std::remove_if(found.begin(), found.end(), cannot), found.end());
  return found;
}

std::shared_ptr<void> LocalTopic::publish(
  LocalOutbox & outbox, std::shared_ptr<void> message, bool is_needed)
{
  const std::lock_guard lock(mutex_);
  auto inboxes = hearing(outbox);
  // Those that share first: the last owner then gets the message itself, if nobody else has it.
  std::stable_partition(
    inboxes.begin(), inboxes.end(), [](const auto & inbox) {return !inbox->owns_messages();});
  std::shared_ptr<void> shared = is_needed || outbox.keeps() ? message : nullptr;
  for (std::size_t i = 0; i < inboxes.size(); ++i) {
    const bool is_last = i + 1 == inboxes.size();
    if (!inboxes[i]->owns_messages()) {
      shared = message;
      inboxes[i]->put(message);
    } else if (!is_last || shared) {
      inboxes[i]->put(copied(outbox, message));
    } else {
      inboxes[i]->put(std::move(message));
    }
  }
  if (outbox.keeps()) {
    keep(outbox, shared);
  }
  return shared;
}

void check_local_qos(const QoS & qos, const char * topic)
{
  const std::string about = "intraprocess communication on topic '" + std::string(topic) + "' ";
  if (qos.history() != HistoryPolicy::KeepLast) {
    throw std::invalid_argument(about + "allowed only with keep last history qos policy");
  }
  if (qos.depth() == 0) {
    throw std::invalid_argument(about + "is not allowed with a zero qos history depth value");
  }
}

}  // namespace rclcpp::detail
