// Components of it share as many threads as its parameter thread_num says.
#include "rclcpp_components/component_manager.hpp"

int main(int argc, char * argv[])
{
  rclcpp::init(argc, argv);
  const auto manager = std::make_shared<rclcpp_components::ComponentManager>();
  const auto threads = manager->get_parameter("thread_num").as_int();
  const auto executor = std::make_shared<rclcpp::executors::MultiThreadedExecutor>(
    rclcpp::ExecutorOptions(), static_cast<std::size_t>(threads));
  manager->set_executor(executor);
  executor->add_node(manager);
  executor->spin();
  executor->remove_node(manager);
  return 0;
}
