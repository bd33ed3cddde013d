#pragma once
/// \file
/// The window on its stage: what a user does in it, waiting for what comes of it, and pictures.

#include <QPointF>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "window/driven_window.h"

class QAbstractItemView;

namespace holdfast::tour {

/// Fails the tour where `holds` is false; `what` is what should be.
void require(bool holds, const std::string& what);

/// How many there are in a folder, which need not exist.
[[nodiscard]] int picturesIn(const std::filesystem::path& folder);

/// Every function ends when what it does is done and drawn, and fails the tour where that does not come.
class TourWindow : public test::DrivenWindow {
 public:
  /// Makes the folder, and counts pictures from the one after `picturesBefore`.
  TourWindow(std::filesystem::path folder, int picturesBefore);

  /// Written as 07_NAME.png, and its path to the standard output.
  void picture(const std::string& name);
  void pictureOf(QWidget& widget, const std::string& name);

  void open(const std::string& mesh, const std::string& constraints = "");
  /// A session of data/, as File > Open does it.
  void openSession(const std::string& session);
  void resize(int width, int height);
  void settle();

  void trigger(const char* action);
  /// With a tool, those nearest to some places.
  void clickVertices(const char* tool, const std::vector<Vector3>& places);
  /// Triggers an action that asks something, and hands the dialog to `see` before it is closed.
  void ask(const char* action, const std::function<void(QWidget&)>& see);
  /// Brings a panel to the front of its stack.
  void raise(const char* dock);
  void choose(const char* comboBox, int index);
  void check(const char* checkBox, Qt::CheckState state);
  /// In place of what is there, and Enter.
  void enter(const char* line, const char* text);
  void enterCell(QAbstractItemView& table, int row, int column, const char* text);
  void select(const std::string& constraint);

  /// In the viewport's coordinates.
  [[nodiscard]] QPointF shownVertex(Index vertex);
  [[nodiscard]] QPointF shownMark(const std::string& constraint);
  [[nodiscard]] QPointF onArrow(int axis);

 private:
  std::filesystem::path folder_;
  int count_;
};

}  // namespace holdfast::tour
