#include <sstream>

#include <rclcpp/rclcpp.hpp>

#include <cpp_package_with_a_library/sample_class.hpp>

namespace
{

class Node : public rclcpp::Node
{
public:
  Node()
  : rclcpp::Node("sample"), timer_(create_wall_timer(std::chrono::duration<double>(0.5), [this] {tell();}))
  {
    sample_.set_a_private_member(7);
  }

private:
  void tell() const
  {
    std::ostringstream text;
    text << sample_;
    RCLCPP_INFO(get_logger(), "%s", text.str().c_str());
    RCLCPP_INFO(get_logger(), "Sum of squares: %.1f", SampleClass::sum_of_squares(2, 3));
  }

  SampleClass sample_;
  rclcpp::TimerBase::SharedPtr timer_;
};

}  // namespace

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::executors::SingleThreadedExecutor executor;
  const auto node = std::make_shared<Node>();
  executor.add_node(node);
  executor.spin();
  rclcpp::shutdown();
  return 0;
}
