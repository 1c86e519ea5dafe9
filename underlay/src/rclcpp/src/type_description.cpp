#include "rclcpp/node_interfaces/node_type_descriptions_interface.hpp"

#include <utility>

#include "rcl/node.h"
#include "rcl/service.h"
#include "rclcpp/detail/check.hpp"
#include "rclcpp/logging.hpp"
#include "type_description_interfaces/srv/get_type_description.h"

namespace rclcpp
{

namespace detail
{

namespace
{

using Request = type_description_interfaces__srv__GetTypeDescription_Request;
using Response = type_description_interfaces__srv__GetTypeDescription_Response;

/// A message in C, which is taken apart in the end.
template<typename Message, bool (* begin)(Message *), void (* end)(Message *)>
class Held
{
public:
  Held() : good_(begin(&message_)) {}
  Held(const Held &) = delete;
  Held & operator=(const Held &) = delete;
  ~Held()
  {
    if (good_) {
      end(&message_);
    }
  }
  Message * get() {return good_ ? &message_ : nullptr;}

private:
  Message message_{};
  bool good_;
};

using HeldRequest = Held<
  Request, type_description_interfaces__srv__GetTypeDescription_Request__init,
  type_description_interfaces__srv__GetTypeDescription_Request__fini>;
using HeldResponse = Held<
  Response, type_description_interfaces__srv__GetTypeDescription_Response__init,
  type_description_interfaces__srv__GetTypeDescription_Response__fini>;

class TypeDescription : public Entity
{
public:
  explicit TypeDescription(std::shared_ptr<rcl_node_t> node)
  : node_(std::move(node))
  {
    check(
      rcl_node_type_description_service_init(&service_, node_.get()),
      "Failed to initialize the ~/get_type_description service");
  }
  TypeDescription(const TypeDescription &) = delete;
  TypeDescription & operator=(const TypeDescription &) = delete;
  ~TypeDescription() override
  {
    if (rcl_service_fini(&service_, node_.get()) != RCL_RET_OK) {
      rcl_reset_error();
    }
  }

  EntityKind kind() const noexcept override {return EntityKind::service;}
  const void * rcl_entity() const noexcept override {return &service_;}

  void execute() override
  {
    rmw_request_id_t header{};
    HeldRequest request;
    HeldResponse response;
    if (!request.get() || !response.get()) {
      throw std::bad_alloc();
    }
    const rcl_ret_t ret = rcl_take_request(&service_, &header, request.get());
    if (ret == RCL_RET_SERVICE_TAKE_FAILED) {
      rcl_reset_error();
      return;
    }
    check(ret, "failed to take a request");
    rcl_node_type_description_service_handle_request(node_.get(), &header, request.get(), response.get());
    if (rcl_send_response(&service_, &header, response.get()) != RCL_RET_OK) {
      RCLCPP_WARN(
        get_logger("rclcpp"), "failed to send a type description: %s", rcl_get_error_string().str);
      rcl_reset_error();
    }
  }

private:
  std::shared_ptr<rcl_node_t> node_;
  rcl_service_t service_ = rcl_get_zero_initialized_service();
};

}  // namespace

}  // namespace detail

node_interfaces::NodeTypeDescriptionsInterface::NodeTypeDescriptionsInterface(
  const NodeBaseInterface::SharedPtr & node, NodeParametersInterface & parameters)
{
  constexpr auto name = "start_type_description_service";
  if (!parameters.has_parameter(name)) {
    rcl_interfaces::msg::ParameterDescriptor descriptor;
    descriptor.description = "Start the ~/get_type_description service for this node.";
    descriptor.read_only = true;
    parameters.declare_parameter(name, ParameterValue(true), descriptor);
  }
  if (!parameters.get_parameter(name).get_value<bool>()) {
    return;
  }
  auto service = std::make_shared<detail::TypeDescription>(node->get_shared_rcl_node_handle());
  node->add(service, nullptr);
  service_ = std::move(service);
}

}  // namespace rclcpp
