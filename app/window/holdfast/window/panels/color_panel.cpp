#include "holdfast/window/panels/color_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPixmap>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QStackedWidget>
#include <QVBoxLayout>

#include <holdfast/window/controls/number_edit.h>
#include <holdfast/window/controls/panel_parts.h>
#include <holdfast/window/controls/vtk_palette.h>
#include <holdfast/window/text/color_text.h>
#include <holdfast/window/text/number_text.h>

namespace holdfast {
namespace {

// In the order of the alternatives of `ColorRange`.
enum RangeKind { kAutomatic, kFixed, kDecades };

constexpr int kDefaultDecades = 4;
constexpr int kMostDecadesShown = 60;
constexpr int kFieldDigits = 4;
constexpr QSize kSwatch(64, 12);

QIcon swatchOf(ColorMap map)
{
  QPixmap swatch(kSwatch);
  QPainter painter(&swatch);
  for (int x = 0; x < kSwatch.width(); ++x)
    painter.fillRect(x, 0, 1, kSwatch.height(), toQColor(mapColor((x + 0.5) / kSwatch.width(), map)));
  return swatch;
}

QComboBox* newChoice(const QString& name, const QStringList& entries)
{
  auto* box = named(new QComboBox, name);
  box->addItems(entries);
  return box;
}

constexpr auto kChosen = qOverload<int>(&QComboBox::currentIndexChanged);

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
  fill(*this, newScrollArea(content, tr("Colours and what is shown")));
  connect(&editor_, &Editor::opened, this, &ColorPanel::explain);
  connect(&editor_, &Editor::stateChanged, this, &ColorPanel::explain);
  showSettings();
  setDisplaySettings(display_);
}

void ColorPanel::makeColorRows(QFormLayout& form)
{
  field_ = named(new QComboBox, "colorField");
  for (std::size_t k = 0; k < colorByNames().size(); ++k)
    field_->addItem(fieldText(static_cast<ColorBy>(k)).name, static_cast<int>(k));
  explanation_ = newText("colorExplanation");
  rangeKind_ = newChoice("colorRangeKind", {tr("Automatic"), tr("Fixed"), tr("Logarithmic")});
  automatic_ = newText("colorAutomaticRange");
  rangeRows_ = new QStackedWidget;
  rangeRows_->addWidget(automatic_);
  rangeRows_->addWidget(makeFixedRange());
  rangeRows_->addWidget(makeLogarithmicRange());
  rangeRows_->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
  refusal_ = newText("colorRefusal");
  map_ = named(new QComboBox, "colorMap");
  map_->setIconSize(kSwatch);
  for (const auto& [map, name] : {std::pair(ColorMap::BlueGreenYellow, tr("Blue to green to yellow")),
                                  {ColorMap::BlueGreyYellow, tr("Blue to grey to yellow")},
                                  {ColorMap::BlueWhiteOrange, tr("Blue to white to orange")},
                                  {ColorMap::Grey, tr("Greys")}})
    map_->addItem(swatchOf(map), name, static_cast<int>(map));
  form.addRow(tr("Colour &by"), field_);
  form.addRow(QString(), explanation_);
  form.addRow(tr("&Range"), rangeKind_);
  form.addRow(QString(), rangeRows_);
  form.addRow(QString(), refusal_);
  form.addRow(tr("Colour &map"), map_);

  connect(field_, kChosen, this, [this](int index) {
    settings_.field = static_cast<ColorBy>(index);
    explain();
    Q_EMIT settingsChanged(settings_);
  });
  connect(rangeKind_, kChosen, this, &ColorPanel::chooseRangeKind);
  connect(map_, kChosen, this, [this](int index) {
    settings_.map = static_cast<ColorMap>(map_->itemData(index).toInt());
    Q_EMIT settingsChanged(settings_);
  });
}

QWidget* ColorPanel::makeFixedRange()
{
  low_ = named(new NumberEdit, "colorLow", tr("Lowest value of the range"));
  high_ = named(new NumberEdit, "colorHigh", tr("Highest value of the range"));
  auto* row = new QWidget;
  auto* line = new QHBoxLayout(row);
  line->setContentsMargins(0, 0, 0, 0);
  line->addWidget(low_, 1);
  line->addWidget(new QLabel(tr("to")));
  line->addWidget(high_, 1);
  for (NumberEdit* edit : {low_, high_}) {
    connect(edit, &NumberEdit::entered, this, &ColorPanel::takeFixedRange);
    connect(edit, &NumberEdit::refused, this, &ColorPanel::refuse);
  }
  return row;
}

QWidget* ColorPanel::makeLogarithmicRange()
{
  decades_ = named(new QSpinBox, "colorDecades", tr("Powers of ten below the largest value"));
  decades_->setRange(1, kMostDecadesShown);
  decades_->setValue(kDefaultDecades);
  decades_->setSuffix(tr(" powers of ten below the largest"));
  connect(decades_, qOverload<int>(&QSpinBox::valueChanged), this,
          [this](int decades) { changeRange(LogarithmicRange{decades}); });
  return decades_;
}

void ColorPanel::makeDisplayRows(QFormLayout& form)
{
  rest_ = newChoice("restGhost", {tr("Hidden"), tr("Edges"), tr("Translucent surface")});
  edges_ = newChoice("meshEdges", {tr("Sharp ones"), tr("All")});
  arrows_ = named(new QCheckBox(tr("Rotation &arrows")), "rotationArrows");
  arrows_->setToolTip(tr("Arrows along the axis of rotation; the right hand's fingers turn as the surface does"));
  constraints_ = named(new QCheckBox(tr("&Constraints")), "constraintGlyphs");
  form.addRow(tr("Shape at r&est"), rest_);
  form.addRow(tr("Mesh e&dges"), edges_);
  form.addRow(QString(), arrows_);
  form.addRow(QString(), constraints_);
  connect(rest_, kChosen, this, &ColorPanel::takeDisplay);
  connect(edges_, kChosen, this, &ColorPanel::takeDisplay);
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
    low_->replaceTyped(fixed->low);
    high_->replaceTyped(fixed->high);
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
  automatic_->setToolTip(scale ? tr("%1 to %2").arg(exactText(scale->low), exactText(scale->high)) : QString());
}

void ColorPanel::chooseRangeKind(int kind)
{
  rangeRows_->setCurrentIndex(kind);
  if (kind == kAutomatic) changeRange(AutomaticRange{});
  if (kind == kDecades) changeRange(LogarithmicRange{decades_->value()});
  if (kind != kFixed) return;
  // The colours stay as they are until other ends are typed.
  const FixedRange begin = shownScale_ ? FixedRange{shownScale_->low, shownScale_->high} : FixedRange{};
  low_->replaceTyped(begin.low);
  high_->replaceTyped(begin.high);
  changeRange(begin);
}

void ColorPanel::takeFixedRange()
{
  if (low_->typed() && high_->typed()) changeRange(FixedRange{*low_->typed(), *high_->typed()});
}

void ColorPanel::changeRange(const ColorRange& range)
{
  const QString reason = QString::fromStdString(whyNoRange(range));
  refuse(reason.isEmpty() ? reason : reason + '.');
  if (!reason.isEmpty()) return;
  settings_.range = range;
  Q_EMIT settingsChanged(settings_);
}

void ColorPanel::refuse(const QString& reason)
{
  refusal_->setText(reason);
  refusal_->setVisible(!reason.isEmpty());
}

}  // namespace holdfast
