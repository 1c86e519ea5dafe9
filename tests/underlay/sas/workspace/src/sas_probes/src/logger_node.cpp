// Logs one value of each kind again and again, and says when it begins.

#include <chrono>
#include <iostream>
#include <thread>

#include <rclcpp/rclcpp.hpp>
#include <sas_datalogger/sas_datalogger_client.hpp>

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("logger");
  sas::DataloggerClient client(node);
  const auto pause = [] {std::this_thread::sleep_for(std::chrono::milliseconds(20));};
  while (!client.is_enabled() && rclcpp::ok()) {
    pause();
  }
  std::cout << "logs " << client.is_enabled(2) << std::endl;
  MatrixXd matrix(2, 3);
  matrix << 1, 2, 3, 4, 5, 6;
  while (rclcpp::ok()) {
    client.log("cpp_matrix", matrix);
    client.log("cpp_vector", VectorXd(VectorXd::LinSpaced(3, 1.0, 3.0)));
    client.log("cpp_list", std::vector<double>{4.0, 5.0});
    client.log("cpp_number", 7);
    client.log("cpp_text", "from C++");
    pause();
  }
  rclcpp::shutdown();
  return 0;
}
