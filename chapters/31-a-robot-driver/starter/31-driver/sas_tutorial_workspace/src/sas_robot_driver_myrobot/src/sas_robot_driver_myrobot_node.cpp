#include "sas_robot_driver_myrobot.hpp"

int main(int argc, char ** argv)
{
  // TODO: set the handler for Ctrl+C. Create the node, its parameters, the driver, and the RobotDriverROS that runs it.
  (void)argc;
  (void)argv;
  return 0;
}
