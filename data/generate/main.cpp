// Writes the example data into the folder named by the only argument.

#include <exception>
#include <iostream>

#include "files.h"
#include "write.h"

int main(int argc, char** argv)
{
  namespace generate = holdfast::generate;
  if (argc != 2) {
    std::cerr << "usage: holdfast_make_data FOLDER\n";
    return 2;
  }
  try {
    for (const auto& make : {generate::bracketFiles, generate::barFiles, generate::plateFiles, generate::headFiles,
                             generate::smallFiles}) {
      for (const generate::File& file : make())
        generate::writeFile(std::filesystem::path(argv[1]) / file.name, file.bytes);
    }
  } catch (const std::exception& error) {
    std::cerr << "holdfast_make_data: " << error.what() << "\n";
    return 1;
  }
  return 0;
}
