#include "rclcpp/subscription_base.hpp"

#include <utility>

#include "names.hpp"
#include "qos_actual.hpp"
#include "qos_events.hpp"
#include "rclcpp/detail/check.hpp"

namespace rclcpp
{

namespace
{

void set_filter(rcl_subscription_options_t & options, const ContentFilterOptions & filter)
{
  std::vector<const char *> parameters;
  for (const auto & parameter : filter.expression_parameters) {
    parameters.push_back(parameter.c_str());
  }
  detail::check(
    rcl_subscription_options_set_content_filter_options(
      filter.filter_expression.c_str(), parameters.size(), parameters.data(), &options),
    "failed to set the content filter");
}

std::shared_ptr<rcl_subscription_t> make_subscription(
  std::shared_ptr<rcl_node_t> node, const std::string & topic,
  const rosidl_message_type_support_t & type_support, const QoS & qos,
  const SubscriptionOptionsBase & given)
{
  auto subscription = std::make_unique<rcl_subscription_t>(rcl_get_zero_initialized_subscription());
  rcl_subscription_options_t options = rcl_subscription_get_default_options();
  options.qos = qos.get_rmw_qos_profile();
  options.rmw_subscription_options.ignore_local_publications = given.ignore_local_publications;
  if (!given.content_filter_options.filter_expression.empty()) {
    set_filter(options, given.content_filter_options);
  }
  const rcl_ret_t ret =
    rcl_subscription_init(subscription.get(), node.get(), &type_support, topic.c_str(), &options);
  const rcl_ret_t cleaned = rcl_subscription_options_fini(&options);
  if (ret != RCL_RET_OK) {
    detail::throw_for_name(ret, *node, topic.c_str(), false, "could not create subscription");
  }
  detail::check(cleaned, "failed to clean up the options of a subscription");
  return {subscription.release(), [node = std::move(node)](rcl_subscription_t * gone) {
      if (rcl_subscription_fini(gone, node.get()) != RCL_RET_OK) {
        rcl_reset_error();
      }
      std::default_delete<rcl_subscription_t>()(gone);
    }};
}

}  // namespace

SubscriptionBase::SubscriptionBase(
  const node_interfaces::NodeBaseInterface::SharedPtr & node, const std::string & topic,
  const rosidl_message_type_support_t & type_support, const QoS & qos,
  const SubscriptionOptionsBase & options)
: handle_(make_subscription(node->get_shared_rcl_node_handle(), topic, type_support, qos, options)),
  events_(detail::subscription_events(handle_, options))
{
  for (const auto & event : events_) {
    node->add(event, options.callback_group);
  }
}

SubscriptionBase::~SubscriptionBase() = default;

const char * SubscriptionBase::get_topic_name() const
{
  return rcl_subscription_get_topic_name(handle_.get());
}

std::size_t SubscriptionBase::get_publisher_count() const
{
  std::size_t count = 0;
  detail::check(
    rcl_subscription_get_publisher_count(handle_.get(), &count), "failed to get get publisher count");
  return count;
}

QoS SubscriptionBase::get_actual_qos() const
{
  return detail::actual_qos(rcl_subscription_get_actual_qos(handle_.get()));
}

bool SubscriptionBase::take_type_erased(void * message_out, MessageInfo & message_info_out)
{
  const rcl_ret_t ret =
    rcl_take(handle_.get(), message_out, &message_info_out.get_rmw_message_info(), nullptr);
  if (ret == RCL_RET_SUBSCRIPTION_TAKE_FAILED) {
    rcl_reset_error();
    return false;
  }
  detail::check(ret, "failed to take a message");
  return true;
}

void SubscriptionBase::execute()
{
  MessageInfo info;
  auto message = create_message();
  if (take_type_erased(message.get(), info)) {
    handle_message(message, info);
  }
}

}  // namespace rclcpp
