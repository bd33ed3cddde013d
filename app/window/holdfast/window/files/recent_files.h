#pragma once
/// The files that were open last, by their absolute paths, the latest first, in the user's settings.

#include <QImage>
#include <QMenu>
#include <functional>

namespace holdfast {

inline constexpr int kMostRecentFiles = 10;

[[nodiscard]] QStringList recentFiles();
void addRecentFile(const QString& path);
void removeRecentFile(const QString& path);

/// Twice as large as they are shown: for screens of high resolution.
inline constexpr QSize kRecentPictureSize(320, 240);
/// The middle of `picture` at that size.
[[nodiscard]] QImage fitted(const QImage& picture);
/// The file of the picture that was kept of a recent file; it need not exist.
[[nodiscard]] QString recentPicture(const QString& path);
/// Keeps what `path` looks like, and drops pictures of files that are not recent any more.
void keepRecentPicture(const QString& path, const QImage& picture);

/// The same name in the folder that was used last for this purpose ("export"); `suggestion` itself before the first.
[[nodiscard]] QString inLastFolder(const QString& purpose, const QString& suggestion);
void rememberFolder(const QString& purpose, const QString& path);
/// All settings but the recent files.
void forgetSettings();

/// Replaces the entries of `menu` by one for each file; `open` gets the path that the user chooses.
void fillRecentMenu(QMenu& menu, const std::function<void(const QString&)>& open);

}  // namespace holdfast
