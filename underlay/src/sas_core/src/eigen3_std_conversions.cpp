#include <sas_core/eigen3_std_conversions.hpp>

namespace
{

template<typename Vector>
auto to_std(const Vector & vector)
{
  return std::vector<typename Vector::Scalar>(vector.data(), vector.data() + vector.size());
}

template<typename Vector>
Vector to_eigen(const std::vector<typename Vector::Scalar> & vector)
{
  return Eigen::Map<const Vector>(vector.data(), static_cast<Eigen::Index>(vector.size()));
}

}  // namespace

namespace sas
{

std::vector<double> vectorxd_to_std_vector_double(const Eigen::VectorXd & vector)
{
  return to_std(vector);
}

Eigen::VectorXd std_vector_double_to_vectorxd(const std::vector<double> & vector)
{
  return to_eigen<Eigen::VectorXd>(vector);
}

std::vector<int> vectorxi_to_std_vector_int(const Eigen::VectorXi & vector)
{
  return to_std(vector);
}

Eigen::VectorXi std_vector_int_to_vectorxi(const std::vector<int> & vector)
{
  return to_eigen<Eigen::VectorXi>(vector);
}

}  // namespace sas
