#include <sas_datalogger/sas_datalogger_client.hpp>

namespace sas
{

DataloggerClient::DataloggerClient(const rclcpp::Node::SharedPtr & node, const std::size_t & queue_size)
: Object("sas::DataloggerClient"),
  publisher_(node->create_publisher<sas_msgs::msg::LogDatum>("/sas_datalogger/log", queue_size))
{
}

bool DataloggerClient::is_enabled(const int & server_count) const
{
  return static_cast<int>(publisher_->get_subscription_count()) >= server_count;
}

void DataloggerClient::log(const std::string & name, const Eigen::MatrixXd & value)
{
  sas_msgs::msg::LogDatum datum;
  datum.name = name;
  datum.layout = {static_cast<int>(value.rows()), static_cast<int>(value.cols())};
  for (const auto & row : value.rowwise()) {
    datum.value.insert(datum.value.end(), row.begin(), row.end());
  }
  publisher_->publish(datum);
}

void DataloggerClient::log(const std::string & name, const Eigen::VectorXd & value)
{
  log(name, std::vector<double>(value.data(), value.data() + value.size()));
}

void DataloggerClient::log(const std::string & name, const std::vector<double> & value)
{
  sas_msgs::msg::LogDatum datum;
  datum.name = name;
  datum.value = value;
  publisher_->publish(datum);
}

void DataloggerClient::log(const std::string & name, const double & value)
{
  log(name, std::vector<double>{value});
}

void DataloggerClient::log(const std::string & name, const std::string & value)
{
  sas_msgs::msg::LogDatum datum;
  datum.name = name;
  datum.strvalue = value;
  publisher_->publish(datum);
}

}  // namespace sas
