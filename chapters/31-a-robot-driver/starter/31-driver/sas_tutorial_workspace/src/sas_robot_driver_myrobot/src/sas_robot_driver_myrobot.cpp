#include "sas_robot_driver_myrobot.hpp"

namespace sas
{

// TODO: define the class Impl, and the functions of the driver.

}  // namespace sas
