#pragma once
/// The files that were open last, by their absolute paths, the latest first, in the user's settings.

#include <QMenu>
#include <functional>

namespace holdfast {

inline constexpr int kMostRecentFiles = 10;

[[nodiscard]] QStringList recentFiles();
void addRecentFile(const QString& path);
void removeRecentFile(const QString& path);

/// Replaces the entries of `menu` by one for each file; `open` gets the path that the user chooses.
void fillRecentMenu(QMenu& menu, const std::function<void(const QString&)>& open);

}  // namespace holdfast
