#pragma once
/// \file
/// Selects constraints by their glyphs.

#include <optional>

#include <holdfast/widgets/editor.h>
#include <holdfast/widgets/tool.h>

namespace holdfast {

class Viewport;

/// A click on a glyph selects its constraint, with Shift or Ctrl besides those that are selected; a click beside all
/// selects none.
class SelectTool : public Tool {
  Q_OBJECT

 public:
  SelectTool(Editor& editor, Viewport& viewport, QObject* parent);

  [[nodiscard]] QString hint() const override;
  bool hover(const Pointer& pointer) override;
  void click(const Pointer& pointer) override;

 private:
  [[nodiscard]] std::optional<Index> constraintAt(const Pointer& pointer) const;

  Editor& editor_;
  Viewport& viewport_;
};

}  // namespace holdfast
