#pragma once
/// A mesh file and all that the window needs of it, made on any thread.

#include <filesystem>
#include <memory>

#include <holdfast/base/progress.h>
#include <holdfast/constraints/selector.h>
#include <holdfast/deform/model.h>
#include <holdfast/io/mesh_document.h>
#include <holdfast/surface/vertex_regions.h>
#include <holdfast/widgets/picking/visible_surface.h>
#include <holdfast/widgets/scene/scene_contents.h>

namespace holdfast {

struct LoadedMesh {
  std::filesystem::path path;
  MeshDocument document;
  std::shared_ptr<const Model> model;
  std::shared_ptr<Selector> selector;
  std::shared_ptr<VertexRegions> regions;
  std::shared_ptr<SceneContents> contents;        ///< at rest, with the coarse triangles of large meshes
  std::shared_ptr<const VisibleSurface> surface;  ///< at rest, ready for rays
};

/// Throws as `readAnyMesh` and `makeModel` do, and what `progress` throws.
[[nodiscard]] LoadedMesh loadMesh(const std::filesystem::path& path, Progress& progress);

/// The same for a mesh in memory; `path` names it.
[[nodiscard]] LoadedMesh prepareMesh(MeshDocument document, const std::filesystem::path& path, Progress& progress);

/// Whether a full picture of it may take too long for a movement.
[[nodiscard]] bool isLarge(const Model& model);

}  // namespace holdfast
