#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

#include <holdfast/constraint_files/constraint_file.h>
#include <holdfast/document/handle_restated.h>
#include <holdfast/surface/surface_locator.h>
#include <holdfast/window/inspector/guide_section.h>
#include <holdfast/window/model/at_rest.h>

namespace holdfast {
namespace {

constexpr int kWeightsInLine = 3;

Index idOf(std::optional<double> typed)
{
  return wholeNumber(typed.value_or(-1), 0, "is no id; ids are whole numbers and count from 0");
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
  explicit LocationSection(Editor& editor) : SectionOf(editor, tr("Place"))
  {
    explain(bindChoice(
                tr("&Lies on"), "locationKind", tr("What the point lies on"),
                {tr("a vertex"), tr("an edge"), tr("a face"), tr("the surface, closest to a place")},
                [](const PointConstraint& point) { return static_cast<double>(kindOf(point.at)); },
                [this](int kind) { chooseKind(static_cast<LocationKind>(kind)); }),
            tr("Another kind keeps the point as near as it can be"));
    first_ = addNumber(tr("Verte&x"), "locationFirst");
    second_ = addNumber(tr("and vertex"), "locationSecond");
    explain(bindNumber(
                tr("&t"), "locationT",
                [](const PointConstraint& point) {
                  const AtEdge* edge = std::get_if<AtEdge>(&point.at);
                  return edge == nullptr ? std::nullopt : std::optional(edge->t);
                },
                tr("relocate %1"),
                [](PointConstraint& point, double t) {
                  if (t < 0 || t > 1)
                    throw InputError(
                        {}, "t is " + exactText(t).toStdString() + ", but the point is on the edge only from 0 to 1");
                  std::get<AtEdge>(point.at).t = t;
                }),
            tr("The share of the first vertex: 1 there, 0 at the second"));
    near_ = bindVector(
        tr("&Near"), "locationNear",
        [](const PointConstraint& point) {
          const AtNear* near = std::get_if<AtNear>(&point.at);
          return near == nullptr ? std::nullopt : std::optional(near->place);
        },
        tr("relocate %1"),
        [](PointConstraint& point, int axis, double number) { std::get<AtNear>(point.at).place[axis] = number; });

    weights_ = new QWidget(this);
    weights_->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    weightLines_ = new QGridLayout(weights_);
    weightLines_->setContentsMargins(0, 0, 0, 0);
    weightLines_->setSpacing(4);
    for (int column = 0; column < kWeightsInLine; ++column) weightLines_->setColumnStretch(column, 1);
    sum_ = named(new QLabel(weights_), "locationSum");
    // Fields stay where they are, however long it is.
    sum_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    normalize_ = named(new QPushButton(tr("N&ormalize"), weights_), "locationNormalize");
    normalize_->setToolTip(tr("Divides all weights by their sum"));
    addRow(tr("Weights"), weights_);
    rest_ = addText(tr("At rest"), "locationRest");

    connect(first_, &NumberEdit::entered, this, &LocationSection::takeIds);
    connect(second_, &NumberEdit::entered, this, &LocationSection::takeIds);
    connect(normalize_, &QPushButton::clicked, this, &LocationSection::normalize);
  }

 private:
  void refresh() override
  {
    setVisible(rows().size() == 1);
    if (rows().size() != 1) return;
    SectionOf::refresh();
    if (isNews()) showFields();
  }

  void showFields()
  {
    const SurfaceLocation& at = what().at;
    const AtVertex* vertex = std::get_if<AtVertex>(&at);
    const AtEdge* edge = std::get_if<AtEdge>(&at);
    const AtFace* face = std::get_if<AtFace>(&at);
    setFieldVisible(first_, vertex != nullptr || edge != nullptr || face != nullptr);
    setFieldVisible(second_, edge != nullptr);
    setFieldVisible(weights_, face != nullptr);
    titleOf(first_).setText(face != nullptr ? tr("F&ace") : tr("Verte&x"));
    if (vertex != nullptr) first_->replaceTyped(static_cast<double>(vertex->vertex));
    if (edge != nullptr) {
      first_->replaceTyped(static_cast<double>(edge->i));
      second_->replaceTyped(static_cast<double>(edge->j));
    }
    if (face != nullptr) {
      first_->replaceTyped(static_cast<double>(face->face));
      showWeights(face->weights);
    }
    const std::optional<Vector3> rest = restPlace(editor(), at);
    rest_->setText(rest ? placeText(*rest, editor().lengthStyle()) : tr("nowhere: the mesh has no such place"));
    rest_->setToolTip(rest ? exactText(*rest) : QString());
  }

  void showWeights(const std::vector<double>& weights)
  {
    if (weightEdits_.size() != weights.size()) makeWeights(static_cast<int>(weights.size()));
    for (std::size_t k = 0; k < weightEdits_.size(); ++k) weightEdits_[k]->replaceTyped(weights[k]);
    sum_->setText(tr("sum 1"));
  }

  void makeWeights(int count)
  {
    for (NumberEdit* edit : weightEdits_) edit->deleteLater();
    weightEdits_.clear();
    QWidget* before = &near_->line(2);
    for (int k = 0; k < count; ++k) {
      auto* edit =
          named(new NumberEdit(weights_), QString("locationWeight%1").arg(k), tr("Weight of corner %1").arg(k));
      weightLines_->addWidget(edit, k / kWeightsInLine, k % kWeightsInLine);
      connect(edit, &NumberEdit::entered, this, &LocationSection::takeWeights);
      connect(edit, &NumberEdit::refused, this, &InspectorSection::refused);
      connect(edit, &NumberEdit::righted, this, &InspectorSection::righted);
      edit->show();
      QWidget::setTabOrder(before, edit);
      before = edit;
      weightEdits_.push_back(edit);
    }
    const int below = (count + kWeightsInLine - 1) / kWeightsInLine;
    weightLines_->addWidget(sum_, below, 0, 1, kWeightsInLine - 1);
    weightLines_->addWidget(normalize_, below, kWeightsInLine - 1);
    QWidget::setTabOrder(before, normalize_);
  }

  void chooseKind(LocationKind kind)
  {
    const QString name = kind == LocationKind::Vertex ? tr("put %1 on a vertex")
                         : kind == LocationKind::Edge ? tr("put %1 on an edge")
                         : kind == LocationKind::Face ? tr("put %1 in a face")
                                                      : tr("put %1 closest to a place");
    edit(name.arg(subject()), [&](PointConstraint& point) {
      if (kindOf(point.at) == kind) return false;
      point.at = converted(point.at, kind, editor().model()->mesh, editor().model()->locator());
      return true;
    });
  }

  /// The ids of an edge stay in the lines until both are ends of one edge.
  void takeIds()
  {
    relocate([this](SurfaceLocation& at) {
      if (AtVertex* vertex = std::get_if<AtVertex>(&at)) vertex->vertex = idOf(first_->typed());
      if (AtEdge* edge = std::get_if<AtEdge>(&at)) *edge = {idOf(first_->typed()), idOf(second_->typed()), edge->t};
      if (AtFace* face = std::get_if<AtFace>(&at)) {
        face->face = idOf(first_->typed());
        const Polygons& faces = editor().model()->mesh.faces;
        const std::size_t corners = face->face < faces.size() ? faces[face->face].size() : face->weights.size();
        if (corners != face->weights.size()) face->weights.assign(corners, 1.0 / static_cast<double>(corners));
      }
      static_cast<void>(requireRestPlace(editor(), at));
    });
    if (!std::holds_alternative<AtEdge>(what().at)) showFields();
  }

  /// What was typed stays in the lines until the weights make sense together.
  void takeWeights()
  {
    std::vector<double> weights;
    for (const NumberEdit* edit : weightEdits_) weights.push_back(edit->typed().value_or(0));
    sum_->setText(tr("sum %1").arg(exactText(std::accumulate(weights.begin(), weights.end(), 0.0))));
    relocate([&](SurfaceLocation& at) {
      requireWeights(weights);
      std::get<AtFace>(at).weights = weights;
    });
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

  /// `move` throws `InputError` where the location makes no sense.
  void relocate(const std::function<void(SurfaceLocation&)>& move)
  {
    edit(tr("relocate %1").arg(subject()), [&](PointConstraint& point) {
      move(point.at);
      return true;
    });
  }

  NumberEdit* first_ = nullptr;   // vertex, first end of the edge, or face
  NumberEdit* second_ = nullptr;  // second end of the edge
  VectorEdit* near_ = nullptr;
  QWidget* weights_ = nullptr;
  QGridLayout* weightLines_ = nullptr;
  std::vector<NumberEdit*> weightEdits_;
  QLabel* sum_ = nullptr;
  QPushButton* normalize_ = nullptr;
  QLabel* rest_ = nullptr;
};

/// In the order of `PointConstraint::to`.
enum Way { ToPlace, ByShift, ToCoordinates, OnAPlane, OnALine, OnAnotherMesh };
static_assert(std::variant_size_v<decltype(PointConstraint::to)> == OnAnotherMesh + 1);

/// The sets of coordinates that may be free, as bits, in the order in which they are offered.
constexpr std::array<unsigned, 6> kFreeSets{0b001, 0b010, 0b100, 0b011, 0b110, 0b101};

class TargetSection : public GuideSection<PointConstraint, &PointConstraint::to> {
 public:
  explicit TargetSection(Editor& editor) : GuideSection(editor, tr("Target"))
  {
    bindChoice(
        tr("&Goes"), "targetWay", tr("How the target is given"),
        {tr("to a place"), tr("by a shift from rest"), tr("to single coordinates"), tr("on a plane"), tr("on a line"),
         tr("on another mesh…")},
        [](const PointConstraint& point) { return static_cast<double>(point.to.index()); },
        [this](int way) { chooseWay(static_cast<Way>(way)); });
    VectorEdit* place = bindVector(
        tr("Ta&rget"), "targetPlace", [this](const PointConstraint& point) { return placeOfGoal(point); },
        tr("move %1 to %2 = %3"),
        [this](PointConstraint& point, int axis, double number) { setPlace(point, axis, number); },
        WithoutValue::Shown);
    addRefresh([=, this] {
      PointConstraint point = what();
      titleOf(place).setText(throughOf(point) == nullptr ? tr("Ta&rget") : tr("Th&rough"));
      setFieldVisible(place, !std::holds_alternative<OnMesh>(point.to));
    });
    bindVector(
        tr("Sh&ift"), "targetShift",
        [](const PointConstraint& point) {
          const Move* move = std::get_if<Move>(&point.to);
          return move == nullptr ? std::nullopt : std::optional(move->shift);
        },
        tr("shift %1 by %2 = %3"),
        [](PointConstraint& point, int axis, double number) { std::get<Move>(point.to).shift[axis] = number; });
    addCoordinates();
    bindGuides("target");
  }

 private:
  void addCoordinates()
  {
    bindChoice(
        tr("Free a&long"), "targetFree", tr("The coordinates that are free"),
        {"x", "y", "z", tr("x and y"), tr("y and z"), tr("x and z")},
        [](const PointConstraint& point) -> std::optional<double> {
          const auto* coordinates = std::get_if<Coordinates>(&point.to);
          if (coordinates == nullptr) return std::nullopt;
          return static_cast<double>(std::ranges::find(kFreeSets, freeSetOf(*coordinates)) - kFreeSets.begin());
        },
        [this](int choice) { chooseFree(kFreeSets[static_cast<std::size_t>(choice)]); });
  }

  static unsigned freeSetOf(const Coordinates& coordinates)
  {
    unsigned set = 0;
    for (std::size_t k = 0; k < 3; ++k)
      if (!coordinates.values[k]) set |= 1U << k;
    return set;
  }

  /// Where the point goes; of a plane or a line the place through which it leads. Nothing where the mesh has no such
  /// point.
  [[nodiscard]] std::optional<Vector3> placeOfGoal(const PointConstraint& point) const
  {
    if (const Target* target = std::get_if<Target>(&point.to)) return target->place;
    const std::optional<Vector3> rest = restPlace(editor(), point.at);
    if (const OnPlane* plane = std::get_if<OnPlane>(&point.to)) return plane->point ? plane->point : rest;
    if (const OnLine* line = std::get_if<OnLine>(&point.to)) return line->point ? line->point : rest;
    return rest ? std::optional(placeOf(point, *rest)) : std::nullopt;
  }

  /// A coordinate that was free is prescribed from then on.
  void setPlace(PointConstraint& point, int axis, double number) const
  {
    Vector3 rest = requireRestPlace(editor(), point.at);
    if (auto* coordinates = std::get_if<Coordinates>(&point.to)) {
      coordinates->values[static_cast<std::size_t>(axis)] = number;
      if (freeSetOf(*coordinates) == 0) point.to = Target{coordinates->placeFrom(rest)};
      return;
    }
    Vector3 place = placeOfGoal(point).value();
    place[axis] = number;
    if (std::optional<Vector3>* through = throughOf(point))
      *through = place;
    else
      point.setTarget(place, [&](const SurfaceLocation& /*at*/) { return rest; });
  }

  void chooseWay(Way way)
  {
    if (way == OnAnotherMesh) return askForMesh();
    const std::array names{tr("send %1 to a place"), tr("shift %1"), tr("hold coordinates of %1"),
                           tr("keep %1 on a plane"), tr("keep %1 on a line")};
    edit(names[way].arg(subject()), [&](PointConstraint& point) {
      const std::optional<Vector3> rest = restPlace(editor(), point.at);
      if (!rest || point.to.index() == static_cast<std::size_t>(way)) return false;
      point.to = goalOf(way, point, *rest);
      if (validateTolerance(point.within, point.directions())) point.within = Exactly{};
      return true;
    });
  }

  /// What takes the point where it goes now. Planes and lines get the direction across the surface at rest.
  [[nodiscard]] decltype(PointConstraint::to) goalOf(Way way, const PointConstraint& point, const Vector3& rest) const
  {
    const Vector3 place = placeOf(point, rest);
    if (way == ToPlace) return Target{place};
    if (way == ByShift) return Move{place - rest};
    const Model& model = *editor().model();
    const Vector3 across = surfaceAxes(model, model.locator().locate(point.at, {}), model.mesh.positions).col(2);
    if (way == OnAPlane) return OnPlane{place, across, 0};
    if (way == OnALine) return OnLine{place, across};
    Index axis = 0;
    across.cwiseAbs().maxCoeff(&axis);
    Coordinates coordinates;
    coordinates.values[static_cast<std::size_t>(axis)] = place[axis];
    return coordinates;
  }

  void chooseFree(unsigned set)
  {
    edit(tr("hold coordinates of %1").arg(subject()), [&](PointConstraint& point) {
      const std::optional<Vector3> rest = restPlace(editor(), point.at);
      auto& coordinates = std::get<Coordinates>(point.to);
      if (!rest || freeSetOf(coordinates) == set) return false;
      const Vector3 place = coordinates.placeFrom(*rest);
      for (std::size_t k = 0; k < 3; ++k)
        coordinates.values[k] = (set >> k & 1U) != 0 ? std::nullopt : std::optional(place[static_cast<Index>(k)]);
      return true;
    });
  }
};

}  // namespace

Sections newPointSections(Editor& editor)
{
  return {new LocationSection(editor), new TargetSection(editor)};
}

}  // namespace holdfast
