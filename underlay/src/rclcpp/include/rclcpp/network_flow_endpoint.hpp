#pragma once

#include <cstdint>
#include <ostream>
#include <string>

#include "rcl/network_flow_endpoints.h"

namespace rclcpp
{

/// Where messages leave or arrive: address, port, and how the network tells their packets from others.
class NetworkFlowEndpoint
{
public:
  explicit NetworkFlowEndpoint(const rcl_network_flow_endpoint_t & network_flow_endpoint);

  const std::string & transport_protocol() const {return transport_;}
  const std::string & internet_protocol() const {return internet_;}
  const std::string & internet_address() const {return address_;}
  std::uint16_t transport_port() const {return port_;}
  std::uint32_t flow_label() const {return flow_label_;}
  std::uint8_t dscp() const {return dscp_;}

private:
  std::string transport_, internet_, address_;
  std::uint16_t port_;
  std::uint32_t flow_label_;
  std::uint8_t dscp_;
};

bool operator==(const NetworkFlowEndpoint & left, const NetworkFlowEndpoint & right);
bool operator!=(const NetworkFlowEndpoint & left, const NetworkFlowEndpoint & right);

/// As an object of JSON, with numbers as texts.
std::ostream & operator<<(std::ostream & out, const NetworkFlowEndpoint & endpoint);

}  // namespace rclcpp
