#include "open_document.h"

#include <utility>

#include <holdfast/constraints/constraint_file.h>
#include <holdfast/io/mesh_file.h>

#include "gestures.h"
#include "support/source_tree.h"

namespace holdfast::test {

bool waitForCurrent(const Editor& editor)
{
  return waitUntil([&] { return editor.freshness() == Freshness::Current; });
}

bool openData(Editor& editor, const std::string& mesh, const std::string& constraints)
{
  const std::string path = dataFolder() + '/' + mesh;
  MeshDocument document = readMesh(path);
  auto model = std::make_shared<const Model>(makeModel(document.mesh, path));
  editor.open(std::move(document), std::move(model), QString::fromStdString(path),
              {readConstraints(dataFolder() + '/' + constraints), {}});
  return waitForCurrent(editor);
}

bool openMesh(Editor& editor, Mesh mesh, ConstraintList list)
{
  MeshDocument document;
  document.mesh = std::move(mesh);
  auto model = std::make_shared<const Model>(makeModel(document.mesh, "mesh"));
  editor.open(std::move(document), std::move(model), "mesh", {std::move(list), {}});
  return waitForCurrent(editor);
}

}  // namespace holdfast::test
