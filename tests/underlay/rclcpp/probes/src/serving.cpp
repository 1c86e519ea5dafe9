// serving serve: services of all forms | call: a client of `switch` in all ways | nobody: one in vain.

#include <chrono>
#include <functional>
#include <memory>
#include <string>

#include "rclcpp/rclcpp.hpp"
#include "std_srvs/srv/set_bool.hpp"

using namespace std::chrono_literals;
using std_srvs::srv::SetBool;
using Request = std::shared_ptr<SetBool::Request>;
using Response = std::shared_ptr<SetBool::Response>;

void answer(const Request request, Response response)
{
  response->success = request->data;
  response->message = request->data ? "on" : "off";
}

class Server : public rclcpp::Node
{
public:
  Server()
  : Node("server")
  {
    using std::placeholders::_1;
    using std::placeholders::_2;
    plain_ = create_service<SetBool>("switch", &answer);
    bound_ = create_service<SetBool>("bound", std::bind(&Server::answer_bound, this, _1, _2));
    header_ = create_service<SetBool>(
      "header", [](std::shared_ptr<rmw_request_id_t>, Request request, Response response) {
        answer(request, response);
      });
    later_ = create_service<SetBool>(
      "later", [this](std::shared_ptr<rmw_request_id_t> header, Request request) {
        later(header, request);
      });
  }

private:
  void answer_bound(const Request request, Response response) {answer(request, response);}

  void later(std::shared_ptr<rmw_request_id_t> header, Request request)
  {
    timer_ = create_wall_timer(
      1ms, [this, header, request]() {
        timer_->cancel();
        auto response = std::make_shared<SetBool::Response>();
        answer(request, response);
        later_->send_response(*header, *response);
      });
  }

  rclcpp::Service<SetBool>::SharedPtr plain_, bound_, header_, later_;
  rclcpp::TimerBase::SharedPtr timer_;
};

void call_nobody()
{
  auto node = std::make_shared<rclcpp::Node>("caller");
  auto client = node->create_client<SetBool>("switch");
  RCLCPP_INFO(node->get_logger(), "there: %d", client->wait_for_service(20ms));
  auto lost = client->async_send_request(std::make_shared<SetBool::Request>());
  const auto code = rclcpp::spin_until_future_complete(node, lost, 20ms);
  RCLCPP_INFO_STREAM(
    node->get_logger(), "code: " << code << " pending: " << client->remove_pending_request(lost));
}

int call()
{
  auto node = std::make_shared<rclcpp::Node>("caller");
  auto client = node->create_client<SetBool>("switch");
  const auto log = node->get_logger();
  while (!client->wait_for_service(1s)) {
    if (!rclcpp::ok()) {
      return 1;
    }
  }
  auto request = std::make_shared<SetBool::Request>();
  request->data = true;
  auto unique = client->async_send_request(request);
  if (rclcpp::spin_until_future_complete(node, unique) == rclcpp::FutureReturnCode::SUCCESS) {
    RCLCPP_INFO(log, "future: %s", unique.get()->message.c_str());
  }
  const auto shared = client->async_send_request(request).future.share();
  rclcpp::spin_until_future_complete(node, shared, 10s);
  RCLCPP_INFO(log, "shared: %s", shared.get()->message.c_str());
  const auto called_back = client->async_send_request(
    request, [log](rclcpp::Client<SetBool>::SharedFuture future) {
      RCLCPP_INFO(log, "callback: %s", future.get()->message.c_str());
    });
  rclcpp::spin_until_future_complete(node, called_back.future);
  const auto generic = client->async_send_request(
    request, [log](auto future) {RCLCPP_INFO(log, "generic: %s", future.get()->message.c_str());});
  rclcpp::spin_until_future_complete(node, generic.future);
  const auto with_request = client->async_send_request(
    request, [log](rclcpp::Client<SetBool>::SharedFutureWithRequest future) {
      const auto & [asked, answered] = future.get();
      RCLCPP_INFO(log, "request: %s to %d", answered->message.c_str(), asked->data);
    });
  rclcpp::spin_until_future_complete(node, with_request.future);
  return 0;
}

int main(int argc, char * argv[])
{
  const auto words = rclcpp::init_and_remove_ros_arguments(argc, argv);
  int code = 0;
  if (words.at(1) == "call") {
    code = call();
  } else if (words.at(1) == "nobody") {
    call_nobody();
  } else {
    auto server = std::make_shared<Server>();
    RCLCPP_INFO(server->get_logger(), "ready");
    rclcpp::spin(server);
  }
  rclcpp::shutdown();
  return code;
}
