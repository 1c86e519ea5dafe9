#pragma once

#include <memory>
#include <string>
#include <utility>

#include "rclcpp/detail/node_of.hpp"

namespace rclcpp
{

template<typename ServiceT, typename NodeT>
std::shared_ptr<Client<ServiceT>> create_client(
  NodeT && node, const std::string & service_name, const QoS & qos = ServicesQoS(),
  CallbackGroup::SharedPtr group = nullptr)
{
  return detail::node_of(node).template create_client<ServiceT>(service_name, qos, std::move(group));
}

}  // namespace rclcpp
