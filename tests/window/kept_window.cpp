#include "kept_window.h"

#include <cstdio>

#include "gestures.h"

namespace holdfast::test {

namespace fs = std::filesystem;

KeptWindow::KeptWindow(const fs::path& recoveryFolder)
    : autosave(std::make_unique<Autosave>(editor, files, recoveryFolder, &window))
{
  autosave->setDelay(std::chrono::milliseconds(1));
  QObject::connect(autosave.get(), &Autosave::kept, autosave.get(), [this] { ++kept; });
}

bool KeptWindow::waitForCopy(int number)
{
  return waitUntil([&] { return kept >= number; });
}

std::vector<fs::path> copiesIn(const fs::path& folder)
{
  std::vector<fs::path> copies;
  if (!fs::exists(folder)) return copies;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.path().extension() == ".holdfast") copies.push_back(entry.path());
  return copies;
}

ConstraintList workOf(const ConstraintList& list)
{
  ConstraintList work = list;
  work.units = "mm";
  work.constraints.push_back({"tenth", true, PointConstraint{AtVertex{7}, Target{{0.1, 1.0 / 3.0, -2e-17}}}});
  work.constraints.push_back({"off", false, PointConstraint{AtVertex{8}, Move{{1e300, 5e-324, -0.0}}}});
  return work;
}

int workUntilKilled(const fs::path& folder)
{
  KeptWindow w(folder / "recovery");
  const bool isSaved = fs::exists(folder / "part.holdfast");
  if (!showAndWait(w.window) || !w.open(folder / (isSaved ? "part.holdfast" : "bracket.obj"))) return 1;
  w.editor.edit("work", workOf(w.editor.list()));
  DeformOptions options;
  options.weights = Weights::Uniform;
  w.editor.setOptions("weights", options);
  const auto isKept = [&] {
    const std::vector<fs::path> copies = copiesIn(folder / "recovery");
    return copies.size() == 1 && readSession(copies[0]).document.options == options;
  };
  if (!waitUntil(isKept)) return 1;
  std::fprintf(stderr, "%s\n", kWorkIsKept);
  static_cast<void>(waitUntil([] { return false; }));
  return 1;
}

}  // namespace holdfast::test
