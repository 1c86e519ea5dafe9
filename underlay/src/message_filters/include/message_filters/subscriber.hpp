#pragma once

#include <memory>
#include <string>

#include "message_filters/simple_filter.hpp"
#include "rclcpp/rclcpp.hpp"

namespace message_filters
{

/// What subscribers of all types of messages have in common.
template<class NodeType = rclcpp::Node>
class SubscriberBase
{
public:
  using NodePtr = std::shared_ptr<NodeType>;

  virtual ~SubscriberBase() = default;

  virtual void subscribe(
    NodePtr node, const std::string & topic, const rmw_qos_profile_t qos = rmw_qos_profile_default) = 0;
  virtual void subscribe(
    NodeType * node, const std::string & topic, const rmw_qos_profile_t qos = rmw_qos_profile_default) = 0;
  virtual void subscribe(
    NodePtr node, const std::string & topic, const rmw_qos_profile_t qos,
    rclcpp::SubscriptionOptions options) = 0;
  virtual void subscribe(
    NodeType * node, const std::string & topic, const rmw_qos_profile_t qos,
    rclcpp::SubscriptionOptions options) = 0;
  /// Subscribes as before; does nothing if there was no topic yet.
  virtual void subscribe() = 0;
  virtual void unsubscribe() = 0;
};

template<typename T>
using SubscriberBasePtr = std::shared_ptr<SubscriberBase<T>>;

template<typename M, bool is_adapter = rclcpp::is_type_adapter<M>::value>
struct message_type
{
  using type = M;
};
template<typename M>
struct message_type<M, true>
{
  using type = typename M::custom_type;
};
template<typename M>
using message_type_t = typename message_type<M>::type;

/// Passes on what comes on a topic.
template<class M, class NodeType = rclcpp::Node>
class Subscriber : public SubscriberBase<NodeType>, public SimpleFilter<message_type_t<M>>
{
public:
  using NodePtr = std::shared_ptr<NodeType>;
  using MessageType = message_type_t<M>;
  using EventType = MessageEvent<MessageType const>;

  Subscriber() = default;
  Subscriber(
    NodePtr node, const std::string & topic, const rmw_qos_profile_t qos = rmw_qos_profile_default)
  {
    subscribe(node, topic, qos);
  }
  Subscriber(
    NodeType * node, const std::string & topic, const rmw_qos_profile_t qos = rmw_qos_profile_default)
  {
    subscribe(node, topic, qos);
  }
  Subscriber(
    NodePtr node, const std::string & topic, const rmw_qos_profile_t qos,
    rclcpp::SubscriptionOptions options)
  {
    subscribe(node, topic, qos, options);
  }
  Subscriber(
    NodeType * node, const std::string & topic, const rmw_qos_profile_t qos,
    rclcpp::SubscriptionOptions options)
  {
    subscribe(node, topic, qos, options);
  }
  ~Subscriber() override {unsubscribe();}

  void subscribe(
    NodePtr node, const std::string & topic, const rmw_qos_profile_t qos = rmw_qos_profile_default) override
  {
    subscribe(node, topic, qos, rclcpp::SubscriptionOptions());
  }
  void subscribe(
    NodeType * node, const std::string & topic,
    const rmw_qos_profile_t qos = rmw_qos_profile_default) override
  {
    subscribe(node, topic, qos, rclcpp::SubscriptionOptions());
  }
  void subscribe(
    NodePtr node, const std::string & topic, const rmw_qos_profile_t qos,
    rclcpp::SubscriptionOptions options) override
  {
    subscribe(node.get(), topic, qos, options);
    kept_ = node;
  }
  void subscribe(
    NodeType * node, const std::string & topic, const rmw_qos_profile_t qos,
    rclcpp::SubscriptionOptions options) override
  {
    unsubscribe();
    if (topic.empty()) {
      return;
    }
    node_ = node;
    kept_.reset();
    topic_ = topic;
    qos_ = qos;
    options_ = options;
    subscribe();
  }
  void subscribe() override
  {
    unsubscribe();
    if (topic_.empty()) {
      return;
    }
    subscription_ = node_->template create_subscription<M>(
      topic_, rclcpp::QoS(rclcpp::QoSInitialization::from_rmw(qos_), qos_),
      [this](const std::shared_ptr<MessageType const> message) {this->signalMessage(EventType(message));},
      options_);
  }
  void unsubscribe() override {subscription_.reset();}

  std::string getTopic() const {return topic_;}
  const typename rclcpp::Subscription<M>::SharedPtr getSubscriber() const {return subscription_;}

  // A subscriber has no input.
  template<typename F>
  void connectInput(F &) {}
  void add(const EventType &) {}

private:
  NodePtr kept_;
  NodeType * node_ = nullptr;
  std::string topic_;
  rmw_qos_profile_t qos_ = rmw_qos_profile_default;
  rclcpp::SubscriptionOptions options_;
  typename rclcpp::Subscription<M>::SharedPtr subscription_;
};

}  // namespace message_filters
