#include <string_view>

#include <gtest/gtest.h>

#include "isolated_application.h"
#include "kept_window.h"

int main(int argc, char** argv)
{
  ::testing::InitGoogleTest(&argc, argv);
  const holdfast::test::IsolatedApplication application(argc, argv, "holdfast-tests");
  if (argc == 3 && std::string_view(argv[1]) == holdfast::test::kWorkUntilKilled)
    return holdfast::test::workUntilKilled(argv[2]);
  return RUN_ALL_TESTS();
}
