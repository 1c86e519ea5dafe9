#include "sas_robot_driver_myrobot.hpp"

int main(int argc, char ** argv)
{
  // TODO: the handler for Ctrl+C, the node, its parameters, the driver, and RobotDriverROS, which runs the driver.
  (void)argc;
  (void)argv;
  return 0;
}
