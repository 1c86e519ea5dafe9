#pragma once

#include <memory>
#include <string>
#include <utility>

#include "rclcpp/detail/node_of.hpp"

namespace rclcpp
{

template<typename ServiceT, typename CallbackT, typename NodeT>
std::shared_ptr<Service<ServiceT>> create_service(
  NodeT && node, const std::string & service_name, CallbackT && callback,
  const QoS & qos = ServicesQoS(), CallbackGroup::SharedPtr group = nullptr)
{
  return detail::node_of(node).template create_service<ServiceT>(
    service_name, std::forward<CallbackT>(callback), qos, std::move(group));
}

}  // namespace rclcpp
