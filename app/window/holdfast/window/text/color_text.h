#pragma once
/// What a surface can be coloured by, in words.

#include <QString>

#include <holdfast/widgets/color/coloring.h>

namespace holdfast {

struct FieldText {
  QString name;     ///< short, for a list
  QString meaning;  ///< sentences, with the unit
};

/// `units` is the user's name of the model's length; it may be empty.
[[nodiscard]] FieldText fieldText(ColorBy field, const QString& units = {}, Weights weights = Weights::Cotangent);

}  // namespace holdfast
