// These conversions need no ROS, so they are in sas_core.

#pragma once

#include <sas_core/eigen3_std_conversions.hpp>
