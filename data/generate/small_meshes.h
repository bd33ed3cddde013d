#pragma once
/// \file
/// Small meshes with one peculiarity each, as text.

#include <string>

namespace holdfast::generate {

/// A cube of side 10 as STL stores it: every triangle with three corners of its own.
[[nodiscard]] std::string unweldedCubeStl();

/// Two cubes of side 10 that touch along a side without sharing a vertex: coincident places, two connected parts.
[[nodiscard]] std::string twoPartsObj();

/// A torus of quadrilaterals with texture coordinates (one more row and column than vertices, for the seam), two
/// groups and two materials of `materialFile`.
[[nodiscard]] std::string quadsObj(const std::string& materialFile);
[[nodiscard]] std::string quadsMaterials();

}  // namespace holdfast::generate
