// All of sas_conversions.

#pragma once

#include <sas_conversions/DQ_geometry_msgs_conversions.hpp>
#include <sas_conversions/eigen3_std_conversions.hpp>
#include <sas_conversions/std_std_msgs_conversions.hpp>
