#include "print_forever_node.hpp"

int main(int argc, char** argv)
{
    rclcpp::init(argc, argv);
    std::shared_ptr<PrintForeverNode> node(new PrintForeverNode("print_forever_node"));
    rclcpp::WallRate loop_rate(2.0);
    while (rclcpp::ok())
    {
        node->print();
        rclcpp::spin_some(node->get_node_base_interface());
        loop_rate.sleep();
    }
    rclcpp::shutdown();
    return EXIT_SUCCESS;
}
