#pragma once
/// \file
/// The gestures that are worth knowing, on one page.

#include <QDialog>

namespace holdfast {

class HelpDialog : public QDialog {
  Q_OBJECT

 public:
  explicit HelpDialog(QWidget* parent = nullptr);
};

}  // namespace holdfast
