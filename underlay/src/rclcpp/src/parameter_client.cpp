#include "rclcpp/parameter_client.hpp"

#include <algorithm>

#include "rcl_interfaces/srv/describe_parameters.hpp"
#include "rcl_interfaces/srv/get_parameter_types.hpp"
#include "rcl_interfaces/srv/get_parameters.hpp"
#include "rcl_interfaces/srv/list_parameters.hpp"
#include "rcl_interfaces/srv/set_parameters.hpp"
#include "rcl_interfaces/srv/set_parameters_atomically.hpp"

namespace rclcpp
{

namespace
{

template<typename ServiceT>
typename Client<ServiceT>::SharedPtr client_of(
  const node_interfaces::NodeBaseInterface::SharedPtr & node, const std::string & name, const QoS & qos,
  const CallbackGroup::SharedPtr & group)
{
  auto client = std::make_shared<Client<ServiceT>>(node, name, qos);
  node->add(client, group);
  return client;
}

/// Asks; what `read` makes of the response is in the future.
template<typename T, typename ServiceT, typename Read>
std::shared_future<T> ask(
  Client<ServiceT> & client, std::shared_ptr<typename ServiceT::Request> request,
  AsyncParametersClient::Callback<T> callback, Read read)
{
  const auto promise = std::make_shared<std::promise<T>>();
  const std::shared_future<T> future(promise->get_future());
  client.async_send_request(
    std::move(request),
    [promise, future, callback, read](typename Client<ServiceT>::SharedFuture answered) {
      promise->set_value(read(*answered.get()));
      if (callback) {
        callback(future);
      }
    });
  return future;
}

template<typename RequestT>
std::shared_ptr<RequestT> request_for(const std::vector<std::string> & names)
{
  auto request = std::make_shared<RequestT>();
  request->names = names;
  return request;
}

template<typename RequestT>
std::shared_ptr<RequestT> request_of(const std::vector<Parameter> & parameters)
{
  auto request = std::make_shared<RequestT>();
  for (const auto & parameter : parameters) {
    request->parameters.push_back(parameter.to_parameter_msg());
  }
  return request;
}

}  // namespace

namespace srv = rcl_interfaces::srv;
using node_interfaces::NodeBaseInterface;

struct AsyncParametersClient::Clients
{
  Clients(
    const NodeBaseInterface::SharedPtr & node, const std::string & remote, const QoS & qos,
    const CallbackGroup::SharedPtr & group)
  : get(client_of<srv::GetParameters>(node, remote + "/get_parameters", qos, group)),
    types(client_of<srv::GetParameterTypes>(node, remote + "/get_parameter_types", qos, group)),
    set(client_of<srv::SetParameters>(node, remote + "/set_parameters", qos, group)),
    set_atomically(
      client_of<srv::SetParametersAtomically>(node, remote + "/set_parameters_atomically", qos, group)),
    list(client_of<srv::ListParameters>(node, remote + "/list_parameters", qos, group)),
    describe(client_of<srv::DescribeParameters>(node, remote + "/describe_parameters", qos, group))
  {
  }

  std::vector<ClientBase::SharedPtr> all() const {return {get, types, set, set_atomically, list, describe};}

  Client<srv::GetParameters>::SharedPtr get;
  Client<srv::GetParameterTypes>::SharedPtr types;
  Client<srv::SetParameters>::SharedPtr set;
  Client<srv::SetParametersAtomically>::SharedPtr set_atomically;
  Client<srv::ListParameters>::SharedPtr list;
  Client<srv::DescribeParameters>::SharedPtr describe;
};

AsyncParametersClient::AsyncParametersClient(
  NodeBaseInterface::SharedPtr node, const std::string & remote_node_name, const QoS & qos_profile,
  CallbackGroup::SharedPtr group)
: node_(std::move(node)),
  remote_name_(remote_node_name.empty() ? node_->get_fully_qualified_name() : remote_node_name),
  clients_(std::make_shared<Clients>(node_, remote_name_, qos_profile, group))
{
}

std::shared_future<std::vector<Parameter>> AsyncParametersClient::get_parameters(
  const std::vector<std::string> & names, Callback<std::vector<Parameter>> callback)
{
  return ask<std::vector<Parameter>>(
    *clients_->get, request_for<srv::GetParameters::Request>(names), std::move(callback),
    [names](const srv::GetParameters::Response & response) {
      std::vector<Parameter> found;
      for (std::size_t i = 0; i < response.values.size() && i < names.size(); ++i) {
        found.emplace_back(names[i], ParameterValue(response.values[i]));
      }
      return found;
    });
}

std::shared_future<std::vector<AsyncParametersClient::Descriptor>>
AsyncParametersClient::describe_parameters(
  const std::vector<std::string> & names, Callback<std::vector<Descriptor>> callback)
{
  return ask<std::vector<Descriptor>>(
    *clients_->describe, request_for<srv::DescribeParameters::Request>(names), std::move(callback),
    [](const srv::DescribeParameters::Response & response) {return response.descriptors;});
}

std::shared_future<std::vector<ParameterType>> AsyncParametersClient::get_parameter_types(
  const std::vector<std::string> & names, Callback<std::vector<ParameterType>> callback)
{
  return ask<std::vector<ParameterType>>(
    *clients_->types, request_for<srv::GetParameterTypes::Request>(names), std::move(callback),
    [](const srv::GetParameterTypes::Response & response) {
      std::vector<ParameterType> types;
      for (const auto type : response.types) {
        types.push_back(static_cast<ParameterType>(type));
      }
      return types;
    });
}

std::shared_future<std::vector<AsyncParametersClient::Result>> AsyncParametersClient::set_parameters(
  const std::vector<Parameter> & parameters, Callback<std::vector<Result>> callback)
{
  return ask<std::vector<Result>>(
    *clients_->set, request_of<srv::SetParameters::Request>(parameters), std::move(callback),
    [](const srv::SetParameters::Response & response) {return response.results;});
}

std::shared_future<AsyncParametersClient::Result> AsyncParametersClient::set_parameters_atomically(
  const std::vector<Parameter> & parameters, Callback<Result> callback)
{
  return ask<Result>(
    *clients_->set_atomically, request_of<srv::SetParametersAtomically::Request>(parameters),
    std::move(callback),
    [](const srv::SetParametersAtomically::Response & response) {return response.result;});
}

std::shared_future<std::vector<AsyncParametersClient::Result>> AsyncParametersClient::delete_parameters(
  const std::vector<std::string> & parameters_names)
{
  std::vector<Parameter> gone;
  for (const auto & name : parameters_names) {
    gone.emplace_back(name);
  }
  return set_parameters(gone);
}

std::shared_future<AsyncParametersClient::Listed> AsyncParametersClient::list_parameters(
  const std::vector<std::string> & prefixes, std::uint64_t depth, Callback<Listed> callback)
{
  auto request = std::make_shared<srv::ListParameters::Request>();
  request->prefixes = prefixes;
  request->depth = depth;
  return ask<Listed>(
    *clients_->list, std::move(request), std::move(callback),
    [](const srv::ListParameters::Response & response) {return response.result;});
}

std::shared_future<std::vector<AsyncParametersClient::Result>> AsyncParametersClient::load_parameters(
  const std::string & yaml_filename)
{
  return load_parameters(parameter_map_from_yaml_file(yaml_filename, remote_name_.c_str()));
}

std::shared_future<std::vector<AsyncParametersClient::Result>> AsyncParametersClient::load_parameters(
  const ParameterMap & parameter_map)
{
  const auto parameters = parameters_from_map(parameter_map, remote_name_.c_str());
  if (parameters.empty()) {
    throw exceptions::InvalidParametersException("No valid parameter");
  }
  return set_parameters(parameters);
}

bool AsyncParametersClient::service_is_ready() const
{
  for (const auto & client : clients_->all()) {
    if (!client->service_is_ready()) {
      return false;
    }
  }
  return true;
}

bool AsyncParametersClient::wait_for_service_nanoseconds(std::chrono::nanoseconds timeout)
{
  const auto began = std::chrono::steady_clock::now();
  for (const auto & client : clients_->all()) {
    const std::chrono::nanoseconds left = timeout - (std::chrono::steady_clock::now() - began);
    const bool is_bounded = timeout >= std::chrono::nanoseconds(0);
    if (!client->wait_for_service(is_bounded ? std::max(left, std::chrono::nanoseconds(0)) : timeout)) {
      return false;
    }
  }
  return true;
}

SyncParametersClient::SyncParametersClient(
  Executor::SharedPtr executor, NodeBaseInterface::SharedPtr node, const std::string & remote_node_name,
  const QoS & qos_profile)
: executor_(std::move(executor)), node_(std::move(node)),
  async_(std::make_shared<AsyncParametersClient>(node_, remote_node_name, qos_profile))
{
  if (!executor_) {
    ExecutorOptions options;
    options.context = node_->get_context();
    executor_ = std::make_shared<executors::SingleThreadedExecutor>(options);
  }
}

template<typename T>
bool SyncParametersClient::wait(const std::shared_future<T> & future, std::chrono::nanoseconds timeout)
{
  return executors::spin_node_until_future_complete(*executor_, node_, future, timeout) ==
         FutureReturnCode::SUCCESS;
}

std::vector<Parameter> SyncParametersClient::get_parameters(
  const std::vector<std::string> & names, std::chrono::nanoseconds timeout)
{
  const auto future = async_->get_parameters(names);
  return wait(future, timeout) ? future.get() : std::vector<Parameter>();
}

std::vector<SyncParametersClient::Descriptor> SyncParametersClient::describe_parameters(
  const std::vector<std::string> & names, std::chrono::nanoseconds timeout)
{
  const auto future = async_->describe_parameters(names);
  return wait(future, timeout) ? future.get() : std::vector<Descriptor>();
}

std::vector<ParameterType> SyncParametersClient::get_parameter_types(
  const std::vector<std::string> & names, std::chrono::nanoseconds timeout)
{
  const auto future = async_->get_parameter_types(names);
  return wait(future, timeout) ? future.get() : std::vector<ParameterType>();
}

std::vector<SyncParametersClient::Result> SyncParametersClient::set_parameters(
  const std::vector<Parameter> & parameters, std::chrono::nanoseconds timeout)
{
  const auto future = async_->set_parameters(parameters);
  return wait(future, timeout) ? future.get() : std::vector<Result>();
}

std::vector<SyncParametersClient::Result> SyncParametersClient::delete_parameters(
  const std::vector<std::string> & parameters_names, std::chrono::nanoseconds timeout)
{
  const auto future = async_->delete_parameters(parameters_names);
  return wait(future, timeout) ? future.get() : std::vector<Result>();
}

std::vector<SyncParametersClient::Result> SyncParametersClient::load_parameters(
  const std::string & yaml_filename, std::chrono::nanoseconds timeout)
{
  const auto future = async_->load_parameters(yaml_filename);
  return wait(future, timeout) ? future.get() : std::vector<Result>();
}

SyncParametersClient::Result SyncParametersClient::set_parameters_atomically(
  const std::vector<Parameter> & parameters, std::chrono::nanoseconds timeout)
{
  const auto future = async_->set_parameters_atomically(parameters);
  if (!wait(future, timeout)) {
    throw std::runtime_error("Unable to get result of set parameters service call.");
  }
  return future.get();
}

SyncParametersClient::Listed SyncParametersClient::list_parameters(
  const std::vector<std::string> & parameter_prefixes, std::uint64_t depth,
  std::chrono::nanoseconds timeout)
{
  const auto future = async_->list_parameters(parameter_prefixes, depth);
  if (!wait(future, timeout)) {
    throw std::runtime_error("Unable to get result of list parameters service call.");
  }
  return future.get();
}

bool SyncParametersClient::has_parameter(const std::string & parameter_name)
{
  const auto names = list_parameters({parameter_name}, 1).names;
  return !names.empty();
}

}  // namespace rclcpp
