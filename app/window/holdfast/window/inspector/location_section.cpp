#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include <holdfast/base/error.h>
#include <holdfast/constraint_files/constraint_file.h>
#include <holdfast/surface/surface_locator.h>
#include <holdfast/window/controls/panel_parts.h>
#include <holdfast/window/inspector/sections.h>
#include <holdfast/window/model/at_rest.h>
#include <holdfast/window/text/number_text.h>

namespace holdfast {
namespace {

constexpr int kWeightsInLine = 3;
// Ids above this are no longer exact as doubles; no mesh has so many vertices.
constexpr double kLargestId = 9e15;

Index idOf(double typed)
{
  if (typed < 0 || typed > kLargestId || typed != std::floor(typed))
    throw InputError({}, exactText(typed).toStdString() + " is no id; ids are whole numbers and count from 0");
  return static_cast<Index>(typed);
}

void requireWeights(const std::vector<double>& weights)
{
  if (std::any_of(weights.begin(), weights.end(), [](double weight) { return weight < 0; }))
    throw InputError({}, "a weight is negative, so the point would lie outside the face; make it 0 or more");
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  if (!(std::abs(sum - 1) <= kWeightSumTolerance))
    throw InputError({}, "the weights sum to " + exactText(sum).toStdString() +
                             ", not to 1; change the others too, or press Normalize");
}

class LocationSection : public SectionOf<PointConstraint> {
 public:
  explicit LocationSection(Editor& editor) : SectionOf(editor)
  {
    kind_ = addChoice(tr("&Lies on"), "locationKind", tr("What the point lies on"),
                      {tr("a vertex"), tr("an edge"), tr("a face"), tr("the surface, closest to a place")},
                      [this](int kind) { chooseKind(kind); });
    explain(kind_, tr("Another kind keeps the point as near as it can be"));
    first_ = addNumber(tr("&Vertex"), "locationFirst");
    second_ = addNumber(tr("and vertex"), "locationSecond");
    t_ = addNumber(tr("&t"), "locationT");
    explain(t_, tr("The share of the first vertex: 1 there, 0 at the second"));
    near_ = addVector(tr("&Near"), "locationNear");

    weights_ = new QWidget(this);
    weights_->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    weightLines_ = new QGridLayout(weights_);
    weightLines_->setContentsMargins(0, 0, 0, 0);
    weightLines_->setSpacing(4);
    sum_ = named(new QLabel(weights_), "locationSum");
    normalize_ = named(new QPushButton(tr("N&ormalize"), weights_), "locationNormalize");
    normalize_->setToolTip(tr("Divides all weights by their sum"));
    addRow(tr("Weights"), weights_);
    rest_ = addText(tr("At rest"), "locationRest");

    connect(first_, &NumberEdit::entered, this, &LocationSection::setId);
    connect(second_, &NumberEdit::entered, this, &LocationSection::takeEnds);
    connect(t_, &NumberEdit::entered, this, &LocationSection::setT);
    connect(near_, &VectorEdit::entered, this, &LocationSection::setPlace);
    connect(normalize_, &QPushButton::clicked, this, &LocationSection::normalize);
  }

 private:
  void refresh() override
  {
    setVisible(rows().size() == 1);
    if (rows().size() != 1) return;
    kind_->setCurrentIndex(static_cast<int>(kindOf(location())));
    if (isNews()) showFields();
  }

  const SurfaceLocation& location() const { return what().at; }

  void showFields()
  {
    const SurfaceLocation& at = location();
    const AtVertex* vertex = std::get_if<AtVertex>(&at);
    const AtEdge* edge = std::get_if<AtEdge>(&at);
    const AtFace* face = std::get_if<AtFace>(&at);
    const AtNear* near = std::get_if<AtNear>(&at);
    setFieldVisible(first_, near == nullptr);
    setFieldVisible(second_, edge != nullptr);
    setFieldVisible(t_, edge != nullptr);
    setFieldVisible(near_, near != nullptr);
    titleOf(first_).setText(face != nullptr ? tr("&Face") : tr("&Vertex"));
    if (vertex != nullptr) first_->setNumber(static_cast<double>(vertex->vertex));
    if (edge != nullptr) {
      first_->setNumber(static_cast<double>(edge->i));
      second_->setNumber(static_cast<double>(edge->j));
      t_->setNumber(edge->t);
    }
    if (face != nullptr) first_->setNumber(static_cast<double>(face->face));
    if (near != nullptr) near_->setNumbers({near->place.x(), near->place.y(), near->place.z()});
    showWeights(face);
    const std::optional<Vector3> rest = restPlace(editor(), at);
    rest_->setText(rest ? roundedText(*rest) : tr("nowhere: the mesh has no such place"));
    rest_->setToolTip(rest ? exactText(*rest) : QString());
  }

  void showWeights(const AtFace* at)
  {
    setFieldVisible(weights_, at != nullptr);
    if (at == nullptr) return;
    if (weightEdits_.size() != at->weights.size()) {
      for (NumberEdit* edit : weightEdits_) edit->deleteLater();
      weightEdits_.clear();
      for (int k = 0; k < static_cast<int>(at->weights.size()); ++k) {
        auto* edit =
            named(new NumberEdit(weights_), QString("locationWeight%1").arg(k), tr("Weight of corner %1").arg(k));
        weightLines_->addWidget(edit, k / kWeightsInLine, k % kWeightsInLine);
        connect(edit, &NumberEdit::entered, this, &LocationSection::takeWeights);
        connect(edit, &NumberEdit::refused, this, &InspectorSection::refused);
        edit->show();
        weightEdits_.push_back(edit);
      }
      const int below = (static_cast<int>(at->weights.size()) + kWeightsInLine - 1) / kWeightsInLine;
      weightLines_->addWidget(sum_, below, 0, 1, kWeightsInLine - 1);
      weightLines_->addWidget(normalize_, below, kWeightsInLine - 1);
      QWidget* before = &near_->line(2);
      for (NumberEdit* edit : weightEdits_) {
        QWidget::setTabOrder(before, edit);
        before = edit;
      }
      QWidget::setTabOrder(before, normalize_);
    }
    for (std::size_t k = 0; k < weightEdits_.size(); ++k) weightEdits_[k]->replaceTyped(at->weights[k]);
    sum_->setText(tr("sum 1"));
  }

  void chooseKind(int kind)
  {
    const auto chosen = static_cast<LocationKind>(kind);
    const QString name = chosen == LocationKind::Vertex ? tr("put %1 on a vertex")
                         : chosen == LocationKind::Edge ? tr("put %1 on an edge")
                         : chosen == LocationKind::Face ? tr("put %1 in a face")
                                                        : tr("put %1 closest to a place");
    edit(name.arg(subject()), [&](PointConstraint& point) {
      if (kindOf(point.at) == chosen) return false;
      point.at = converted(point.at, chosen, editor().model()->mesh, editor().model()->locator());
      return true;
    });
  }

  void setId(double typed)
  {
    SurfaceLocation at = location();
    if (std::holds_alternative<AtEdge>(at)) return takeEnds();
    try {
      const Index id = idOf(typed);
      if (AtVertex* vertex = std::get_if<AtVertex>(&at)) vertex->vertex = id;
      if (AtFace* face = std::get_if<AtFace>(&at)) {
        face->face = id;
        const Polygons& faces = editor().model()->mesh.faces;
        const std::size_t corners = id < faces.size() ? faces[id].size() : face->weights.size();
        if (corners != face->weights.size()) face->weights.assign(corners, 1.0 / static_cast<double>(corners));
      }
      (void)requireRestPlace(editor(), at);
      relocate(at);
    } catch (const InputError& error) {
      Q_EMIT refused(QString::fromStdString(error.reason()));
      first_->replaceTyped(std::nullopt);
      showFields();
    }
  }

  /// What was typed stays in the lines until both are ends of one edge.
  void takeEnds()
  {
    AtEdge at = std::get<AtEdge>(location());
    try {
      at.i = idOf(first_->typed().value_or(-1));
      at.j = idOf(second_->typed().value_or(-1));
      (void)requireRestPlace(editor(), at);
      relocate(at);
    } catch (const InputError& error) {
      Q_EMIT refused(QString::fromStdString(error.reason()));
    }
  }

  void setT(double typed)
  {
    AtEdge at = std::get<AtEdge>(location());
    at.t = typed;
    if (typed >= 0 && typed <= 1) return relocate(at);
    Q_EMIT refused(tr("t is %1, but only from 0 to 1 is the point on the edge.").arg(exactText(typed)));
    t_->replaceTyped(std::get<AtEdge>(location()).t);
  }

  void setPlace(int axis, double typed)
  {
    AtNear at = std::get<AtNear>(location());
    at.place[axis] = typed;
    relocate(at);
  }

  /// What was typed stays in the lines until the weights make sense together.
  void takeWeights()
  {
    AtFace at = std::get<AtFace>(location());
    for (std::size_t k = 0; k < weightEdits_.size(); ++k) at.weights[k] = weightEdits_[k]->typed().value_or(0);
    sum_->setText(tr("sum %1").arg(exactText(std::accumulate(at.weights.begin(), at.weights.end(), 0.0))));
    try {
      requireWeights(at.weights);
    } catch (const InputError& error) {
      Q_EMIT refused(QString::fromStdString(error.reason()));
      return;
    }
    relocate(at);
  }

  void normalize()
  {
    double sum = 0;
    for (const NumberEdit* edit : weightEdits_) sum += edit->typed().value_or(0);
    if (!(sum > 0) || !std::isfinite(sum)) {
      const QString reason = tr("The weights sum to %1; only a positive sum can be normalized.");
      Q_EMIT refused(reason.arg(exactText(sum)));
      return;
    }
    for (NumberEdit* edit : weightEdits_) edit->replaceTyped(edit->typed().value_or(0) / sum);
    takeWeights();
  }

  void relocate(const SurfaceLocation& location)
  {
    edit(tr("relocate %1").arg(subject()), [&](PointConstraint& point) {
      point.at = location;
      return true;
    });
  }

  QComboBox* kind_ = nullptr;
  NumberEdit* first_ = nullptr;   // vertex, first end of the edge, or face
  NumberEdit* second_ = nullptr;  // second end of the edge
  NumberEdit* t_ = nullptr;
  VectorEdit* near_ = nullptr;
  QWidget* weights_ = nullptr;
  QGridLayout* weightLines_ = nullptr;
  std::vector<NumberEdit*> weightEdits_;
  QLabel* sum_ = nullptr;
  QPushButton* normalize_ = nullptr;
  QLabel* rest_ = nullptr;
};

}  // namespace

InspectorSection* newLocationSection(Editor& editor)
{
  return new LocationSection(editor);
}

}  // namespace holdfast
