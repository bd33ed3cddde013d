#pragma once
/// \file
/// Offers what crashed programs have left.

#include <QDialog>
#include <vector>

#include <holdfast/document/recovery.h>

class QListWidget;
class QPushButton;

namespace holdfast {

/// One entry for each copy, the newest first.
class RecoveryDialog : public QDialog {
  Q_OBJECT

 public:
  explicit RecoveryDialog(std::vector<Recoverable> copies, QWidget* parent = nullptr);

 Q_SIGNALS:
  /// The user wants this one opened. The dialog closes; the others are left for later.
  void recoverWanted(const Recoverable& copy);

 private:
  void recover();
  void discardChosen();
  void updateButtons();

  std::vector<Recoverable> copies_;
  QListWidget* list_;
  QPushButton* recover_;
  QPushButton* discard_;
};

}  // namespace holdfast
