#include "parameter_overrides.hpp"

#include <memory>

#include "rcl_yaml_param_parser/parser.h"
#include "rclcpp/detail/check.hpp"
#include "rclcpp/parameter_map.hpp"

namespace rclcpp::detail
{

namespace
{

struct Finish
{
  void operator()(rcl_params_t * params) const {rcl_yaml_node_struct_fini(params);}
};

}  // namespace

std::map<std::string, ParameterValue> parameter_overrides(
  const std::string & name, const std::vector<const rcl_arguments_t *> & sources)
{
  std::map<std::string, ParameterValue> overrides;
  for (const rcl_arguments_t * source : sources) {
    rcl_params_t * found = nullptr;
    check(rcl_arguments_get_param_overrides(source, &found), "failed to get parameter overrides");
    const std::unique_ptr<rcl_params_t, Finish> params(found);
    if (params) {
      for (const auto & parameter : parameters_from_map(parameter_map_from(found, name.c_str()))) {
        overrides[parameter.get_name()] = parameter.get_parameter_value();
      }
    }
  }
  return overrides;
}

}  // namespace rclcpp::detail
