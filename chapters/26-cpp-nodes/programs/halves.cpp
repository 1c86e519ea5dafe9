#include <iostream>
#include <vector>

int main()
{
  std::vector<int> speeds{7};
  for (int speed : speeds) {
    speed = speed / 2;
  }
  std::cout << speeds.front() << std::endl;

  for (int & speed : speeds) {
    speed = speed / 2;
  }
  std::cout << speeds.front() << std::endl;
  return 0;
}
