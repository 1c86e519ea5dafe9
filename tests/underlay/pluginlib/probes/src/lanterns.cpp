#include "pluginlib/class_list_macros.hpp"
#include "pluginlib_probes/lamp.hpp"

namespace probes
{

class Lantern : public Lamp
{
public:
  std::string shine() const override {return "lantern";}
};

}  // namespace probes

PLUGINLIB_EXPORT_CLASS(probes::Lantern, probes::Lamp)
