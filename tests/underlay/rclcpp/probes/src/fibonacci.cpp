// fibonacci serve | call | cancel: one end of an action, the other end of which is rclpy's.

#include <chrono>
#include <cstdio>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "example_interfaces/action/fibonacci.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_action/rclcpp_action.hpp"

using Fibonacci = example_interfaces::action::Fibonacci;

/// Rejects orders above 100, and counts until it is canceled for orders below 0.
class Server : public rclcpp::Node
{
public:
  using Handle = rclcpp_action::ServerGoalHandle<Fibonacci>;

  Server()
  : Node("fibonacci_server")
  {
    using namespace std::placeholders;  // NOLINT: as the tutorial has it
    server_ = rclcpp_action::create_server<Fibonacci>(
      this, "fibonacci", std::bind(&Server::handle_goal, this, _1, _2),
      std::bind(&Server::handle_cancel, this, _1), std::bind(&Server::handle_accepted, this, _1));
  }
  ~Server() override
  {
    if (worker_.joinable()) {
      worker_.join();
    }
  }

private:
  rclcpp_action::GoalResponse handle_goal(
    const rclcpp_action::GoalUUID & uuid, std::shared_ptr<const Fibonacci::Goal> goal)
  {
    (void)uuid;
    return goal->order > 100 ?
           rclcpp_action::GoalResponse::REJECT : rclcpp_action::GoalResponse::ACCEPT_AND_EXECUTE;
  }
  rclcpp_action::CancelResponse handle_cancel(const std::shared_ptr<Handle> goal_handle)
  {
    (void)goal_handle;
    return rclcpp_action::CancelResponse::ACCEPT;
  }
  void handle_accepted(const std::shared_ptr<Handle> goal_handle)
  {
    if (worker_.joinable()) {
      worker_.join();
    }
    worker_ = std::thread([this, goal_handle]() {execute(goal_handle);});
  }

  void execute(const std::shared_ptr<Handle> goal_handle)
  {
    auto feedback = std::make_shared<Fibonacci::Feedback>();
    auto result = std::make_shared<Fibonacci::Result>();
    auto & sequence = feedback->sequence;
    sequence = {0, 1};
    rclcpp::Rate rate(50);
    const auto order = goal_handle->get_goal()->order;
    for (int i = 1; (order < 0 || i < order) && rclcpp::ok(); ++i) {
      if (goal_handle->is_canceling()) {
        result->sequence = {0};
        goal_handle->canceled(result);
        return;
      }
      if (order > 0) {
        sequence.push_back(sequence[i] + sequence[i - 1]);
      }
      goal_handle->publish_feedback(feedback);
      rate.sleep();
    }
    if (rclcpp::ok()) {
      result->sequence = sequence;
      goal_handle->succeed(result);
    }
  }

  rclcpp_action::Server<Fibonacci>::SharedPtr server_;
  std::thread worker_;
};

std::string text_of(const std::vector<std::int32_t> & numbers)
{
  std::string text;
  for (const auto number : numbers) {
    text += " " + std::to_string(number);
  }
  return text;
}

/// Sends a goal and ends with its result. With `cancels`, it cancels at the first feedback.
class Client : public rclcpp::Node
{
public:
  using Handle = rclcpp_action::ClientGoalHandle<Fibonacci>;

  Client(int order, bool cancels)
  : Node("fibonacci_client"), client_(rclcpp_action::create_client<Fibonacci>(this, "fibonacci"))
  {
    client_->wait_for_action_server();
    Fibonacci::Goal goal;
    goal.order = order;
    auto options = rclcpp_action::Client<Fibonacci>::SendGoalOptions();
    options.goal_response_callback = [](const Handle::SharedPtr & handle) {
        std::puts(handle ? "accepted" : "rejected");
        if (!handle) {
          rclcpp::shutdown();
        }
      };
    options.feedback_callback =
      [this, cancels](Handle::SharedPtr handle, const std::shared_ptr<const Fibonacci::Feedback> feedback) {
        if (cancels && !is_fed_) {
          is_fed_ = true;
          std::printf("fed%s\n", text_of(feedback->sequence).c_str());
          client_->async_cancel_goal(handle);
        }
      };
    options.result_callback = [](const Handle::WrappedResult & result) {
        std::printf("code %d:%s\n", static_cast<int>(result.code), text_of(result.result->sequence).c_str());
        rclcpp::shutdown();
      };
    client_->async_send_goal(goal, options);
  }

private:
  rclcpp_action::Client<Fibonacci>::SharedPtr client_;
  bool is_fed_ = false;
};

int main(int argc, char * argv[])
{
  rclcpp::init(argc, argv);
  const std::string what = argv[1];
  if (what == "serve") {
    const auto server = std::make_shared<Server>();
    std::printf("ready\n");
    std::fflush(stdout);
    rclcpp::spin(server);
  } else {
    rclcpp::spin(std::make_shared<Client>(std::stoi(argv[2]), what == "cancel"));
  }
  rclcpp::shutdown();
  return 0;
}
