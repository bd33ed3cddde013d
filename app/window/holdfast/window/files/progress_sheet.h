#pragma once
/// \file
/// Tells how far long work is, and lets the user end it; the window stays usable.

#include <QObject>
#include <QPointer>
#include <QString>
#include <QTimer>

class QProgressDialog;
class QWidget;

namespace holdfast {

class BackgroundJob;

/// A small dialog beside the window for as long as `job` runs, once that has been longer than a moment.
class ProgressSheet : public QObject {
  Q_OBJECT

 public:
  ProgressSheet(BackgroundJob& job, QWidget* window);
  ~ProgressSheet() override;

  /// What the work is, for the dialog's title.
  void setTitle(const QString& title) { title_ = title; }

 private:
  void show();

  BackgroundJob& job_;
  QWidget* window_;
  QString title_;
  QString step_;
  QTimer delay_;
  QPointer<QProgressDialog> dialog_;  // a child of the window
};

}  // namespace holdfast
