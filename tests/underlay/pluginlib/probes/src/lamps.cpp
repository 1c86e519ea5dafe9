#include "pluginlib/class_list_macros.hpp"
#include "pluginlib_probes/lamp.hpp"

namespace probes
{

class Red : public Lamp
{
public:
  std::string shine() const override {return "red";}
};

/// Its part that is a lamp isn't at its beginning.
class Green : public Other, public Lamp
{
public:
  std::string shine() const override {return "green";}
};

class NotALamp : public Other {};

}  // namespace probes

PLUGINLIB_EXPORT_CLASS(probes::Red, probes::Lamp)
PLUGINLIB_EXPORT_CLASS(probes::Green, probes::Lamp)
PLUGINLIB_EXPORT_CLASS(probes::NotALamp, probes::Other)
