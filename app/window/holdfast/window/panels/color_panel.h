#pragma once
/// A panel in which a user chooses colours, and what is shown beside the surface.

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QSlider>
#include <QSpinBox>
#include <QStackedWidget>
#include <QWidget>
#include <cmath>
#include <map>
#include <optional>

#include <holdfast/widgets/scene/scene_contents.h>
#include <holdfast/window/controls/number_edit.h>
#include <holdfast/window/model/editor.h>

namespace holdfast {

/// The panel's controls show the settings. The panel refuses an invalid range with the reason, and the settings stay as
/// they were.
class ColorPanel : public QWidget {
  Q_OBJECT

 public:
  explicit ColorPanel(Editor& editor, QWidget* parent = nullptr);

  [[nodiscard]] const ColorSettings& settings() const noexcept { return settings_; }

  /// Gives the choice of the range of the colours the keyboard focus.
  void focusRange() { rangeKind_->setFocus(Qt::OtherFocusReason); }

 public Q_SLOTS:
  void setSettings(const ColorSettings& settings);
  void setDisplaySettings(const DisplaySettings& settings);
  /// Shows how much of the deformation the picture shows, from 0 to 1.
  void setShownShare(double share) { share_->setValue(static_cast<int>(std::lround(100 * share))); }
  /// Sets the scale of the picture; none if the picture has one colour. An automatic range shows this scale. A fixed
  /// range starts from it.
  void setShownScale(const std::optional<ColorScale>& scale);

 Q_SIGNALS:
  void settingsChanged(const ColorSettings& settings);
  void displaySettingsChanged(const DisplaySettings& settings);
  void shownShareChosen(double share);

 private:
  void makeColorRows(QFormLayout& form);
  void makeDisplayRows(QFormLayout& form);
  [[nodiscard]] QWidget* makeFixedRange();
  [[nodiscard]] QWidget* makeLogarithmicRange();
  void explain();
  void chooseField(int field);
  void forgetFixedRanges();
  void chooseRangeKind(int kind);
  [[nodiscard]] std::optional<ColorRange> typedRange() const;
  [[nodiscard]] QString whyNotTyped() const;
  void takeRange();
  void takeDisplay();
  void refuse(const QString& reason);

  Editor& editor_;
  ColorSettings settings_;
  std::optional<ColorScale> shownScale_;
  std::map<ColorBy, FixedRange> fixedRanges_;  // of fields that were shown before
  QComboBox* field_ = nullptr;
  QLabel* explanation_ = nullptr;
  QComboBox* rangeKind_ = nullptr;
  QStackedWidget* rangeRows_ = nullptr;
  QLabel* automatic_ = nullptr;
  NumberEdit* low_ = nullptr;
  NumberEdit* high_ = nullptr;
  QSpinBox* decades_ = nullptr;
  QLabel* refusal_ = nullptr;
  QComboBox* map_ = nullptr;
  QSpinBox* bands_ = nullptr;
  QComboBox* legend_ = nullptr;
  QComboBox* rest_ = nullptr;
  QComboBox* edges_ = nullptr;
  QSlider* share_ = nullptr;
  QComboBox* surface_ = nullptr;
  QCheckBox* arrows_ = nullptr;
  QCheckBox* constraints_ = nullptr;
};

}  // namespace holdfast
