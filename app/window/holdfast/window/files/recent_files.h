#pragma once
/// \file
/// The files that were open last, kept in the user's settings.

#include <QObject>
#include <QStringList>

class QMenu;

namespace holdfast {

/// At most this many.
inline constexpr int kMostRecentFiles = 10;

/// Meshes and sessions by their absolute paths, the latest first. The settings are the one truth: several windows share
/// them.
class RecentFiles : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  [[nodiscard]] QStringList paths() const;
  void add(const QString& path);
  void remove(const QString& path);
  void clear();

  /// Puts an entry for each file in the place of what is in `menu`; one that is missing is grey. Call it each time
  /// before the menu is shown.
  void fill(QMenu& menu);

 Q_SIGNALS:
  void chosen(const QString& path);
};

}  // namespace holdfast
