#include "holdfast/window/panels/color_panel.h"

#include <QGroupBox>
#include <QPainter>
#include <QPixmap>
#include <QSignalBlocker>
#include <algorithm>
#include <initializer_list>

#include <holdfast/window/controls/panel_parts.h>
#include <holdfast/window/controls/theme.h>
#include <holdfast/window/text/color_text.h>

namespace holdfast {
namespace {

// In the order of the alternatives of `ColorRange`.
enum RangeKind { OfFixedEnds = 1, OfDecades };

// The number of colours that stands for a map without bands.
constexpr int kSmooth = 1;

// In the place of a map.
constexpr int kOfTheField = -1;

constexpr int kDefaultDecades = 4;
constexpr int kMostDecadesShown = 60;
constexpr QSize kSwatch(64, 12);

QIcon swatchOf(ColorMap map)
{
  QPixmap swatch(kSwatch);
  QPainter painter(&swatch);
  for (int x = 0; x < kSwatch.width(); ++x)
    painter.fillRect(x, 0, 1, kSwatch.height(), toQColor(mapColor((x + 0.5) / kSwatch.width(), map)));
  return swatch;
}

constexpr auto kChosen = qOverload<int>(&QComboBox::currentIndexChanged);

}  // namespace

ColorPanel::ColorPanel(Editor& editor, QWidget* parent) : QWidget(parent), editor_(editor)
{
  setObjectName("colorPanel");
  auto* content = new QWidget;
  auto* column = new QVBoxLayout(content);
  const auto addGroup = [&](const QString& title) {
    auto* group = new QGroupBox(title);
    column->addWidget(group);
    return new QFormLayout(group);
  };
  makeColorRows(*addGroup(tr("Colours")));
  makeDisplayRows(*addGroup(tr("Shown beside the surface")));
  column->addStretch(1);
  fill(*this, newScrollArea(content, tr("Colours and what is shown")));
  connect(&editor_, &Editor::opened, this, &ColorPanel::forgetFixedRanges);
  connect(&editor_, &Editor::opened, this, &ColorPanel::explain);
  connect(&editor_, &Editor::stateChanged, this, &ColorPanel::explain);
  setSettings({});
  setDisplaySettings({});
}

void ColorPanel::makeColorRows(QFormLayout& form)
{
  field_ = named(new QComboBox, "colorField");
  for (std::size_t k = 0; k < colorByNames().size(); ++k) field_->addItem(fieldText(static_cast<ColorBy>(k)).name);
  explanation_ = newText("colorExplanation");
  rangeKind_ = named(new QComboBox, "colorRangeKind");
  rangeKind_->addItems({tr("Automatic"), tr("Fixed"), tr("Logarithmic")});
  static_assert(std::variant_size_v<decltype(ColorSettings::range)> == 3);
  automatic_ = newText("colorAutomaticRange");
  rangeRows_ = new QStackedWidget;
  rangeRows_->addWidget(automatic_);
  rangeRows_->addWidget(makeFixedRange());
  rangeRows_->addWidget(makeLogarithmicRange());
  rangeRows_->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
  refusal_ = newText("colorRefusal");
  map_ = named(new QComboBox, "colorMap");
  map_->setIconSize(kSwatch);
  map_->addItem(tr("As the field needs"), kOfTheField);
  map_->setToolTip(tr("As the field needs: white at 0 where values have both signs"));
  for (const auto& [map, name] : {std::pair(ColorMap::BlueGreenYellow, tr("Blue to green to yellow")),
                                  {ColorMap::BlueGreyYellow, tr("Blue to grey to yellow")},
                                  {ColorMap::BlueWhiteOrange, tr("Blue to white to orange")},
                                  {ColorMap::Grey, tr("Greys")},
                                  {ColorMap::BlueWhiteRed, tr("Blue to white to red")},
                                  {ColorMap::BlackRedYellow, tr("Black to red to yellow")}})
    map_->addItem(swatchOf(map), name, static_cast<int>(map));
  bands_ = named(new QSpinBox, "colorBands", tr("Number of colours"));
  bands_->setRange(kSmooth, kMostBands);
  bands_->setSpecialValueText(tr("Smooth"));
  bands_->setToolTip(tr("As many bands of one colour each, all equally wide"));
  legend_ = named(new QComboBox, "legendSide");
  legend_->addItems({tr("At the right"), tr("At the left"), tr("Hidden")});
  form.addRow(tr("Colour &by"), field_);
  form.addRow(explanation_);
  form.addRow(tr("&Range"), rangeKind_);
  form.addRow(QString(), newLayout<QVBoxLayout>(nullptr, 0, 6, {rangeRows_, refusal_}));
  form.addRow(tr("Colour &map"), map_);
  form.addRow(tr("&Number of colours"), bands_);
  form.addRow(tr("&Legend"), legend_);

  connect(field_, kChosen, this, &ColorPanel::chooseField);
  connect(rangeKind_, kChosen, this, &ColorPanel::chooseRangeKind);
  connect(map_, kChosen, this, [this] {
    const int map = map_->currentData().toInt();
    settings_.map = map == kOfTheField ? std::nullopt : std::optional(static_cast<ColorMap>(map));
    Q_EMIT settingsChanged(settings_);
  });
  connect(bands_, qOverload<int>(&QSpinBox::valueChanged), this, [this](int count) {
    settings_.bands = count == kSmooth ? 0 : count;
    Q_EMIT settingsChanged(settings_);
  });
  connect(legend_, kChosen, this, &ColorPanel::takeDisplay);
}

QWidget* ColorPanel::makeFixedRange()
{
  low_ = named(new NumberEdit, "colorLow", tr("Lowest value of the range"));
  high_ = named(new NumberEdit, "colorHigh", tr("Highest value of the range"));
  auto* row = new QWidget;
  auto* line = newLayout<QHBoxLayout>(row, 0, 6, {low_, new QLabel(tr("to")), high_});
  for (const int edit : {0, 2}) line->setStretch(edit, 1);
  for (NumberEdit* edit : {low_, high_}) {
    connect(edit, &NumberEdit::entered, this, &ColorPanel::takeRange);
    connect(edit, &NumberEdit::refused, this, &ColorPanel::refuse);
    connect(edit, &NumberEdit::righted, this, [this] {
      const QString reason = whyNotTyped();
      // Nothing new is refused while the user types.
      if (reason.isEmpty() || refusal_->isVisible()) refuse(reason);
    });
  }
  return row;
}

QWidget* ColorPanel::makeLogarithmicRange()
{
  decades_ = named(new QSpinBox, "colorDecades", tr("Powers of ten below the largest value"));
  decades_->setRange(1, kMostDecadesShown);
  decades_->setValue(kDefaultDecades);
  decades_->setSuffix(tr(" powers of ten below the largest"));
  connect(decades_, qOverload<int>(&QSpinBox::valueChanged), this, &ColorPanel::takeRange);
  return decades_;
}

void ColorPanel::makeDisplayRows(QFormLayout& form)
{
  rest_ = named(new QComboBox, "restGhost");
  rest_->addItems({tr("Hidden"), tr("Edges"), tr("Translucent surface")});
  edges_ = named(new QComboBox, "meshEdges");
  edges_->addItems({tr("Sharp ones"), tr("All"), tr("None")});
  surface_ = named(new QComboBox, "surfaceDisplay");
  surface_->addItems({tr("Shaded"), tr("Wireframe"), tr("Points")});
  arrows_ = named(new QCheckBox(tr("Rotation &arrows")), "rotationArrows");
  arrows_->setToolTip(tr("Arrows along the axis of rotation; the right hand's fingers rotate as the surface does"));
  constraints_ = named(new QCheckBox(tr("Cons&traints")), "constraintGlyphs");
  share_ = named(new QSlider(Qt::Horizontal), "shownShare", tr("How much of the deformation is shown, percent"));
  share_->setRange(0, 100);
  share_->setValue(100);
  share_->setPageStep(10);
  share_->setToolTip(tr("From the shape at rest to the deformed one (O shows them in turn)"));
  auto* percent = newText("shownShareText");
  percent->setWordWrap(false);
  percent->setMinimumWidth(percent->fontMetrics().horizontalAdvance("100 %"));
  const auto showPercent = [percent](int value) { percent->setText(tr("%1 %").arg(value)); };
  showPercent(share_->value());
  connect(share_, &QSlider::valueChanged, percent, showPercent);
  connect(share_, &QSlider::valueChanged, this, [this](int value) { Q_EMIT shownShareChosen(value / 100.0); });
  auto* shareRow = new QWidget;
  newLayout<QHBoxLayout>(shareRow, 0, 6, {share_, percent})->setStretch(0, 1);
  form.addRow(tr("Sho&w"), shareRow);
  form.addRow(tr("Sha&pe at rest"), rest_);
  form.addRow(tr("Mesh e&dges"), edges_);
  form.addRow(tr("S&urface"), surface_);
  form.addRow(QString(), arrows_);
  form.addRow(QString(), constraints_);
  for (QComboBox* box : {rest_, edges_, surface_}) connect(box, kChosen, this, &ColorPanel::takeDisplay);
  for (QCheckBox* box : {arrows_, constraints_}) connect(box, &QCheckBox::toggled, this, &ColorPanel::takeDisplay);
}

void ColorPanel::takeDisplay()
{
  Q_EMIT displaySettingsChanged({static_cast<RestGhost>(rest_->currentIndex()),
                                 static_cast<MeshEdges>(edges_->currentIndex()),
                                 static_cast<SurfaceDisplay>(surface_->currentIndex()),
                                 arrows_->isChecked() ? RotationDisplay::Arrows : RotationDisplay::Hidden,
                                 constraints_->isChecked(), static_cast<LegendSide>(legend_->currentIndex())});
}

void ColorPanel::setDisplaySettings(const DisplaySettings& settings)
{
  const QSignalBlocker quiet(this);
  rest_->setCurrentIndex(static_cast<int>(settings.rest));
  edges_->setCurrentIndex(static_cast<int>(settings.edges));
  surface_->setCurrentIndex(static_cast<int>(settings.surface));
  arrows_->setChecked(settings.rotations == RotationDisplay::Arrows);
  constraints_->setChecked(settings.areConstraintsShown);
  legend_->setCurrentIndex(static_cast<int>(settings.legend));
}

void ColorPanel::setSettings(const ColorSettings& settings)
{
  const QSignalBlocker quiet(this);
  // What these change by hand depends on what is set below.
  const QSignalBlocker quietField(field_);
  const QSignalBlocker quietKind(rangeKind_);
  const QSignalBlocker quietDecades(decades_);
  field_->setCurrentIndex(static_cast<int>(settings.field));
  rangeKind_->setCurrentIndex(static_cast<int>(settings.range.index()));
  rangeRows_->setCurrentIndex(rangeKind_->currentIndex());
  map_->setCurrentIndex(map_->findData(settings.map ? static_cast<int>(*settings.map) : kOfTheField));
  bands_->setValue(std::max(settings.bands, kSmooth));
  if (const auto* fixed = std::get_if<FixedRange>(&settings.range)) {
    low_->replaceTyped(fixed->low);
    high_->replaceTyped(fixed->high);
  }
  if (const auto* logarithmic = std::get_if<LogarithmicRange>(&settings.range))
    decades_->setValue(logarithmic->decades);
  settings_ = settings;
  refuse({});
  explain();
}

void ColorPanel::explain()
{
  const QString units = editor_.isOpen() ? QString::fromStdString(editor_.list().units) : QString();
  const Weights weights = editor_.isOpen() ? editor_.state().options.weights : Weights::Cotangent;
  explanation_->setText(fieldText(settings_.field, units, weights).meaning);
  for (QWidget* const widget : std::initializer_list<QWidget*>{rangeKind_, rangeRows_, map_, bands_})
    widget->setEnabled(settings_.field != ColorBy::None);
}

void ColorPanel::setShownScale(const std::optional<ColorScale>& scale)
{
  shownScale_ = scale;
  const QString range = tr("%1 to %2");
  automatic_->setText(scale ? range.arg(roundedText(scale->low), roundedText(scale->high)) : QString());
  automatic_->setToolTip(scale ? range.arg(exactText(scale->low), exactText(scale->high)) : QString());
}

/// Numbers of a range are those of one field, in its unit.
void ColorPanel::chooseField(int field)
{
  ColorSettings settings = settings_;
  if (const auto* fixed = std::get_if<FixedRange>(&settings_.range)) {
    fixedRanges_[settings_.field] = *fixed;
    settings.range = AutomaticRange{};
  }
  settings.field = static_cast<ColorBy>(field);
  if (const auto kept = fixedRanges_.find(settings.field); kept != fixedRanges_.end()) settings.range = kept->second;
  setSettings(settings);
  Q_EMIT settingsChanged(settings_);
}

/// They are of the document before.
void ColorPanel::forgetFixedRanges()
{
  fixedRanges_.clear();
  if (!std::holds_alternative<FixedRange>(settings_.range)) return;
  ColorSettings settings = settings_;
  settings.range = AutomaticRange{};
  setSettings(settings);
  Q_EMIT settingsChanged(settings_);
}

void ColorPanel::chooseRangeKind(int kind)
{
  rangeRows_->setCurrentIndex(kind);
  if (kind == OfFixedEnds) {
    // The colours stay as they are until other ends are typed.
    const FixedRange begin = shownScale_ ? FixedRange{shownScale_->low, shownScale_->high} : FixedRange{};
    low_->replaceTyped(begin.low);
    high_->replaceTyped(begin.high);
  }
  takeRange();
}

std::optional<ColorRange> ColorPanel::typedRange() const
{
  if (rangeKind_->currentIndex() == OfDecades) return LogarithmicRange{decades_->value()};
  if (rangeKind_->currentIndex() != OfFixedEnds) return AutomaticRange{};
  if (!low_->typed() || !high_->typed()) return std::nullopt;
  return FixedRange{*low_->typed(), *high_->typed()};
}

/// Nothing as long as a number is missing: the line says that itself.
QString ColorPanel::whyNotTyped() const
{
  const std::optional<ColorRange> range = typedRange();
  const QString reason = range ? QString::fromStdString(whyNoRange(*range)) : QString();
  return reason.isEmpty() ? reason : reason + '.';
}

void ColorPanel::takeRange()
{
  const std::optional<ColorRange> range = typedRange();
  if (!range) return;
  const QString reason = whyNotTyped();
  refuse(reason);
  if (!reason.isEmpty()) return;
  if (!std::holds_alternative<FixedRange>(*range)) fixedRanges_.erase(settings_.field);
  settings_.range = *range;
  Q_EMIT settingsChanged(settings_);
}

void ColorPanel::refuse(const QString& reason)
{
  refusal_->setText(reason);
  refusal_->setVisible(!reason.isEmpty());
}

}  // namespace holdfast
