#include <iostream>
#include <memory>

struct Wheel
{
  ~Wheel() { std::cout << "deleted" << std::endl; }
};

int main()
{
  auto first = std::make_shared<Wheel>();
  auto second = first;
  std::weak_ptr<Wheel> note = first;

  first = nullptr;
  std::cout << "one" << std::endl;
  second = nullptr;
  std::cout << "two" << std::endl;
  return 0;
}
