// Nodes in a shared library. CMake makes a program of some of them; others are for containers.

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

/// Says what it was given. With the parameter blocks, its thread never comes back.
class Staying : public rclcpp::Node
{
public:
  explicit Staying(const rclcpp::NodeOptions & options)
  : Node("staying", options)
  {
    const auto word = declare_parameter("word", "none");
    const bool is_intra = options.use_intra_process_comms();
    std::printf("%s %s %d\n", get_fully_qualified_name(), word.c_str(), is_intra);
    std::fflush(stdout);
    if (declare_parameter("blocks", false)) {
      timer_ = create_wall_timer(std::chrono::milliseconds(1), []() {
          while (rclcpp::ok()) {
            rclcpp::sleep_for(std::chrono::milliseconds(10));
          }
        });
    }
  }

private:
  rclcpp::TimerBase::SharedPtr timer_;
};

class Failing : public rclcpp::Node
{
public:
  explicit Failing(const rclcpp::NodeOptions & options)
  : Node("failing", options)
  {
    throw std::runtime_error("not today");
  }
};

}  // namespace probes

RCLCPP_COMPONENTS_REGISTER_NODE(probes::First)
RCLCPP_COMPONENTS_REGISTER_NODE(probes::Second)
RCLCPP_COMPONENTS_REGISTER_NODE(probes::Staying)
RCLCPP_COMPONENTS_REGISTER_NODE(probes::Failing)
