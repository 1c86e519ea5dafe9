#include <sas_conversions/std_std_msgs_conversions.hpp>

namespace sas
{

double std_msgs_float64_to_double(const sas_msgs::msg::Float64 & f64)
{
  return f64.data;
}

sas_msgs::msg::Float64 double_to_std_msgs_float64(const double & d)
{
  sas_msgs::msg::Float64 message;
  message.data = d;
  return message;
}

bool std_msgs_bool_to_bool(const sas_msgs::msg::Bool & b)
{
  return b.data;
}

sas_msgs::msg::Bool bool_to_std_msgs_bool(const bool & b)
{
  sas_msgs::msg::Bool message;
  message.data = b;
  return message;
}

}  // namespace sas
