#include "network_flows.hpp"

#include <string>
#include <tuple>
#include <utility>

#include "rclcpp/detail/check.hpp"

namespace rclcpp
{

namespace
{

auto parts_of(const NetworkFlowEndpoint & endpoint)
{
  return std::make_tuple(
    endpoint.transport_protocol(), endpoint.internet_protocol(), endpoint.internet_address(),
    endpoint.transport_port(), endpoint.flow_label(), endpoint.dscp());
}

/// What `get`, a function of rcl, tells of a publisher or a subscription.
template<typename Parent, typename Get>
std::vector<NetworkFlowEndpoint> flows_of(const Parent & parent, Get get)
{
  rcl_allocator_t allocator = rcl_get_default_allocator();
  auto array = rcl_get_zero_initialized_network_flow_endpoint_array();
  detail::check(get(&parent, &allocator, &array), "failed to get network flow endpoints");
  const std::vector<NetworkFlowEndpoint> flows(
    array.network_flow_endpoint, array.network_flow_endpoint + array.size);
  detail::check(
    rcl_network_flow_endpoint_array_fini(&array), "failed to free network flow endpoints");
  return flows;
}

}  // namespace

NetworkFlowEndpoint::NetworkFlowEndpoint(const rcl_network_flow_endpoint_t & network_flow_endpoint)
: transport_(
    rcl_network_flow_endpoint_get_transport_protocol_string(network_flow_endpoint.transport_protocol)),
  internet_(
    rcl_network_flow_endpoint_get_internet_protocol_string(network_flow_endpoint.internet_protocol)),
  address_(network_flow_endpoint.internet_address),
  port_(network_flow_endpoint.transport_port),
  flow_label_(network_flow_endpoint.flow_label),
  dscp_(network_flow_endpoint.dscp)
{
}

bool operator==(const NetworkFlowEndpoint & left, const NetworkFlowEndpoint & right)
{
  return parts_of(left) == parts_of(right);
}

bool operator!=(const NetworkFlowEndpoint & left, const NetworkFlowEndpoint & right)
{
  return !(left == right);
}

std::ostream & operator<<(std::ostream & out, const NetworkFlowEndpoint & endpoint)
{
  const std::pair<const char *, std::string> fields[] = {
    {"transportProtocol", endpoint.transport_protocol()},
    {"internetProtocol", endpoint.internet_protocol()},
    {"transportPort", std::to_string(endpoint.transport_port())},
    {"flowLabel", std::to_string(endpoint.flow_label())},
    {"dscp", std::to_string(endpoint.dscp())},
    {"internetAddress", endpoint.internet_address()},
  };
  const char * before = "{";
  for (const auto & [name, value] : fields) {
    out << before << '"' << name << "\": \"" << value << '"';
    before = ", ";
  }
  return out << '}';
}

std::vector<NetworkFlowEndpoint> detail::network_flows(const rcl_publisher_t & publisher)
{
  return flows_of(publisher, rcl_publisher_get_network_flow_endpoints);
}

std::vector<NetworkFlowEndpoint> detail::network_flows(const rcl_subscription_t & subscription)
{
  return flows_of(subscription, rcl_subscription_get_network_flow_endpoints);
}

}  // namespace rclcpp
