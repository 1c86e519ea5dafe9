// Is linked with a library of plugins, as tests of plugins often are.
#include "pluginlib/class_loader.hpp"
#include "pluginlib_probes/lamp.hpp"

int main()
{
  pluginlib::ClassLoader<probes::Lamp> loader("pluginlib_probes", "probes::Lamp");
  std::printf("%s\n", loader.createSharedInstance("shop/lantern")->shine().c_str());
  return 0;
}
