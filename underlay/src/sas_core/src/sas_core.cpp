#include <sas_core/sas_core.hpp>

#include <string>

namespace sas
{

Eigen::VectorXd concatenate(const Eigen::VectorXd & a, const Eigen::VectorXd & b)
{
  return concatenate(std::vector<Eigen::VectorXd>{a, b});
}

Eigen::VectorXd concatenate(const std::vector<Eigen::VectorXd> & as)
{
  Eigen::Index size = 0;
  for (const auto & a : as) {
    size += a.size();
  }
  Eigen::VectorXd all(size);
  Eigen::Index begin = 0;
  for (const auto & a : as) {
    all.segment(begin, a.size()) = a;
    begin += a.size();
  }
  return all;
}

Eigen::MatrixXd vstack(const Eigen::MatrixXd & a, const Eigen::MatrixXd & b)
{
  if (a.size() == 0 || b.size() == 0) {
    return a.size() == 0 ? b : a;
  }
  if (a.cols() != b.cols()) {
    throw std::range_error(
      "sas::vstack: both matrices must have the same number of columns; they have " +
      std::to_string(a.cols()) + " and " + std::to_string(b.cols()) + ".");
  }
  Eigen::MatrixXd stacked(a.rows() + b.rows(), a.cols());
  stacked.topRows(a.rows()) = a;
  stacked.bottomRows(b.rows()) = b;
  return stacked;
}

Eigen::MatrixXd block_diag(const std::vector<Eigen::MatrixXd> & as)
{
  Eigen::Index rows = 0, columns = 0;
  for (const auto & a : as) {
    rows += a.rows();
    columns += a.cols();
  }
  Eigen::MatrixXd diagonal = Eigen::MatrixXd::Zero(rows, columns);
  for (auto a = as.rbegin(); a != as.rend(); ++a) {
    rows -= a->rows();
    columns -= a->cols();
    diagonal.block(rows, columns, a->rows(), a->cols()) = *a;
  }
  return diagonal;
}

std::vector<Eigen::VectorXd> split(const Eigen::VectorXd & a, const std::vector<int> & ns)
{
  std::vector<Eigen::VectorXd> parts;
  Eigen::Index begin = 0;
  for (const int n : ns) {
    if (n < 0 || n > a.size() - begin) {
      throw std::range_error(
        "sas::split: a vector of " + std::to_string(a.size()) + " elements has no part of " +
        std::to_string(n) + " elements from element " + std::to_string(begin) + " on.");
    }
    parts.emplace_back(a.segment(begin, n));
    begin += n;
  }
  return parts;
}

}  // namespace sas
