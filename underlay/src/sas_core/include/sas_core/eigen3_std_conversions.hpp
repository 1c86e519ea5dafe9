// Vectors of Eigen from vectors of the standard library, and back.

#pragma once

#include <vector>

#include <Eigen/Dense>

namespace sas
{

std::vector<double> vectorxd_to_std_vector_double(const Eigen::VectorXd & vector);
Eigen::VectorXd std_vector_double_to_vectorxd(const std::vector<double> & vector);

std::vector<int> vectorxi_to_std_vector_int(const Eigen::VectorXi & vector);
Eigen::VectorXi std_vector_int_to_vectorxi(const std::vector<int> & vector);

}  // namespace sas

using namespace Eigen;  // NOLINT: programs of this family write VectorXd without a namespace
