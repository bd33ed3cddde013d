#pragma once
/// What constraints of a constraint file are made of: selections of vertices, points of the surface, handles.

#include <holdfast/constraint_files/json_reader_internal.h>
#include <holdfast/constraints/constraint.h>
#include <holdfast/constraints/selection.h>
#include <holdfast/surface/surface_location.h>

namespace holdfast {

/// The selection that an object states: {"vertices": [...]}, {"box": {...}}, ... Throws `InputError`.
[[nodiscard]] Selection readSelection(const JsonReader& json);

/// The point of the surface that an object states: {"vertex": 3}, {"edge": [1, 2], "t": 0.5}, ... Throws `InputError`.
[[nodiscard]] SurfaceLocation readLocation(const JsonReader& json);

/// The handle that the constraint states. Throws `InputError`.
[[nodiscard]] HandleConstraint readHandle(const JsonReader& json);

}  // namespace holdfast
