#pragma once
/// \file
/// The panel that tells how the mesh was solved, and chooses how.

#include <QWidget>
#include <vector>

#include <holdfast/window/model/editor.h>
#include <holdfast/window/text/report_text.h>

class QComboBox;
class QFormLayout;
class QLabel;
class QPushButton;

namespace holdfast {

class NumberEdit;

/// The options of an editor and the report of its newest deformation.
class ReportPanel : public QWidget {
  Q_OBJECT

 public:
  /// `editor` stays alive as long as this.
  explicit ReportPanel(Editor& editor, QWidget* parent = nullptr);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void makeOptions();
  void refresh();
  void refreshOptions();
  void refreshReport();
  void show(const ReportLines& lines);
  void choose();
  void setSoftWeight(double weight);
  void refuse(const QString& reason);
  void copy();

  Editor& editor_;
  QFormLayout* options_ = nullptr;
  QComboBox* weights_ = nullptr;
  QComboBox* solver_ = nullptr;
  NumberEdit* softWeight_ = nullptr;
  QLabel* age_ = nullptr;
  QFormLayout* report_ = nullptr;
  std::vector<QLabel*> values_;
  QPushButton* copy_ = nullptr;
};

}  // namespace holdfast
