#include <iostream>
#include <memory>

#include "sample_class_local_node.hpp"

int main(int argc, char** argv)
{
    rclcpp::init(argc, argv);
    const auto node = std::make_shared<SampleClassLocalNode>();
    try
    {
        rclcpp::spin(node);
    }
    catch (const std::exception& e)
    {
        std::cerr << node->get_name() << ": " << e.what() << std::endl;
    }
    return 0;
}
