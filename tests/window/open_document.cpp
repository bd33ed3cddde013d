#include "open_document.h"

#include <utility>

#include <holdfast/constraint_files/constraint_file.h>

#include "gestures.h"
#include "support/source_tree.h"

namespace holdfast::test {

bool waitForCurrent(const Editor& editor)
{
  return waitUntil([&] { return editor.solveState() == SolveState::Current; });
}

bool openData(Editor& editor, const std::string& mesh, const std::string& constraints)
{
  const std::string path = dataFolder() + '/' + mesh;
  NoProgress quiet;
  editor.open(loadMesh(path, quiet), {readConstraints(dataFolder() + '/' + constraints), {}});
  return waitForCurrent(editor);
}

bool openMesh(Editor& editor, Mesh mesh, ConstraintList list)
{
  MeshDocument document;
  document.mesh = std::move(mesh);
  NoProgress quiet;
  editor.open(prepareMesh(std::move(document), "mesh", quiet), {std::move(list), {}});
  return waitForCurrent(editor);
}

}  // namespace holdfast::test
