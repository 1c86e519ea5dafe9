#ifndef CPP_PACKAGE_WITH_A_NODE__PRINT_FOREVER_NODE_HPP_
#define CPP_PACKAGE_WITH_A_NODE__PRINT_FOREVER_NODE_HPP_

#include <cstdint>

#include "rclcpp/rclcpp.hpp"

namespace printing
{

class PrintForever final : public rclcpp::Node
{
public:
  explicit PrintForever(const rclcpp::NodeOptions & options = rclcpp::NodeOptions());
  void tell();

private:
  std::uint64_t told_ = 0;
};

}  // namespace printing

#endif  // CPP_PACKAGE_WITH_A_NODE__PRINT_FOREVER_NODE_HPP_
