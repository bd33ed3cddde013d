#pragma once
/// \file
/// The inspector on a flat sheet under constraints of every kind, and what a user does with it.

#include <QComboBox>
#include <QLineEdit>
#include <string>

#include <gtest/gtest.h>

#include <holdfast/window/inspector/inspector_section.h>

#include "gestures.h"

namespace holdfast::test {

/// Constraints of `InspectedSheet`, places in its list.
enum Inspected : Index { kBase, kAtVertex, kAtEdge, kInFace, kTip, kPair };

class InspectedSheet : public ::testing::Test {
 protected:
  void SetUp() override;

  [[nodiscard]] static ConstraintList inspectedList();

  template <class Widget = QLineEdit>
  [[nodiscard]] Widget& find(const char* name)
  {
    return *panel.findChild<Widget*>(name);
  }
  /// In the place of what the line says, and Enter.
  void typeInto(const char* name, const char* text);
  /// Opens the list, and Enter on an entry.
  void choose(const char* name, int entry);
  void press(const char* button);

  template <class What>
  [[nodiscard]] const What& what(Index k) const
  {
    return std::get<What>(editor.list().constraints[k].what);
  }
  /// What the panel says against the latest edit; empty where it says nothing.
  [[nodiscard]] std::string refusal();

  /// Undoes the latest edit, which must be the only one since `before`, and does it again.
  void expectOneEntry(const std::shared_ptr<const DocumentState>& before, const char* name);
  /// The session as a file, read again, has the same list bit for bit.
  void expectKeptInSession();

  Editor editor;
  std::unique_ptr<QWidget> inspector{newInspectorPanel(editor)};
  QWidget& panel = *inspector;
};

}  // namespace holdfast::test
