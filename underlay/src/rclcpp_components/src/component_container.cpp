// All components of it share one thread.
#include "rclcpp_components/component_manager.hpp"

int main(int argc, char * argv[])
{
  rclcpp::init(argc, argv);
  const auto executor = std::make_shared<rclcpp::executors::SingleThreadedExecutor>();
  const auto manager = std::make_shared<rclcpp_components::ComponentManager>(executor);
  executor->add_node(manager);
  executor->spin();
  executor->remove_node(manager);
  return 0;
}
