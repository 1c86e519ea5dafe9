#ifndef CPP_PACKAGE_WITH_A_LIBRARY__SAMPLE_CLASS_HPP_
#define CPP_PACKAGE_WITH_A_LIBRARY__SAMPLE_CLASS_HPP_

#include <iosfwd>
#include <memory>
#include <string>

class SampleClass final
{
public:
  SampleClass();
  ~SampleClass();
  SampleClass(const SampleClass &) = delete;
  SampleClass & operator=(const SampleClass &) = delete;

  [[nodiscard]] const int & get_a_private_member() const noexcept;
  void set_a_private_member(const int & value) noexcept;
  [[nodiscard]] std::string to_string() const;
  [[nodiscard]] static double sum_of_squares(const double & a, const double & b) noexcept;

  friend std::ostream & operator<<(std::ostream & stream, const SampleClass & sample);

private:
  struct Inside;
  std::unique_ptr<Inside> inside_;
};

#endif  // CPP_PACKAGE_WITH_A_LIBRARY__SAMPLE_CLASS_HPP_
