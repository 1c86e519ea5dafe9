#include <iostream>
#include <stdexcept>

void initialize()
{
  std::cout << "motor 1 on" << std::endl;
  throw std::runtime_error("no motor 2");
}

int main()
{
  try {
    initialize();
    std::cout << "loop" << std::endl;
  } catch (const std::runtime_error & error) {
    std::cout << error.what() << std::endl;
  }
  std::cout << "motors off" << std::endl;
  return 0;
}
