#include "rclcpp/publisher_base.hpp"

#include <utility>

#include "intra_process.hpp"
#include "names.hpp"
#include "network_flows.hpp"
#include "qos_actual.hpp"
#include "qos_events.hpp"
#include "rclcpp/detail/check.hpp"
#include "rclcpp/detail/local_topic.hpp"
#include "rclcpp/logging.hpp"
#include "rmw/rmw.h"

namespace rclcpp
{

namespace
{

std::shared_ptr<rcl_publisher_t> make_publisher(
  std::shared_ptr<rcl_node_t> node, const std::string & topic,
  const rosidl_message_type_support_t & type_support, const QoS & qos,
  const PublisherOptionsBase & given)
{
  auto publisher = std::make_unique<rcl_publisher_t>(rcl_get_zero_initialized_publisher());
  rcl_publisher_options_t options = rcl_publisher_get_default_options();
  options.qos = qos.get_rmw_qos_profile();
  options.rmw_publisher_options.require_unique_network_flow_endpoints =
    given.require_unique_network_flow_endpoints;
  const rcl_ret_t ret =
    rcl_publisher_init(publisher.get(), node.get(), &type_support, topic.c_str(), &options);
  if (ret != RCL_RET_OK) {
    detail::throw_for_name(ret, *node, topic.c_str(), false, "could not create publisher");
  }
  return {publisher.release(), [node = std::move(node)](rcl_publisher_t * gone) {
      if (rcl_publisher_fini(gone, node.get()) != RCL_RET_OK) {
        rcl_reset_error();
      }
      std::default_delete<rcl_publisher_t>()(gone);
    }};
}

QoS qos_of(const rcl_publisher_options_t & options)
{
  return QoS(QoSInitialization::from_rmw(options.qos), options.qos);
}

PublisherOptionsBase options_of(
  const rcl_publisher_options_t & rcl_options, const PublisherEventCallbacks & event_callbacks,
  bool use_default_callbacks)
{
  PublisherOptionsBase options;
  options.event_callbacks = event_callbacks;
  options.use_default_callbacks = use_default_callbacks;
  options.require_unique_network_flow_endpoints =
    rcl_options.rmw_publisher_options.require_unique_network_flow_endpoints;
  return options;
}

}  // namespace

PublisherBase::PublisherBase(
  node_interfaces::NodeBaseInterface * node_base, const std::string & topic,
  const rosidl_message_type_support_t & type_support, const rcl_publisher_options_t & publisher_options,
  const PublisherEventCallbacks & event_callbacks, bool use_default_callbacks)
: PublisherBase(
    node_base->shared_from_this(), topic, type_support, qos_of(publisher_options),
    options_of(publisher_options, event_callbacks, use_default_callbacks))
{
}

PublisherBase::PublisherBase(
  const node_interfaces::NodeBaseInterface::SharedPtr & node, const std::string & topic,
  const rosidl_message_type_support_t & type_support, const QoS & qos, const PublisherOptionsBase & options,
  detail::CloneMessage clone)
: context_(node->get_context()),
  handle_(make_publisher(node->get_shared_rcl_node_handle(), topic, type_support, qos, options)),
  events_(detail::publisher_events(handle_, *node->get_rcl_node_handle(), options))
{
  const rmw_publisher_t * at_rmw = rcl_publisher_get_rmw_handle(handle_.get());
  if (!at_rmw || rmw_get_gid_for_publisher(at_rmw, &gid_) != RMW_RET_OK) {
    exceptions::throw_from_rcl_error(RCL_RET_ERROR, "failed to get publisher gid");
  }
  if (clone && detail::uses_intra_process(options.use_intra_process_comm, *node)) {
    detail::check_local_qos(get_actual_qos(), get_topic_name());
    local_ = detail::LocalTopic::get(context_->get_rcl_context(), get_topic_name(), type_support);
    outbox_ = std::make_shared<detail::LocalOutbox>(
      detail::LocalOutbox{gid_, get_actual_qos(), clone, {}});
    local_->add(outbox_);
  }
  for (const auto & [type, event] : events_) {
    node->add(event, options.callback_group);
  }
}

PublisherBase::~PublisherBase() = default;

const char * PublisherBase::get_topic_name() const
{
  return rcl_publisher_get_topic_name(handle_.get());
}

std::size_t PublisherBase::get_queue_size() const
{
  return get_actual_qos().depth();
}

const rmw_gid_t & PublisherBase::get_gid() const
{
  return gid_;
}

std::size_t PublisherBase::get_subscription_count() const
{
  if (!context_->is_valid()) {
    return 0;
  }
  std::size_t count = 0;
  detail::check(
    rcl_publisher_get_subscription_count(handle_.get(), &count),
    "failed to get get subscription count");
  return count;
}

std::size_t PublisherBase::get_intra_process_subscription_count() const
{
  return local_ ? local_->count(*outbox_) : 0;
}

bool PublisherBase::needs_middleware() const
{
  // What is kept may be asked for later, by others as well.
  return outbox_->keeps() || get_subscription_count() > get_intra_process_subscription_count();
}

bool PublisherBase::assert_liveliness() const
{
  const bool asserted = rcl_publisher_assert_liveliness(handle_.get()) == RCL_RET_OK;
  if (!asserted) {
    rcl_reset_error();
  }
  return asserted;
}

std::vector<NetworkFlowEndpoint> PublisherBase::get_network_flow_endpoints() const
{
  return detail::network_flows(*handle_);
}

QoS PublisherBase::get_actual_qos() const
{
  return detail::actual_qos(rcl_publisher_get_actual_qos(handle_.get()));
}

bool PublisherBase::can_loan_messages() const
{
  return !local_ && rcl_publisher_can_loan_messages(handle_.get());
}

bool PublisherBase::wait_for_all_acked(std::chrono::nanoseconds timeout) const
{
  const rcl_ret_t ret = rcl_publisher_wait_for_all_acked(handle_.get(), timeout.count());
  if (ret == RCL_RET_TIMEOUT) {
    rcl_reset_error();
    return false;
  }
  detail::check(ret, "failed to wait for acknowledgments");
  return true;
}

void PublisherBase::tell_of_loans() const
{
  if (!can_loan_messages()) {
    RCLCPP_INFO_ONCE(
      get_logger("rclcpp"),
      "Currently used middleware can't loan messages. Local allocator will be used.");
  }
}

void PublisherBase::check_published(rcl_ret_t ret, const char * doing) const
{
  if (ret == RCL_RET_PUBLISHER_INVALID && !context_->is_valid()) {
    rcl_reset_error();  // after a shutdown nobody is left to hear it
    return;
  }
  detail::check(ret, doing);
}

void PublisherBase::publish_untyped(const void * message)
{
  if (local_ && (outbox_->keeps() || get_intra_process_subscription_count() > 0)) {
    publish_owned(outbox_->clone(message));
  } else {
    publish_elsewhere(message);
  }
}

void PublisherBase::publish_owned(std::shared_ptr<void> message)
{
  const bool is_needed = needs_middleware();
  const auto shared = local_->publish(*outbox_, std::move(message), is_needed);
  if (is_needed) {
    publish_elsewhere(shared.get());
  }
}

void PublisherBase::publish_elsewhere(const void * message)
{
  check_published(rcl_publish(handle_.get(), message, nullptr), "failed to publish message");
}

void PublisherBase::publish_serialized(const rcl_serialized_message_t & message)
{
  if (local_) {
    throw std::runtime_error("storing serialized messages in intra process is not supported yet");
  }
  check_published(
    rcl_publish_serialized_message(handle_.get(), &message, nullptr),
    "failed to publish serialized message");
}

}  // namespace rclcpp
