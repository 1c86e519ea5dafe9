#pragma once
#include "rclcpp/rclcpp.hpp"

class PrintForeverNode: public rclcpp::Node
{
private:
    int count;

public:
    PrintForeverNode(std::string name): Node(name), count(0) {}

    void print()
    {
        RCLCPP_INFO_STREAM(this->get_logger(), "Printed " + std::to_string(count) + " times.");
        count = count + 1;
    }
};
