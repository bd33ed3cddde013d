#pragma once
/// What a surface can be coloured by, in words.

#include <QString>

#include <holdfast/widgets/color/coloring.h>

namespace holdfast {

/// What decides how a value of a field is written.
struct ValueMeaning {
  ColorBy field = ColorBy::None;
  std::optional<double> promise = std::nullopt;  ///< what is no larger is met
};

/// "0.42", "met ≤ 1.6e-10"; a length with the document's decimals, where there are any. "none here" for NaN.
[[nodiscard]] QString valueText(double value, const ValueMeaning& meaning, std::optional<int> decimals);

/// The unit vector about which the detail at a point is rotated, the right hand's way; none where it is not rotated.
[[nodiscard]] std::optional<Vector3> rotationAxis(const Model& model, const DeformResult& deformation,
                                                  const SurfacePoint& point);

struct FieldText {
  QString name;     ///< short, for a list
  QString meaning;  ///< sentences, with the unit
};

/// `units` is the user's name of the model's length; it may be empty.
[[nodiscard]] FieldText fieldText(ColorBy field, const QString& units = {}, Weights weights = Weights::Cotangent);

}  // namespace holdfast
