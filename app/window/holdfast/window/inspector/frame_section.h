#pragma once
/// \file
/// The inspector of handles that go from one frame in space to another.

#include <functional>

#include <holdfast/window/inspector/inspector_section.h>

namespace holdfast {

/// Both frames, and the whole turns between them. Numbers of the frames stay in the lines until they make frames.
class FrameSection : public InspectorSection {
  Q_OBJECT

 public:
  FrameSection(Editor& editor, QWidget* parent = nullptr);
  [[nodiscard]] bool fits(const Constraint& constraint) const override;

 protected:
  void refresh() override;

 private:
  /// One frame in lines.
  struct Lines {
    Frame FrameMotion::*frame;
    QComboBox* choice = nullptr;
    VectorEdit* origin = nullptr;
    VectorEdit* x = nullptr;
    VectorEdit* y = nullptr;
  };

  [[nodiscard]] Lines addFrame(Frame FrameMotion::*frame, const QString& title, const QString& name,
                               const QStringList& origins);
  void showFrame(const Lines& lines);
  void chooseOrigin(const Lines& lines, int choice);
  void takeFrames();
  void setTurns(double turns);
  /// What the motion of a handle becomes; nothing where it stays as it is.
  using MotionChange = std::function<std::optional<FrameMotion>(FrameMotion, const Constraint&)>;
  void changeFrames(const QString& name, const MotionChange& change);

  Lines from_;
  Lines to_;
  NumberEdit* turns_ = nullptr;
};

}  // namespace holdfast
