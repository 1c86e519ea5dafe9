#include "parameter_services.hpp"

#include <string>
#include <utility>

#include "rcl_interfaces/srv/describe_parameters.hpp"
#include "rcl_interfaces/srv/get_parameter_types.hpp"
#include "rcl_interfaces/srv/get_parameters.hpp"
#include "rcl_interfaces/srv/list_parameters.hpp"
#include "rcl_interfaces/srv/set_parameters.hpp"
#include "rcl_interfaces/srv/set_parameters_atomically.hpp"
#include "rclcpp/logging.hpp"

namespace rclcpp::detail
{

namespace
{

namespace srv = rcl_interfaces::srv;
using node_interfaces::NodeBaseInterface;
using node_interfaces::NodeParametersInterface;

/// Answers with `answer(parameters, request, response)`. What is not declared leaves the response empty.
template<typename ServiceT, typename Answer>
ServiceBase::SharedPtr serve(
  const NodeBaseInterface::SharedPtr & node, const NodeParametersInterface::SharedPtr & parameters,
  const char * name, Answer answer)
{
  const auto handler = [known = std::weak_ptr<NodeParametersInterface>(parameters), answer](
    const std::shared_ptr<typename ServiceT::Request> & request,
    const std::shared_ptr<typename ServiceT::Response> & response) {
      try {
        if (const auto still_there = known.lock()) {
          answer(*still_there, *request, *response);
        }
      } catch (const exceptions::ParameterNotDeclaredException & error) {
        RCLCPP_DEBUG(get_logger("rclcpp"), "Failed to answer about parameters: %s", error.what());
      } catch (const exceptions::ParameterUninitializedException & error) {
        RCLCPP_DEBUG(get_logger("rclcpp"), "Failed to answer about parameters: %s", error.what());
      }
    };
  auto service = std::make_shared<Service<ServiceT>>(
    node, std::string(node->get_name()) + "/" + name, service_handler<ServiceT>(handler), ParametersQoS());
  node->add(service, nullptr);
  return service;
}

/// Sets them all. `undeclared` replaces the reason that names the first one that is not declared.
rcl_interfaces::msg::SetParametersResult set(
  NodeParametersInterface & parameters, const std::vector<Parameter> & given,
  const char * undeclared = nullptr)
{
  try {
    return parameters.set_parameters_atomically(given);
  } catch (const exceptions::ParameterNotDeclaredException & error) {
    RCLCPP_WARN(get_logger("rclcpp"), "Failed to set parameters: %s", error.what());
    rcl_interfaces::msg::SetParametersResult result;
    result.successful = false;
    result.reason = undeclared ? undeclared : error.what();
    return result;
  }
}

void answer_set(
  NodeParametersInterface & parameters, const srv::SetParameters::Request & request,
  srv::SetParameters::Response & response)
{
  for (const auto & message : request.parameters) {
    response.results.push_back(set(parameters, {Parameter::from_parameter_msg(message)}));
  }
}

void answer_set_atomically(
  NodeParametersInterface & parameters, const srv::SetParametersAtomically::Request & request,
  srv::SetParametersAtomically::Response & response)
{
  std::vector<Parameter> given;
  for (const auto & message : request.parameters) {
    given.push_back(Parameter::from_parameter_msg(message));
  }
  response.result =
    set(parameters, given, "One or more parameters were not declared before setting");
}

void answer_get(
  NodeParametersInterface & parameters, const srv::GetParameters::Request & request,
  srv::GetParameters::Response & response)
{
  for (const auto & parameter : parameters.get_parameters(request.names)) {
    response.values.push_back(parameter.get_value_message());
  }
}

}  // namespace

std::vector<ServiceBase::SharedPtr> parameter_services(
  const NodeBaseInterface::SharedPtr & node, const NodeParametersInterface::SharedPtr & parameters)
{
  return {
    serve<srv::DescribeParameters>(
      node, parameters, "describe_parameters", [](auto & known, const auto & request, auto & response) {
        response.descriptors = known.describe_parameters(request.names);
      }),
    serve<srv::GetParameterTypes>(
      node, parameters, "get_parameter_types", [](auto & known, const auto & request, auto & response) {
        response.types = known.get_parameter_types(request.names);
      }),
    serve<srv::GetParameters>(node, parameters, "get_parameters", answer_get),
    serve<srv::ListParameters>(
      node, parameters, "list_parameters", [](auto & known, const auto & request, auto & response) {
        response.result = known.list_parameters(request.prefixes, request.depth);
      }),
    serve<srv::SetParameters>(node, parameters, "set_parameters", answer_set),
    serve<srv::SetParametersAtomically>(
      node, parameters, "set_parameters_atomically", answer_set_atomically),
  };
}

}  // namespace rclcpp::detail
