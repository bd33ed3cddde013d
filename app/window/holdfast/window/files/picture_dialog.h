#pragma once
/// \file
/// Asks how large an exported picture is, and whether it has a legend.

#include <QDialog>

#include <holdfast/widgets/scene/scene.h>

class QCheckBox;
class QSpinBox;

namespace holdfast {

/// Remembers the last answer in the user's settings.
class PictureDialog : public QDialog {
  Q_OBJECT

 public:
  explicit PictureDialog(QWidget* parent = nullptr);

  [[nodiscard]] PictureSize size() const;
  [[nodiscard]] Legend legend() const;

  void accept() override;

 private:
  QSpinBox* width_;
  QSpinBox* height_;
  QCheckBox* legend_;
};

}  // namespace holdfast
