// Each component of it has a thread of its own, or, with --use_multi_threaded_executor, several.
#include <algorithm>

#include "rclcpp_components/component_manager_isolated.hpp"

using rclcpp_components::ComponentManagerIsolated;

int main(int argc, char * argv[])
{
  const auto words = rclcpp::init_and_remove_ros_arguments(argc, argv);
  const bool has_many =
    std::find(words.begin(), words.end(), "--use_multi_threaded_executor") != words.end();
  const auto executor = std::make_shared<rclcpp::executors::SingleThreadedExecutor>();
  rclcpp::Node::SharedPtr manager;
  if (has_many) {
    manager = std::make_shared<ComponentManagerIsolated<rclcpp::executors::MultiThreadedExecutor>>(executor);
  } else {
    manager = std::make_shared<ComponentManagerIsolated<>>(executor);
  }
  executor->add_node(manager);
  executor->spin();
  executor->remove_node(manager);
  return 0;
}
