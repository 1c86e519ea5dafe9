#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "rclcpp/macros.hpp"
#include "rclcpp/node_interfaces/node_base_interface.hpp"
#include "rclcpp/qos.hpp"
#include "rmw/topic_endpoint_info.h"
#include "rosidl_runtime_c/type_hash.h"

namespace rclcpp
{

enum class EndpointType
{
  Invalid = RMW_ENDPOINT_INVALID,
  Publisher = RMW_ENDPOINT_PUBLISHER,
  Subscription = RMW_ENDPOINT_SUBSCRIPTION,
};

/// A publisher or a subscription of a topic: whose it is, its type and its QoS.
class TopicEndpointInfo
{
public:
  explicit TopicEndpointInfo(const rmw_topic_endpoint_info_t & info);

  const std::string & node_name() const {return node_name_;}
  const std::string & node_namespace() const {return node_namespace_;}
  const std::string & topic_type() const {return topic_type_;}
  rclcpp::EndpointType endpoint_type() const {return endpoint_type_;}
  const std::array<std::uint8_t, RMW_GID_STORAGE_SIZE> & endpoint_gid() const {return endpoint_gid_;}
  const QoS & qos_profile() const {return qos_profile_;}
  const rosidl_type_hash_t & topic_type_hash() const {return topic_type_hash_;}

private:
  std::string node_name_, node_namespace_, topic_type_;
  rclcpp::EndpointType endpoint_type_;
  std::array<std::uint8_t, RMW_GID_STORAGE_SIZE> endpoint_gid_;
  QoS qos_profile_;
  rosidl_type_hash_t topic_type_hash_;
};

namespace node_interfaces
{

/// What a node sees of the others. Names are resolved as those of its own topics are.
class NodeGraphInterface
{
public:
  RCLCPP_SMART_PTR_ALIASES_ONLY(NodeGraphInterface)
  using NamesAndTypes = std::map<std::string, std::vector<std::string>>;

  explicit NodeGraphInterface(NodeBaseInterface::SharedPtr node);

  NamesAndTypes get_topic_names_and_types(bool no_demangle = false) const;
  NamesAndTypes get_service_names_and_types() const;
  NamesAndTypes get_service_names_and_types_by_node(
    const std::string & node_name, const std::string & namespace_) const;
  NamesAndTypes get_client_names_and_types_by_node(
    const std::string & node_name, const std::string & namespace_) const;
  NamesAndTypes get_publisher_names_and_types_by_node(
    const std::string & node_name, const std::string & namespace_, bool no_demangle = false) const;
  NamesAndTypes get_subscriber_names_and_types_by_node(
    const std::string & node_name, const std::string & namespace_, bool no_demangle = false) const;

  /// With their namespaces: /talker.
  std::vector<std::string> get_node_names() const;
  std::vector<std::pair<std::string, std::string>> get_node_names_and_namespaces() const;

  std::size_t count_publishers(const std::string & topic_name) const;
  std::size_t count_subscribers(const std::string & topic_name) const;
  std::size_t count_clients(const std::string & service_name) const;
  std::size_t count_services(const std::string & service_name) const;

  std::vector<TopicEndpointInfo> get_publishers_info_by_topic(
    const std::string & topic_name, bool no_mangle = false) const;
  std::vector<TopicEndpointInfo> get_subscriptions_info_by_topic(
    const std::string & topic_name, bool no_mangle = false) const;

  /// Waits until `holds`, looking whenever nodes, topics or services come or go; a negative time waits for
  /// ever. Whether it holds; the end of the context ends the waiting.
  bool wait_until(const std::function<bool()> & holds, std::chrono::nanoseconds timeout) const;

private:
  NodeBaseInterface::SharedPtr node_;
};

}  // namespace node_interfaces
}  // namespace rclcpp
