#pragma once
/// The files that were open last, by their absolute paths, the latest first. The user's settings are the one truth:
/// several windows share them.

#include <QStringList>
#include <functional>

class QMenu;

namespace holdfast {

inline constexpr int kMostRecentFiles = 10;

[[nodiscard]] QStringList recentFiles();
void addRecentFile(const QString& path);
void removeRecentFile(const QString& path);

/// Replaces the entries of `menu` by one for each file; entries of missing files are grey. Call it each time before the
/// menu is shown. `open` gets the path that the user chooses.
void fillRecentMenu(QMenu& menu, const std::function<void(const QString&)>& open);

}  // namespace holdfast
