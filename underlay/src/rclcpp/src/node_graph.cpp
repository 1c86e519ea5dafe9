#include <algorithm>
#include <functional>
#include <utility>

#include "graph_wait.hpp"
#include "rcl/graph.h"
#include "rclcpp/detail/check.hpp"
#include "rclcpp/node_interfaces/node_graph_interface.hpp"

namespace rclcpp
{

namespace
{

using node_interfaces::NodeGraphInterface;

rcl_allocator_t * allocator()
{
  static rcl_allocator_t instance = rcl_get_default_allocator();
  return &instance;
}

/// What `ask` fills in.
NodeGraphInterface::NamesAndTypes names_and_types(
  const std::function<rcl_ret_t(rcl_names_and_types_t &)> & ask)
{
  rcl_names_and_types_t found = rcl_get_zero_initialized_names_and_types();
  detail::check(ask(found), "failed to get names and types");
  NodeGraphInterface::NamesAndTypes result;
  for (std::size_t i = 0; i < found.names.size; ++i) {
    const auto & types = found.types[i];
    result[found.names.data[i]].assign(types.data, types.data + types.size);
  }
  detail::check(rcl_names_and_types_fini(&found), "could not destroy names and types");
  return result;
}

using Ask = rcl_ret_t (*)(
  const rcl_node_t *, rcutils_allocator_t *, const char *, bool, rcl_topic_endpoint_info_array_t *);

std::vector<TopicEndpointInfo> endpoints(
  Ask ask, const rcl_node_t & node, const std::string & topic, bool raw)
{
  rcl_topic_endpoint_info_array_t found = rcl_get_zero_initialized_topic_endpoint_info_array();
  detail::check(
    ask(&node, allocator(), topic.c_str(), raw, &found), "failed to get the endpoints of a topic");
  std::vector<TopicEndpointInfo> result;
  for (std::size_t i = 0; i < found.size; ++i) {
    result.emplace_back(found.info_array[i]);
  }
  detail::check(
    rcl_topic_endpoint_info_array_fini(&found, allocator()), "could not destroy endpoint info");
  return result;
}

using Count = rcl_ret_t (*)(const rcl_node_t *, const char *, std::size_t *);

std::size_t count(
  Count ask, node_interfaces::NodeBaseInterface & node, const std::string & name, bool is_service)
{
  const std::string full = node.resolve_topic_or_service_name(name, is_service);
  std::size_t found = 0;
  detail::check(ask(node.get_rcl_node_handle(), full.c_str(), &found), "could not count");
  return found;
}

}  // namespace

TopicEndpointInfo::TopicEndpointInfo(const rmw_topic_endpoint_info_t & info)
: node_name_(info.node_name), node_namespace_(info.node_namespace), topic_type_(info.topic_type),
  endpoint_type_(static_cast<rclcpp::EndpointType>(info.endpoint_type)),
  qos_profile_(
    {info.qos_profile.history, info.qos_profile.depth, false}, info.qos_profile),
  topic_type_hash_(info.topic_type_hash)
{
  std::copy(info.endpoint_gid, info.endpoint_gid + RMW_GID_STORAGE_SIZE, endpoint_gid_.begin());
}

namespace node_interfaces
{

NodeGraphInterface::NodeGraphInterface(NodeBaseInterface::SharedPtr node)
: node_(std::move(node))
{
}

NodeGraphInterface::NamesAndTypes NodeGraphInterface::get_topic_names_and_types(bool no_demangle) const
{
  return names_and_types(
    [&](auto & found) {
      return rcl_get_topic_names_and_types(
        node_->get_rcl_node_handle(), allocator(), no_demangle, &found);
    });
}

NodeGraphInterface::NamesAndTypes NodeGraphInterface::get_service_names_and_types() const
{
  return names_and_types(
    [&](auto & found) {
      return rcl_get_service_names_and_types(node_->get_rcl_node_handle(), allocator(), &found);
    });
}

NodeGraphInterface::NamesAndTypes NodeGraphInterface::get_service_names_and_types_by_node(
  const std::string & node_name, const std::string & namespace_) const
{
  return names_and_types(
    [&](auto & found) {
      return rcl_get_service_names_and_types_by_node(
        node_->get_rcl_node_handle(), allocator(), node_name.c_str(), namespace_.c_str(), &found);
    });
}

NodeGraphInterface::NamesAndTypes NodeGraphInterface::get_client_names_and_types_by_node(
  const std::string & node_name, const std::string & namespace_) const
{
  return names_and_types(
    [&](auto & found) {
      return rcl_get_client_names_and_types_by_node(
        node_->get_rcl_node_handle(), allocator(), node_name.c_str(), namespace_.c_str(), &found);
    });
}

NodeGraphInterface::NamesAndTypes NodeGraphInterface::get_publisher_names_and_types_by_node(
  const std::string & node_name, const std::string & namespace_, bool no_demangle) const
{
  return names_and_types(
    [&](auto & found) {
      return rcl_get_publisher_names_and_types_by_node(
        node_->get_rcl_node_handle(), allocator(), no_demangle, node_name.c_str(), namespace_.c_str(),
        &found);
    });
}

NodeGraphInterface::NamesAndTypes NodeGraphInterface::get_subscriber_names_and_types_by_node(
  const std::string & node_name, const std::string & namespace_, bool no_demangle) const
{
  return names_and_types(
    [&](auto & found) {
      return rcl_get_subscriber_names_and_types_by_node(
        node_->get_rcl_node_handle(), allocator(), no_demangle, node_name.c_str(), namespace_.c_str(),
        &found);
    });
}

std::vector<std::string> NodeGraphInterface::get_node_names() const
{
  std::vector<std::string> full;
  for (const auto & [name, name_space] : get_node_names_and_namespaces()) {
    full.push_back(name_space.back() == '/' ? name_space + name : name_space + "/" + name);
  }
  return full;
}

std::vector<std::pair<std::string, std::string>> NodeGraphInterface::get_node_names_and_namespaces() const
{
  rcutils_string_array_t names = rcutils_get_zero_initialized_string_array();
  rcutils_string_array_t spaces = rcutils_get_zero_initialized_string_array();
  detail::check(
    rcl_get_node_names(node_->get_rcl_node_handle(), *allocator(), &names, &spaces),
    "failed to get node names");
  std::vector<std::pair<std::string, std::string>> found;
  for (std::size_t i = 0; i < names.size; ++i) {
    found.emplace_back(names.data[i], spaces.data[i]);
  }
  const rcutils_ret_t names_done = rcutils_string_array_fini(&names);
  const rcutils_ret_t spaces_done = rcutils_string_array_fini(&spaces);
  if (names_done != RCUTILS_RET_OK || spaces_done != RCUTILS_RET_OK) {
    throw std::runtime_error("could not destroy node names");
  }
  return found;
}

bool NodeGraphInterface::wait_until(
  const std::function<bool()> & holds, std::chrono::nanoseconds timeout) const
{
  return detail::wait_for_graph(node_->get_shared_rcl_node_handle(), node_->get_context(), holds, timeout);
}

std::size_t NodeGraphInterface::count_publishers(const std::string & topic_name) const
{
  return count(rcl_count_publishers, *node_, topic_name, false);
}

std::size_t NodeGraphInterface::count_subscribers(const std::string & topic_name) const
{
  return count(rcl_count_subscribers, *node_, topic_name, false);
}

std::size_t NodeGraphInterface::count_clients(const std::string & service_name) const
{
  return count(rcl_count_clients, *node_, service_name, true);
}

std::size_t NodeGraphInterface::count_services(const std::string & service_name) const
{
  return count(rcl_count_services, *node_, service_name, true);
}

std::vector<TopicEndpointInfo> NodeGraphInterface::get_publishers_info_by_topic(
  const std::string & topic_name, bool no_mangle) const
{
  const auto full = no_mangle ? topic_name : node_->resolve_topic_or_service_name(topic_name, false);
  return endpoints(rcl_get_publishers_info_by_topic, *node_->get_rcl_node_handle(), full, no_mangle);
}

std::vector<TopicEndpointInfo> NodeGraphInterface::get_subscriptions_info_by_topic(
  const std::string & topic_name, bool no_mangle) const
{
  const auto full = no_mangle ? topic_name : node_->resolve_topic_or_service_name(topic_name, false);
  return endpoints(rcl_get_subscriptions_info_by_topic, *node_->get_rcl_node_handle(), full, no_mangle);
}

}  // namespace node_interfaces
}  // namespace rclcpp
