#include "holdfast/window/panels/color_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPainter>
#include <QPixmap>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QStackedWidget>
#include <QVBoxLayout>

#include <holdfast/io/text/number_text.h>
#include <holdfast/window/controls/labels.h>
#include <holdfast/window/text/color_text.h>

namespace holdfast {
namespace {

// In the order of the alternatives of `ColorRange`.
enum RangeKind { kAutomatic, kFixed, kDecades };

constexpr int kDefaultDecades = 4;
constexpr int kMostDecadesShown = 60;
constexpr int kFieldDigits = 4;
constexpr QSize kSwatch(64, 12);

QString exact(double value)
{
  const NumberText text(value);
  return QString::fromLatin1(text.view().data(), static_cast<int>(text.view().size()));
}

std::optional<double> typed(const QLineEdit& edit)
{
  const auto number = parseDouble(edit.text().trimmed().toStdString());
  if (number.fault != NumberFault::None) return std::nullopt;
  return number.value;
}

/// From its first digit on, where the field is too narrow for all.
void showNumber(QLineEdit& edit, double value)
{
  edit.setText(exact(value));
  edit.setCursorPosition(0);
  edit.setToolTip(edit.text());
}

QIcon swatchOf(ColorMap map)
{
  QPixmap swatch(kSwatch);
  QPainter painter(&swatch);
  for (int x = 0; x < kSwatch.width(); ++x) {
    const Color color = mapColor((x + 0.5) / kSwatch.width(), map);
    painter.fillRect(x, 0, 1, kSwatch.height(), QColor::fromRgbF(color.red, color.green, color.blue));
  }
  return swatch;
}

QLineEdit* makeNumber(const QString& name, const QString& accessibleName)
{
  auto* edit = new QLineEdit;
  edit->setObjectName(name);
  edit->setAccessibleName(accessibleName);
  return edit;
}

}  // namespace

ColorPanel::ColorPanel(Editor& editor, QWidget* parent) : QWidget(parent), editor_(editor)
{
  setObjectName("colorPanel");
  auto* colors = new QGroupBox(tr("Colours"));
  auto* colorForm = new QFormLayout(colors);
  makeColorRows(*colorForm);
  auto* display = new QGroupBox(tr("Shown beside the surface"));
  auto* displayForm = new QFormLayout(display);
  makeDisplayRows(*displayForm);
  auto* content = new QWidget;
  auto* column = new QVBoxLayout(content);
  column->addWidget(colors);
  column->addWidget(display);
  column->addStretch(1);
  auto* area = new QScrollArea;
  area->setAccessibleName(tr("Colours and what is shown"));
  area->setWidget(content);
  area->setWidgetResizable(true);
  area->setFrameShape(QFrame::NoFrame);
  auto* outer = new QVBoxLayout(this);
  outer->setContentsMargins(0, 0, 0, 0);
  outer->addWidget(area);
  connect(&editor_, &Editor::opened, this, &ColorPanel::explain);
  connect(&editor_, &Editor::stateChanged, this, &ColorPanel::explain);
  showSettings();
  setDisplaySettings(display_);
}

void ColorPanel::makeColorRows(QFormLayout& form)
{
  field_ = new QComboBox;
  field_->setObjectName("colorField");
  for (std::size_t k = 0; k < colorByNames().size(); ++k)
    field_->addItem(fieldText(static_cast<ColorBy>(k)).name, static_cast<int>(k));
  explanation_ = newText("colorExplanation");
  rangeKind_ = new QComboBox;
  rangeKind_->setObjectName("colorRangeKind");
  rangeKind_->addItems({tr("Automatic"), tr("Fixed"), tr("Logarithmic")});
  automatic_ = newText("colorAutomaticRange");
  rangeRows_ = new QStackedWidget;
  rangeRows_->addWidget(automatic_);
  rangeRows_->addWidget(makeFixedRange());
  rangeRows_->addWidget(makeLogarithmicRange());
  rangeRows_->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
  refusal_ = newText("colorRefusal");
  map_ = new QComboBox;
  map_->setObjectName("colorMap");
  map_->setIconSize(kSwatch);
  addMaps();
  form.addRow(tr("Colour &by"), field_);
  form.addRow(QString(), explanation_);
  form.addRow(tr("&Range"), rangeKind_);
  form.addRow(QString(), rangeRows_);
  form.addRow(QString(), refusal_);
  form.addRow(tr("Colour &map"), map_);

  const auto chosen = QOverload<int>::of(&QComboBox::currentIndexChanged);
  connect(field_, chosen, this, [this](int index) {
    settings_.field = static_cast<ColorBy>(index);
    explain();
    Q_EMIT settingsChanged(settings_);
  });
  connect(rangeKind_, chosen, this, &ColorPanel::chooseRangeKind);
  connect(map_, chosen, this, [this](int index) {
    settings_.map = static_cast<ColorMap>(map_->itemData(index).toInt());
    Q_EMIT settingsChanged(settings_);
  });
}

void ColorPanel::addMaps()
{
  const auto add = [this](ColorMap map, const QString& name) {
    map_->addItem(swatchOf(map), name, static_cast<int>(map));
  };
  add(ColorMap::BlueGreenYellow, tr("Blue to green to yellow"));
  add(ColorMap::BlueGreyYellow, tr("Blue to grey to yellow"));
  add(ColorMap::BlueWhiteOrange, tr("Blue to white to orange"));
  add(ColorMap::Grey, tr("Greys"));
}

QWidget* ColorPanel::makeFixedRange()
{
  low_ = makeNumber("colorLow", tr("Lowest value of the range"));
  high_ = makeNumber("colorHigh", tr("Highest value of the range"));
  auto* row = new QWidget;
  auto* line = new QHBoxLayout(row);
  line->setContentsMargins(0, 0, 0, 0);
  line->addWidget(low_, 1);
  line->addWidget(new QLabel(tr("to")));
  line->addWidget(high_, 1);
  connect(low_, &QLineEdit::editingFinished, this, &ColorPanel::takeFixedRange);
  connect(high_, &QLineEdit::editingFinished, this, &ColorPanel::takeFixedRange);
  return row;
}

QWidget* ColorPanel::makeLogarithmicRange()
{
  decades_ = new QSpinBox;
  decades_->setObjectName("colorDecades");
  decades_->setAccessibleName(tr("Powers of ten below the largest value"));
  decades_->setRange(1, kMostDecadesShown);
  decades_->setValue(kDefaultDecades);
  decades_->setSuffix(tr(" powers of ten below the largest"));
  connect(decades_, QOverload<int>::of(&QSpinBox::valueChanged), this,
          [this](int decades) { changeRange(LogarithmicRange{decades}); });
  return decades_;
}

void ColorPanel::makeDisplayRows(QFormLayout& form)
{
  rest_ = new QComboBox;
  rest_->setObjectName("restGhost");
  rest_->addItems({tr("Hidden"), tr("Edges"), tr("Translucent surface")});
  edges_ = new QComboBox;
  edges_->setObjectName("meshEdges");
  edges_->addItems({tr("Sharp ones"), tr("All")});
  arrows_ = new QCheckBox(tr("Rotation &arrows"));
  arrows_->setObjectName("rotationArrows");
  arrows_->setToolTip(tr("Arrows along the axis of rotation; the right hand's fingers turn as the surface does"));
  constraints_ = new QCheckBox(tr("&Constraints"));
  constraints_->setObjectName("constraintGlyphs");
  form.addRow(tr("Shape at r&est"), rest_);
  form.addRow(tr("Mesh e&dges"), edges_);
  form.addRow(QString(), arrows_);
  form.addRow(QString(), constraints_);
  const auto chosen = QOverload<int>::of(&QComboBox::currentIndexChanged);
  connect(rest_, chosen, this, &ColorPanel::takeDisplay);
  connect(edges_, chosen, this, &ColorPanel::takeDisplay);
  connect(arrows_, &QCheckBox::toggled, this, &ColorPanel::takeDisplay);
  connect(constraints_, &QCheckBox::toggled, this, &ColorPanel::takeDisplay);
}

void ColorPanel::takeDisplay()
{
  display_.rest = static_cast<RestGhost>(rest_->currentIndex());
  display_.edges = static_cast<MeshEdges>(edges_->currentIndex());
  display_.rotations = arrows_->isChecked() ? RotationDisplay::Arrows : RotationDisplay::Hidden;
  display_.areConstraintsShown = constraints_->isChecked();
  Q_EMIT displaySettingsChanged(display_);
}

void ColorPanel::setDisplaySettings(const DisplaySettings& settings)
{
  display_ = settings;
  const QSignalBlocker rest(rest_);
  const QSignalBlocker edges(edges_);
  const QSignalBlocker arrows(arrows_);
  const QSignalBlocker constraints(constraints_);
  rest_->setCurrentIndex(static_cast<int>(settings.rest));
  edges_->setCurrentIndex(static_cast<int>(settings.edges));
  arrows_->setChecked(settings.rotations == RotationDisplay::Arrows);
  constraints_->setChecked(settings.areConstraintsShown);
}

void ColorPanel::setSettings(const ColorSettings& settings)
{
  settings_ = settings;
  showSettings();
}

void ColorPanel::showSettings()
{
  const QSignalBlocker field(field_);
  const QSignalBlocker kind(rangeKind_);
  const QSignalBlocker map(map_);
  const QSignalBlocker decades(decades_);
  field_->setCurrentIndex(static_cast<int>(settings_.field));
  rangeKind_->setCurrentIndex(static_cast<int>(settings_.range.index()));
  rangeRows_->setCurrentIndex(static_cast<int>(settings_.range.index()));
  map_->setCurrentIndex(map_->findData(static_cast<int>(settings_.map)));
  if (const auto* fixed = std::get_if<FixedRange>(&settings_.range)) {
    showNumber(*low_, fixed->low);
    showNumber(*high_, fixed->high);
  }
  if (const auto* logarithmic = std::get_if<LogarithmicRange>(&settings_.range))
    decades_->setValue(logarithmic->decades);
  refuse({});
  explain();
}

void ColorPanel::explain()
{
  const FieldText words = fieldText(settings_.field);
  const QString units = editor_.isOpen() ? QString::fromStdString(editor_.list().units) : QString();
  const Weights weights = editor_.isOpen() ? editor_.state().options.weights : Weights::Cotangent;
  explanation_->setText(words.meaning + ' ' + unitSentence(settings_.field, units, weights));
  const bool isColored = settings_.field != ColorBy::None;
  for (QWidget* const widget :
       {static_cast<QWidget*>(rangeKind_), static_cast<QWidget*>(rangeRows_), static_cast<QWidget*>(map_)})
    widget->setEnabled(isColored);
}

void ColorPanel::setShownScale(const std::optional<ColorScale>& scale)
{
  shownScale_ = scale;
  automatic_->setText(
      scale ? tr("%1 to %2")
                  .arg(QString::number(scale->low, 'g', kFieldDigits), QString::number(scale->high, 'g', kFieldDigits))
            : QString());
  automatic_->setToolTip(scale ? tr("%1 to %2").arg(exact(scale->low), exact(scale->high)) : QString());
}

void ColorPanel::chooseRangeKind(int kind)
{
  rangeRows_->setCurrentIndex(kind);
  if (kind == kAutomatic) changeRange(AutomaticRange{});
  if (kind == kDecades) changeRange(LogarithmicRange{decades_->value()});
  if (kind != kFixed) return;
  // What is on screen stays as it is until other ends are typed.
  const FixedRange begin = shownScale_ ? FixedRange{shownScale_->low, shownScale_->high} : FixedRange{};
  showNumber(*low_, begin.low);
  showNumber(*high_, begin.high);
  changeRange(begin);
}

void ColorPanel::takeFixedRange()
{
  // Leaving a field that was not edited finishes editing too.
  if (!low_->isModified() && !high_->isModified()) return;
  for (const QLineEdit* const edit : {low_, high_})
    if (!typed(*edit)) return refuse(tr("\"%1\" is no number; write one such as 0.25 or 1e-6.").arg(edit->text()));
  changeRange(FixedRange{*typed(*low_), *typed(*high_)});
}

void ColorPanel::changeRange(const ColorRange& range)
{
  const QString reason = QString::fromStdString(whyNoRange(range));
  refuse(reason.isEmpty() ? reason : reason + '.');
  if (!reason.isEmpty()) return;
  low_->setModified(false);
  high_->setModified(false);
  settings_.range = range;
  Q_EMIT settingsChanged(settings_);
}

void ColorPanel::refuse(const QString& reason)
{
  refusal_->setText(reason);
  refusal_->setVisible(!reason.isEmpty());
}

}  // namespace holdfast
