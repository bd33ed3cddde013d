#pragma once
/// Keeps unsaved work against a crash, and offers what a crash has left.

#include <QDialog>
#include <QTimer>
#include <QWidget>
#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <vector>

#include <holdfast/document/recovery.h>
#include <holdfast/window/files/document_files.h>
#include <holdfast/window/model/background_job.h>
#include <holdfast/window/model/editor.h>

namespace holdfast {

inline constexpr std::chrono::milliseconds kAutosaveDelay = std::chrono::seconds(2);

/// Writes a copy of the editor's document on a thread of its own. It writes a moment after a change, never in the
/// middle of a gesture. It removes the copy when the document is saved or replaced, and when it is destroyed itself.
class Autosave : public QObject {
  Q_OBJECT

 public:
  Autosave(Editor& editor, DocumentFiles& files, std::filesystem::path folder, QWidget* window);

  void setDelay(std::chrono::milliseconds delay) { delay_.setInterval(delay); }

  /// Shows what crashed programs have left, if anything, without blocking.
  void offerRecovery();
  /// Opens the copy as a document. It is removed as soon as this document has a copy of its own.
  void recover(const Recoverable& copy);

 Q_SIGNALS:
  /// A copy of the state that is shown is on the disk.
  void kept();
  /// No copy can be kept. The signal comes once until one can. `reason` says why and what to do.
  void failed(const QString& reason);

 private:
  void changed();
  void writeNow();
  void written(const std::shared_ptr<const DocumentState>& state);
  void removeCopy();
  void discardRecovered();
  void showFailure(const std::exception_ptr& error);

  Editor& editor_;
  DocumentFiles& files_;
  QWidget* window_;
  std::filesystem::path folder_;
  std::shared_ptr<RecoveryFile> copy_;         // shared with the thread that writes
  std::shared_ptr<const DocumentState> kept_;  // the state that the copy holds; null without one
  std::vector<Recoverable> recovered_;         // to be discarded once there is a copy
  bool isObsolete_ = false;                    // what is being written is not to stay
  bool hasFailed_ = false;
  QTimer delay_;
  BackgroundJob job_;  // last: its thread uses what is above
};

/// Makes a dialog with one entry for each copy. `recover` gets the copy that the user wants opened. The others are left
/// for later.
[[nodiscard]] QDialog* newRecoveryDialog(std::vector<Recoverable> copies,
                                         std::function<void(const Recoverable&)> recover, QWidget* parent = nullptr);

}  // namespace holdfast
