// The window's story in numbered pictures: everything that a user does in it, as real events, on the project's own
// data.
//   holdfast_tour FOLDER                  writes FOLDER/01_empty.png and so on
//   holdfast_tour FOLDER CHAPTER...       these chapters alone; goes on in the count of the pictures that are there
// Ends with 1 and says where a step failed.

#include <QApplication>
#include <algorithm>
#include <array>
#include <cstdio>
#include <string_view>
#include <vector>

#include "chapters.h"
#include "window/isolated_application.h"

namespace holdfast::tour {
namespace {

struct Chapter {
  std::string_view name;
  void (*play)(TourWindow& tour);
};

constexpr std::array kChapters{Chapter{"opening", opening},
                               Chapter{"moving", moving},
                               Chapter{"conflicts", conflicts},
                               Chapter{"colors", colors},
                               Chapter{"rotations", rotations},
                               Chapter{"regions", regions},
                               Chapter{"dialogs", dialogs},
                               Chapter{"looks", looks},
                               Chapter{"glance", glance},
                               Chapter{"sizes", sizes},
                               Chapter{"documents", documentPictures}};

// The first ones.
constexpr std::size_t kStory = 8;

/// Empty where one of the names is none.
std::vector<Chapter> chaptersNamed(const std::vector<std::string_view>& names)
{
  if (names.empty()) return {kChapters.begin(), kChapters.begin() + kStory};
  std::vector<Chapter> chapters;
  for (const std::string_view name : names) {
    const auto* found =
        std::find_if(kChapters.begin(), kChapters.end(), [&](const Chapter& chapter) { return chapter.name == name; });
    if (found == kChapters.end()) return {};
    chapters.push_back(*found);
  }
  return chapters;
}

int usage()
{
  std::fprintf(stderr, "usage: holdfast_tour FOLDER [CHAPTER...]\nchapters:");
  for (const Chapter& chapter : kChapters) std::fprintf(stderr, " %s", chapter.name.data());
  std::fprintf(stderr, "\n");
  return 2;
}

int run(int argc, char** argv)
{
  if (argc < 2) return usage();
  const auto chapters = chaptersNamed({argv + 2, argv + argc});
  if (chapters.empty()) return usage();
#if QT_VERSION < QT_VERSION_CHECK(6, 0, 0)
  QApplication::setAttribute(Qt::AA_EnableHighDpiScaling);
  QApplication::setAttribute(Qt::AA_UseHighDpiPixmaps);
#endif
  const test::IsolatedApplication application(argc, argv, "holdfast-tour");
  std::string_view now = "the beginning";
  try {
    TourWindow tour(argv[1], argc > 2 ? picturesIn(argv[1]) : 0);
    for (const Chapter& chapter : chapters) {
      now = chapter.name;
      chapter.play(tour);
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "holdfast_tour: this does not hold in %s: %s\n", now.data(), error.what());
    return 1;
  }
  return 0;
}

}  // namespace
}  // namespace holdfast::tour

int main(int argc, char** argv)
{
  return holdfast::tour::run(argc, argv);
}
