#include "sas_robot_driver_myrobot.hpp"

namespace sas
{

// TODO: what is inside, and what the functions do.

}  // namespace sas
