#pragma once
/// \file
/// One include for all that a program needs to deform meshes: the public headers of `holdfast::core`.
///
///     const holdfast::Model model = holdfast::makeModel({positions, holdfast::Polygons(triangles)});
///     const holdfast::DeformResult result = holdfast::deform(model, constraints);
///
/// A model is made of a mesh (`mesh.h`), which comes from memory or from a file (`mesh_file.h`). Constraints are values
/// (`constraint.h`), or come from a file (`constraint_file.h`). The function `deform` (`deform.h`) deforms once. A
/// `Deformer` (`deformer.h`) deforms again and again. The report (`report.h`) names the constraints that repeat others
/// and those that conflict, and `report_json.h` makes files of it. `fields.h` gives residuals, rotations and
/// displacements as numbers over the vertices, and `field_file.h` writes them. Wrong input throws what `error.h` has.
/// Long work tells how far it is through `progress.h`.

#include <holdfast/constraint_files/constraint_file.h>
#include <holdfast/constraints/constraint.h>
#include <holdfast/deform/deform.h>
#include <holdfast/deform/deformer.h>
#include <holdfast/deform/fields.h>
#include <holdfast/deform/model.h>
#include <holdfast/deform/report.h>
#include <holdfast/deform/report_json.h>
#include <holdfast/io/field_file.h>
#include <holdfast/io/mesh_file.h>
#include <holdfast/mesh/mesh.h>
#include <holdfast/threads/progress.h>
#include <holdfast/version.h>
#include <holdfast/words/error.h>
