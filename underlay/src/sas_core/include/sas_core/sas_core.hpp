// All of sas_core.

#pragma once

#include <sas_core/eigen3_std_conversions.hpp>
#include <sas_core/sas_clock.hpp>
#include <sas_core/sas_robot_driver.hpp>
#include <sas_core/sas_statistics.hpp>
