// Two nodes in a shared library, each of which CMake makes a program.

#include <chrono>
#include <cstdio>

#include "rclcpp/rclcpp.hpp"
#include "rclcpp_components/register_node_macro.hpp"

namespace probes
{

/// Ends after its first call.
template<int number>
class Component : public rclcpp::Node
{
public:
  explicit Component(const rclcpp::NodeOptions & options)
  : Node("component", options)
  {
    const auto count = options.arguments().size();
    std::printf("%d %s %zu\n", number, get_fully_qualified_name(), count);
    timer_ = create_wall_timer(std::chrono::milliseconds(1), []() {rclcpp::shutdown();});
  }

private:
  rclcpp::TimerBase::SharedPtr timer_;
};

using First = Component<1>;
class Second : public Component<2>
{
public:
  using Component<2>::Component;
};

}  // namespace probes

RCLCPP_COMPONENTS_REGISTER_NODE(probes::First)
RCLCPP_COMPONENTS_REGISTER_NODE(probes::Second)
