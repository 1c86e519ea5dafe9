#include "rclcpp/subscription_base.hpp"

#include <utility>

#include "intra_process.hpp"
#include "names.hpp"
#include "network_flows.hpp"
#include "qos_actual.hpp"
#include "qos_events.hpp"
#include "rclcpp/detail/check.hpp"
#include "rclcpp/detail/local_topic.hpp"
#include "topic_statistics.hpp"

namespace rclcpp
{

namespace
{

std::vector<const char *> c_strings(const std::vector<std::string> & texts)
{
  std::vector<const char *> strings;
  for (const auto & text : texts) {
    strings.push_back(text.c_str());
  }
  return strings;
}

void set_filter(rcl_subscription_options_t & options, const ContentFilterOptions & filter)
{
  auto parameters = c_strings(filter.expression_parameters);
  detail::check(
    rcl_subscription_options_set_content_filter_options(
      filter.filter_expression.c_str(), parameters.size(), parameters.data(), &options),
    "failed to set the content filter");
}

/// What rcl has made of a filter, for as long as this lives.
class FilterOptions
{
public:
  FilterOptions(
    const rcl_subscription_t & subscription, rcl_subscription_content_filter_options_t & options)
  : subscription_(subscription), options_(options) {}
  FilterOptions(const FilterOptions &) = delete;
  FilterOptions & operator=(const FilterOptions &) = delete;
  ~FilterOptions()
  {
    if (rcl_subscription_content_filter_options_fini(&subscription_, &options_) != RCL_RET_OK) {
      rcl_reset_error();
    }
  }

private:
  const rcl_subscription_t & subscription_;
  rcl_subscription_content_filter_options_t & options_;
};

std::shared_ptr<rcl_subscription_t> make_subscription(
  std::shared_ptr<rcl_node_t> node, const std::string & topic,
  const rosidl_message_type_support_t & type_support, const QoS & qos,
  const SubscriptionOptionsBase & given)
{
  auto subscription = std::make_unique<rcl_subscription_t>(rcl_get_zero_initialized_subscription());
  rcl_subscription_options_t options = rcl_subscription_get_default_options();
  options.qos = qos.get_rmw_qos_profile();
  options.rmw_subscription_options.require_unique_network_flow_endpoints =
    given.require_unique_network_flow_endpoints;
  options.rmw_subscription_options.ignore_local_publications = given.ignore_local_publications;
  if (!given.content_filter_options.filter_expression.empty()) {
    set_filter(options, given.content_filter_options);
  }
  // The filter is the subscription's from here on: it frees it.
  const rcl_ret_t ret =
    rcl_subscription_init(subscription.get(), node.get(), &type_support, topic.c_str(), &options);
  if (ret != RCL_RET_OK) {
    detail::throw_for_name(ret, *node, topic.c_str(), false, "could not create subscription");
  }
  return {subscription.release(), [node = std::move(node)](rcl_subscription_t * gone) {
      if (rcl_subscription_fini(gone, node.get()) != RCL_RET_OK) {
        rcl_reset_error();
      }
      std::default_delete<rcl_subscription_t>()(gone);
    }};
}

/// Whether something was taken.
bool was_taken(rcl_ret_t ret)
{
  if (ret == RCL_RET_SUBSCRIPTION_TAKE_FAILED) {
    rcl_reset_error();
    return false;
  }
  detail::check(ret, "failed to take a message");
  return true;
}

}  // namespace

SubscriptionBase::SubscriptionBase(
  const node_interfaces::NodeBaseInterface::SharedPtr & node, const std::string & topic,
  const rosidl_message_type_support_t & type_support, const QoS & qos,
  const SubscriptionOptionsBase & options, Form form)
: handle_(make_subscription(node->get_shared_rcl_node_handle(), topic, type_support, qos, options)),
  events_(detail::subscription_events(handle_, *node->get_rcl_node_handle(), options)),
  form_(form),
  context_(node->get_context()),
  statistics_(detail::TopicStatistics::make(node, options))
{
  if (detail::uses_intra_process(options.use_intra_process_comm, *node) && form != Form::bytes) {
    detail::check_local_qos(get_actual_qos(), get_topic_name());
    local_ = detail::LocalTopic::get(context_->get_rcl_context(), get_topic_name(), type_support);
  }
  for (const auto & [type, event] : events_) {
    node->add(event, options.callback_group);
  }
}

SubscriptionBase::~SubscriptionBase()
{
  try {
    clear_on_new_message_callback();  // others may hold the handle for longer
  } catch (const std::exception &) {
    rcl_reset_error();
  }
}

void SubscriptionBase::set_on_new_message_callback(std::function<void(std::size_t)> callback)
{
  on_new_.set(
    std::move(callback), [this](rcl_event_callback_t function, const void * data) {
      return rcl_subscription_set_on_new_message_callback(handle_.get(), function, data);
    }, "set_on_new_message_callback");
}

void SubscriptionBase::clear_on_new_message_callback()
{
  on_new_.clear(
    [this](rcl_event_callback_t function, const void * data) {
      return rcl_subscription_set_on_new_message_callback(handle_.get(), function, data);
    });
}

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

std::vector<NetworkFlowEndpoint> SubscriptionBase::get_network_flow_endpoints() const
{
  return detail::network_flows(*handle_);
}

QoS SubscriptionBase::get_actual_qos() const
{
  return detail::actual_qos(rcl_subscription_get_actual_qos(handle_.get()));
}

bool SubscriptionBase::is_cft_enabled() const
{
  return rcl_subscription_is_cft_enabled(handle_.get());
}

void SubscriptionBase::set_content_filter(
  const std::string & filter_expression, const std::vector<std::string> & expression_parameters)
{
  auto parameters = c_strings(expression_parameters);
  auto options = rcl_get_zero_initialized_subscription_content_filter_options();
  detail::check(
    rcl_subscription_content_filter_options_init(
      handle_.get(), filter_expression.c_str(), parameters.size(), parameters.data(), &options),
    "failed to init subscription content_filtered_topic option");
  const rcl_ret_t ret = rcl_subscription_set_content_filter(handle_.get(), &options);
  const FilterOptions gone(*handle_, options);
  detail::check(ret, "failed to set cft expression parameters");
}

ContentFilterOptions SubscriptionBase::get_content_filter() const
{
  auto options = rcl_get_zero_initialized_subscription_content_filter_options();
  detail::check(
    rcl_subscription_get_content_filter(handle_.get(), &options), "failed to get cft expression parameters");
  const FilterOptions gone(*handle_, options);
  const auto & found = options.rmw_subscription_content_filter_options;
  const auto & words = found.expression_parameters;
  return {found.filter_expression, {words.data, words.data + words.size}};
}

bool SubscriptionBase::take_type_erased(void * message_out, MessageInfo & message_info_out)
{
  return was_taken(
    rcl_take(handle_.get(), message_out, &message_info_out.get_rmw_message_info(), nullptr));
}

bool SubscriptionBase::take_serialized(SerializedMessage & message_out, MessageInfo & message_info_out)
{
  return was_taken(
    rcl_take_serialized_message(
      handle_.get(), &message_out.get_rcl_serialized_message(), &message_info_out.get_rmw_message_info(),
      nullptr));
}

std::shared_ptr<detail::Entity> SubscriptionBase::companion()
{
  if (local_ && !inbox_) {
    inbox_ = std::make_shared<detail::LocalInbox>(
      context_, weak_from_this(), get_actual_qos(), form_ == Form::owned);
    local_->add(inbox_);
  }
  return inbox_;
}

bool SubscriptionBase::is_handed_over(const MessageInfo & info) const
{
  return local_ && local_->has_publisher(info.get_rmw_message_info().publisher_gid);
}

void SubscriptionBase::measure(const MessageInfo & info) const
{
  if (statistics_) {
    statistics_->add(info.get_rmw_message_info().source_timestamp);
  }
}

void SubscriptionBase::execute()
{
  MessageInfo info;
  if (is_serialized()) {
    const auto message = std::make_shared<SerializedMessage>();
    if (take_serialized(*message, info)) {
      measure(info);
      handle_serialized_message(message, info);
    }
    return;
  }
  auto message = create_message();
  if (take_type_erased(message.get(), info) && !is_handed_over(info)) {
    measure(info);
    handle_message(message, info);
  }
}

}  // namespace rclcpp
