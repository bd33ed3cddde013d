#pragma once
/// \file
/// What a surface can be coloured by, in words.

#include <QString>

#include <holdfast/widgets/color/coloring.h>

namespace holdfast {

struct FieldText {
  QString name;     ///< short, for a list
  QString meaning;  ///< a sentence
};

[[nodiscard]] FieldText fieldText(ColorBy field);

/// "Unit: mm." `units` is the user's name of the model's length; it may be empty.
[[nodiscard]] QString unitSentence(ColorBy field, const QString& units, Weights weights);

}  // namespace holdfast
