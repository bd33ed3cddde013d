// A race, which the thread sanitizer must find: the control of all that it does not find elsewhere.

#include <thread>

int main()
{
  int written = 0;
  std::thread other([&] { written = 1; });
  written = 2;
  other.join();
  return 0;
}
