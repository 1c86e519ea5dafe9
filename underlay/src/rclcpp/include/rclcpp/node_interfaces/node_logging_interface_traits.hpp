#pragma once

#include "rclcpp/node_interfaces/getters.hpp"
