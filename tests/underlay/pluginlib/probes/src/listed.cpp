// Prints the lamps that a file describes: `listed FILE`.
#include "pluginlib/class_loader.hpp"
#include "pluginlib_probes/lamp.hpp"

int main(int, char * argv[])
{
  try {
    pluginlib::ClassLoader<probes::Lamp> loader("pluginlib", "probes::Lamp", "plugin", {argv[1]});
    for (const auto & name : loader.getDeclaredClasses()) {
      std::printf(
        "%s, %s, %s: %s\n", name.c_str(), loader.getClassType(name).c_str(),
        loader.getClassPackage(name).c_str(), loader.getClassDescription(name).c_str());
    }
  } catch (const pluginlib::ClassLoaderException & error) {
    std::printf("ClassLoaderException: %s\n", error.what());
    return 1;
  }
  return 0;
}
