#pragma once
/// Keeps the files that were open last in the user's settings. Paths are absolute, and the latest file is first.

#include <QImage>
#include <QMenu>
#include <functional>

namespace holdfast {

inline constexpr int kMostRecentFiles = 10;

[[nodiscard]] QStringList recentFiles();
void addRecentFile(const QString& path);
void removeRecentFile(const QString& path);

/// Pictures are kept twice as large as they are shown, for screens of high resolution.
inline constexpr QSize kRecentPictureSize(320, 240);
/// Returns the middle of `picture` at that size.
[[nodiscard]] QImage fitted(const QImage& picture);
/// Returns the file of the picture that was kept of a recent file. It need not exist.
[[nodiscard]] QString recentPicture(const QString& path);
/// Keeps what `path` looks like, and drops pictures of files that are not recent any more.
void keepRecentPicture(const QString& path, const QImage& picture);

/// Returns the name of `suggestion` in the folder that was used last for this purpose, such as "export". Before the
/// first use, and if that folder is gone, it returns `suggestion` itself.
[[nodiscard]] QString inLastFolder(const QString& purpose, const QString& suggestion);
void rememberFolder(const QString& purpose, const QString& path);
/// Forgets all settings but the recent files.
void forgetSettings();

/// Replaces the entries of `menu` by one for each file; `open` gets the path that the user chooses.
void fillRecentMenu(QMenu& menu, const std::function<void(const QString&)>& open);

}  // namespace holdfast
