#pragma once
/// Says in words what a surface can be coloured by.

#include <QString>

#include <holdfast/widgets/color/coloring.h>

namespace holdfast {

/// Decides how a value of a field is written.
struct ValueMeaning {
  ColorBy field = ColorBy::None;
  std::optional<double> promise = std::nullopt;  ///< what is no larger is met
};

/// Returns the text of a value: "0.42", "met ≤ 1.6e-10", or "none here" for NaN. A length has the document's decimals,
/// if there are any.
[[nodiscard]] QString valueText(double value, const ValueMeaning& meaning, std::optional<int> decimals);

/// Returns the unit vector about which the detail at a point is rotated by the right-hand rule. There is none where the
/// detail is not rotated.
[[nodiscard]] std::optional<Vector3> rotationAxis(const Model& model, const DeformResult& deformation,
                                                  const SurfacePoint& point);

struct FieldText {
  QString name;     ///< short, for a list
  QString meaning;  ///< sentences, with the unit
};

/// Returns the name and the meaning of a field. `units` is the user's name of the model's unit of length; it may be
/// empty.
[[nodiscard]] FieldText fieldText(ColorBy field, const QString& units = {}, Weights weights = Weights::Cotangent);

}  // namespace holdfast
