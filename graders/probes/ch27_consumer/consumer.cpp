// A program in another package that checks what the learner's library does.
#include <sstream>
#include <string>
#include <vector>

#include <link.h>

#include "ask.hpp"
#include "cpp_package_with_a_library/sample_class.hpp"

namespace
{

// The results of the function for two const objects, one for each value.
template<typename Function>
auto both(Function && function)
{
  SampleClass one, other;
  one.set_a_private_member(-3);
  other.set_a_private_member(41);
  const SampleClass & first = one, & second = other;
  return std::vector{function(first), function(second)};
}

int remember(dl_phdr_info * library, std::size_t, void * names)
{
  static_cast<std::vector<std::string> *>(names)->emplace_back(library->dlpi_name);
  return 0;
}

std::vector<std::string> loaded()
{
  std::vector<std::string> names;
  dl_iterate_phdr(remember, &names);
  return names;
}

}  // namespace

int main()
{
  ask("loaded", loaded);
  ask("at first", [] {return SampleClass().get_a_private_member();});
  ask("members", [] {
      return both([](const SampleClass & sample) {return sample.get_a_private_member();});
    });
  ask("texts", [] {
      return both([](const SampleClass & sample) {return std::string(sample.to_string());});
    });
  ask("streamed", [] {
      return both([](const SampleClass & sample) {
          std::ostringstream stream;
          stream << sample << "|";  // which has to be the stream still
          return stream.str();
        });
    });
  ask("sums", [] {
      return std::vector<double>{
        SampleClass::sum_of_squares(2.0, 3.0), SampleClass::sum_of_squares(0.5, -1.25),
        SampleClass::sum_of_squares(-4.0, 1.0)};
    });
  done();
  return 0;
}
