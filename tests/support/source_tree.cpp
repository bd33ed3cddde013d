#include "support/source_tree.h"

namespace holdfast::test {

std::string dataFolder()
{
  return HOLDFAST_DATA_DIR;
}

std::string sourceFolder()
{
  return HOLDFAST_SOURCE_DIR;
}

}  // namespace holdfast::test
