#pragma once
/// \file
/// Files that are dropped on the window.

#include <QString>
#include <QStringList>

class QMimeData;

namespace holdfast {

/// The paths of those that lie on this computer; none where something else is dragged.
[[nodiscard]] QStringList localFiles(const QMimeData& data);

/// What to do with files that come together: one document is open at a time, and a list of constraints belongs to it.
struct DroppedFiles {
  QString taken;          ///< the first document; the first list where there is none
  bool isList = false;    ///< of constraints or points (`.json`, `.csv`)
  QStringList leftAlone;  ///< the others
};

/// `paths` is not empty.
[[nodiscard]] DroppedFiles sorted(const QStringList& paths);

}  // namespace holdfast
