#pragma once
/// \file
/// What the constraints of a file would do to the document, before they are taken in.

#include <QDialog>
#include <filesystem>
#include <memory>

#include <holdfast/window/files/file_chooser.h>
#include <holdfast/window/files/import_table_model.h>
#include <holdfast/window/model/background_job.h>
#include <holdfast/window/model/editor.h>

class QLabel;
class QProgressBar;
class QPushButton;
class QTableView;

namespace holdfast {

class NumberEdit;

/// Reads a constraint file or a point list on a thread of its own and shows it as a table; those that are ticked become
/// one edit, at the end of the list.
class ImportDialog : public QDialog {
  Q_OBJECT

 public:
  /// The editor has an open document.
  ImportDialog(Editor& editor, std::filesystem::path path, QWidget* parent = nullptr);

  void accept() override;

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  QWidget* makeToleranceRow();
  void makeTable();
  QWidget* makeButtons();
  void show(ImportContents contents);
  void updateTexts();
  [[nodiscard]] QString summary() const;
  [[nodiscard]] QString editName(std::size_t count) const;

  Editor& editor_;
  std::filesystem::path path_;
  ImportTableModel model_;
  QLabel* summary_;
  QProgressBar* busy_;
  NumberEdit* tolerance_;
  QTableView* table_;
  QPushButton* import_;
  BackgroundJob job_;
};

/// About a hundredth of the diagonal of the model's box: farther points are likely to be in another unit.
[[nodiscard]] double usualImportTolerance(const Model& model);

/// Asks for a file, and opens an `ImportDialog` over `window`, which goes on. The editor has an open document.
void importConstraints(Editor& editor, QWidget* window, const FileChooser& chooser = chooseFile);

}  // namespace holdfast
