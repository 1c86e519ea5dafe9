// serving plain|header|later: a service | call WAY: a client of `switch`, std_srvs/SetBool.

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
  explicit Server(const std::string & form)
  : Node("server")
  {
    using std::placeholders::_1;
    using std::placeholders::_2;
    if (form == "plain") {
      service_ = create_service<SetBool>("switch", &answer);
    } else if (form == "bound") {
      service_ = create_service<SetBool>("switch", std::bind(&Server::answer_bound, this, _1, _2));
    } else if (form == "header") {
      service_ = create_service<SetBool>(
        "switch", [](std::shared_ptr<rmw_request_id_t>, Request request, Response response) {
          answer(request, response);
        });
    } else {
      service_ = create_service<SetBool>(
        "switch", [this](std::shared_ptr<rmw_request_id_t> header, Request request) {
          later(header, request);
        });
    }
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
        service_->send_response(*header, *response);
      });
  }

  rclcpp::Service<SetBool>::SharedPtr service_;
  rclcpp::TimerBase::SharedPtr timer_;
};

int call(const std::string & way)
{
  auto node = std::make_shared<rclcpp::Node>("caller");
  auto client = node->create_client<SetBool>("switch");
  const auto log = node->get_logger();
  if (way == "nobody") {
    RCLCPP_INFO(log, "there: %d", client->wait_for_service(20ms));
    auto lost = client->async_send_request(std::make_shared<SetBool::Request>());
    const auto code = rclcpp::spin_until_future_complete(node, lost, 20ms);
    RCLCPP_INFO_STREAM(log, "code: " << code << " pending: " << client->remove_pending_request(lost));
    return 0;
  }
  while (!client->wait_for_service(1s)) {
    if (!rclcpp::ok()) {
      return 1;
    }
  }
  auto request = std::make_shared<SetBool::Request>();
  request->data = true;
  if (way == "future") {
    auto future = client->async_send_request(request);
    if (rclcpp::spin_until_future_complete(node, future) == rclcpp::FutureReturnCode::SUCCESS) {
      RCLCPP_INFO(log, "answer: %s", future.get()->message.c_str());
    }
  } else if (way == "shared") {
    const auto future = client->async_send_request(request).future.share();
    rclcpp::spin_until_future_complete(node, future, 10s);
    RCLCPP_INFO(log, "answer: %s", future.get()->message.c_str());
  } else if (way == "callback") {
    using Future = rclcpp::Client<SetBool>::SharedFuture;
    auto sent = client->async_send_request(
      request, [log](Future future) {RCLCPP_INFO(log, "answer: %s", future.get()->message.c_str());});
    rclcpp::spin_until_future_complete(node, sent.future);
  } else {
    using Future = rclcpp::Client<SetBool>::SharedFutureWithRequest;
    auto sent = client->async_send_request(
      request, [log](Future future) {
        const auto & [asked, answered] = future.get();
        RCLCPP_INFO(log, "answer: %s to %d", answered->message.c_str(), asked->data);
      });
    rclcpp::spin_until_future_complete(node, sent.future);
  }
  return 0;
}

int main(int argc, char * argv[])
{
  const auto words = rclcpp::init_and_remove_ros_arguments(argc, argv);
  int code = 0;
  if (words.at(1) == "call") {
    code = call(words.at(2));
  } else {
    auto server = std::make_shared<Server>(words.at(1));
    RCLCPP_INFO(server->get_logger(), "ready");
    rclcpp::spin(server);
  }
  rclcpp::shutdown();
  return code;
}
