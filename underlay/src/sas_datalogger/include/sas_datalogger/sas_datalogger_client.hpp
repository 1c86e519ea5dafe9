// Sends values to the node that logs them.

#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <Eigen/Dense>
#include <rclcpp/rclcpp.hpp>
#include <sas_core/sas_object.hpp>
#include <sas_msgs/msg/log_datum.hpp>

using namespace Eigen;  // NOLINT: programs of this family write VectorXd without a namespace

namespace sas
{

/// Publishes on /sas_datalogger/log. Values of one name become one variable of the file, in order.
class DataloggerClient : private Object
{
public:
  explicit DataloggerClient(const rclcpp::Node::SharedPtr & node, const std::size_t & queue_size = 100);

  /// Whether that many nodes log; what is logged before is lost.
  bool is_enabled(const int & server_count = 1) const;

  void log(const std::string & name, const Eigen::MatrixXd & value);
  void log(const std::string & name, const Eigen::VectorXd & value);
  void log(const std::string & name, const std::vector<double> & value);
  void log(const std::string & name, const double & value);
  void log(const std::string & name, const std::string & value);

private:
  rclcpp::Publisher<sas_msgs::msg::LogDatum>::SharedPtr publisher_;
};

}  // namespace sas
