#pragma once
/// Lets a user choose what applies to all documents.

#include <QActionGroup>
#include <QDialog>
#include <functional>
#include <optional>

namespace holdfast {

struct Preferences {
  QList<QActionGroup*> choices;  ///< of menus, with their titles as object names
  QString unit;                  ///< of lengths; may be empty
  std::function<void(const QString&)> setUnit;
  std::optional<int> decimals;  ///< of lengths; none: four significant digits
  std::function<void(std::optional<int>)> setDecimals;
  QAction* reset = nullptr;  ///< puts everything back
};

/// Makes a dialog for the preferences. Each change applies at once.
[[nodiscard]] QDialog* newPreferencesDialog(const Preferences& preferences, QWidget* window);

}  // namespace holdfast
