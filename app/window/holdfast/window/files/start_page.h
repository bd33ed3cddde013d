#pragma once
/// Shows recent files and the bundled examples while nothing is open.

#include <QGridLayout>
#include <QLabel>
#include <QPixmap>
#include <QToolButton>
#include <functional>
#include <vector>

#include <holdfast/window/files/document_files.h>

namespace holdfast {

/// The gallery shows buttons with pictures. It puts as many in a row as there is room for.
class Gallery : public QWidget {
 public:
  Gallery();

  void clear();
  void add(const QString& title, const QString& tip, const QPixmap& picture, std::function<void()> open);

  /// Returns the minimum size of one button, not of the last row: a gallery that becomes narrower arranges its buttons
  /// anew.
  [[nodiscard]] QSize minimumSizeHint() const override;

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void arrange();

  QGridLayout* grid_;
  std::vector<QToolButton*> buttons_;
};

/// The start page covers its parent while no document is open.
class StartPage : public QWidget {
  Q_OBJECT

 public:
  StartPage(Editor& editor, DocumentFiles& files, QWidget* parent);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void showEvent(QShowEvent* event) override;

 private:
  DocumentFiles& files_;
  QLabel* recentTitle_;
  Gallery* recent_;
  Gallery* examples_;
};

}  // namespace holdfast
