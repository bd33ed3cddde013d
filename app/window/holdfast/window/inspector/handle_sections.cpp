#include <QHeaderView>
#include <cmath>

#include <holdfast/constraints/handle_motion.h>
#include <holdfast/document/handle_restated.h>
#include <holdfast/document/list_edits.h>
#include <holdfast/window/inspector/inspector_section.h>
#include <holdfast/window/model/at_rest.h>
#include <holdfast/window/table/vertex_table_model.h>
#include <holdfast/window/text/constraint_text.h>
#include <holdfast/words/error.h>

namespace holdfast {
namespace {

/// One of those that say the motion of a handle in another way: `byFrames`, ...
using Restatement = HandleConstraint (*)(const HandleConstraint& handle, const HandleSetting& setting);

HandleSetting settingOf(const Editor& editor, const Constraint& handle)
{
  const Index index = indexOf(editor.list(), handle.name).value();
  return settingsOf(*editor.model(), editor.list(), {&index, 1}, {}).front();
}

Constraint restated(const Editor& editor, Constraint handle, Restatement restate)
{
  handle.what = restate(std::get<HandleConstraint>(handle.what), settingOf(editor, handle));
  return handle;
}

/// Throws `InputError` with the key at fault, "to y" of ".frame.to.y", and the reason.
void requireValid(const HandleConstraint& handle)
{
  const auto error = validateHandle(handle);
  if (!error) return;
  constexpr std::string_view kFrame = ".frame.";
  std::string key = error->key.substr(error->key.starts_with(kFrame) ? kFrame.size() : 1);
  std::replace(key.begin(), key.end(), '.', ' ');
  throw InputError({}, key + ": " + error->reason);
}

void requireAxis(const Vector3& axis)
{
  if (axis.isZero(0))
    throw InputError({}, "an axis cannot be zero in x, y and z; type the new direction first, then this 0");
}

/// In the order of `HandleConstraint::motion`.
enum Method { NoTurn, AboutAxis, AboutFixed, FromFrameToFrame, VertexByVertex };
static_assert(std::variant_size_v<decltype(HandleConstraint::motion)> == VertexByVertex + 1);

AxisRotation& turnOf(HandleConstraint& handle)
{
  return std::get<AxisRotation>(handle.motion);
}

/// Reads a member of the turn; nothing from handles that do not turn about an axis.
auto ofTurn(auto AxisRotation::*member)
{
  return [=](const HandleConstraint& handle) {
    const auto* turn = std::get_if<AxisRotation>(&handle.motion);
    return turn == nullptr ? std::nullopt : std::optional(turn->*member);
  };
}

class HandleSection : public SectionOf<HandleConstraint> {
 public:
  explicit HandleSection(Editor& editor) : SectionOf(editor, tr("Motion"))
  {
    const QStringList methods{tr("none"), tr("about an axis"), tr("about the fixed region as it moves"),
                              tr("from frame to frame"), tr("from the targets of its vertices")};
    bindChoice(
        tr("&Rotation"), "handleMethod", tr("How the handle rotates"), methods,
        [](const HandleConstraint& handle) { return static_cast<double>(handle.motion.index()); },
        [this, methods](int method) { chooseMethod(method, methods[method]); });
    bindVector(tr("&Axis"), "handleAxis", ofTurn(&AxisRotation::axis), tr("rotate %1 about another axis"),
               [](HandleConstraint& handle, int axis, double number) {
                 turnOf(handle).axis[axis] = number;
                 requireAxis(turnOf(handle).axis);
               });
    explain(
        bindNumber(tr("An&gle [deg]"), "handleDegrees", ofTurn(&AxisRotation::degrees), tr("rotate %1 by %2 degrees"),
                   [](HandleConstraint& handle, double number) { turnOf(handle).degrees = number; }),
        tr("Any number of turns: 720 is twice around"));
    bindChoice(
        tr("Thro&ugh"), "handleCenterChoice", tr("What the axis goes through"), {tr("its centroid"), tr("a place")},
        [](const HandleConstraint& handle) -> std::optional<double> {
          const auto* turn = std::get_if<AxisRotation>(&handle.motion);
          return turn == nullptr ? std::nullopt : std::optional(turn->center ? 1 : 0);
        },
        [this](int choice) { chooseCenter(choice); });
    bindVector(tr("Ce&nter"), "handleCenter", ofTurn(&AxisRotation::center), tr("rotate %1 about another place"),
               [](HandleConstraint& handle, int axis, double number) { (*turnOf(handle).center)[axis] = number; });
    bindVector(
        tr("Sh&ift"), "handleTranslation", [](const HandleConstraint& handle) { return handle.translate; },
        tr("move %1 to %2 = %3"),
        [](HandleConstraint& handle, int axis, double number) { handle.translate[axis] = number; });
    explain(bindVector(
                tr("Sca&le"), "handleScale",
                [](const HandleConstraint& handle) {
                  return std::holds_alternative<VertexTargets>(handle.motion) ? std::nullopt
                                                                              : std::optional(handle.scale);
                },
                tr("scale %1 by %2 = %3"),
                [](HandleConstraint& handle, int axis, double number) {
                  handle.scale[axis] = number;
                  requireValid(handle);
                }),
            tr("Factors along the axes of its frame, else of coordinates; 1 keeps the size"));
  }

 private:
  void chooseMethod(int method, const QString& text)
  {
    change(tr("rotation of %1: %2").arg(subject(), text), [&](Constraint constraint) -> std::optional<Constraint> {
      HandleConstraint& handle = std::get<HandleConstraint>(constraint.what);
      if (static_cast<int>(handle.motion.index()) == method) return std::nullopt;
      if (method == FromFrameToFrame) return restated(editor(), constraint, byFrames);
      if (method == VertexByVertex) return restated(editor(), constraint, byTargets);
      if (method == NoTurn) handle.motion = std::monostate{};
      if (method == AboutAxis) handle.motion = AxisRotation{};
      if (method == AboutFixed) handle.motion = RotationAboutFixed{};
      return constraint;
    });
  }

  void chooseCenter(int choice)
  {
    const QString name = choice == 0 ? tr("rotate %1 about its centroid") : tr("rotate %1 about a place");
    edit(name.arg(subject()), [&](HandleConstraint& handle) {
      if (turnOf(handle).center.has_value() == (choice == 1)) return false;
      turnOf(handle).center = choice == 1 ? std::optional(centroidOf(handle)) : std::nullopt;
      return true;
    });
  }

  Vector3 centroidOf(const HandleConstraint& handle)
  {
    const std::vector<Index> vertices = findVertices(editor(), handle.select).vertices;
    if (vertices.empty()) return Vector3::Zero();
    const std::vector<Index> counted = firstOfUnknowns(vertices, editor().model()->solverMesh.weld.unknownOf);
    const Positions rest = editor().model()->mesh.positions(vertices, Eigen::all);
    const Positions places = rest(counted, Eigen::all);
    return centroid(places);
  }
};

auto& framesOf(auto& handle)
{
  return std::get<FrameMotion>(handle.motion);
}

/// Puts the numbers of the lines into `vector`; an empty line leaves its number as it is.
void take(const VectorEdit& lines, Vector3& vector)
{
  const VectorEdit::Numbers typed = lines.typed();
  for (Index axis = 0; axis < 3; ++axis) vector[axis] = typed[static_cast<std::size_t>(axis)].value_or(vector[axis]);
}

/// Numbers of the frames stay in the lines until they make frames.
class FrameSection : public SectionOf<HandleConstraint> {
 public:
  explicit FrameSection(Editor& editor) : SectionOf(editor, tr("Frames"))
  {
    addFrame(&FrameMotion::from, tr("Fro&m"), "frameFrom", {tr("its centroid"), tr("a place")});
    addFrame(&FrameMotion::to, tr("T&o"), "frameTo", {tr("the same place"), tr("a place")});
    explain(bindNumber(
                tr("&Whole turns"), "frameTurns",
                [](const HandleConstraint& handle) { return static_cast<double>(framesOf(handle).turns); },
                tr("rotate %1 by %2 whole turns more"),
                [](HandleConstraint& handle, double turns) {
                  framesOf(handle).turns = wholeNumber(turns, -INFINITY, "is no whole number of turns");
                  requireValid(handle);
                }),
            tr("Added to the shortest rotation, about its axis"));
  }

  bool fits(const Constraint& constraint) const override
  {
    return SectionOf::fits(constraint) &&
           std::holds_alternative<FrameMotion>(std::get<HandleConstraint>(constraint.what).motion);
  }

 private:
  struct Lines {
    Frame FrameMotion::*frame;
    VectorEdit* origin;
    VectorEdit* x;
    VectorEdit* y;
  };

  void addFrame(Frame FrameMotion::*frame, const QString& title, const QString& name, const QStringList& origins)
  {
    const QString spoken = QString(title).remove('&');
    bindChoice(
        title, name + "Choice", tr("%1: where the frame is").arg(spoken), origins,
        [=](const HandleConstraint& handle) { return (framesOf(handle).*frame).origin ? 1.0 : 0.0; },
        [this, frame](int choice) { chooseOrigin(frame, choice); });
    lines_.push_back({frame, addVector(tr("Origin"), name + "Origin", tr("%1: origin").arg(spoken)),
                      addVector(tr("x axis"), name + "X", tr("%1: x axis").arg(spoken)),
                      addVector(tr("y axis"), name + "Y", tr("%1: y axis").arg(spoken))});
    const auto& [ofMotion, origin, x, y] = lines_.back();
    explain(x, tr("Of any length"));
    explain(y, tr("Of any length; its part along x is ignored"));
    for (VectorEdit* line : {origin, x, y}) connect(line, &VectorEdit::entered, this, &FrameSection::takeFrames);
  }

  void refresh() override
  {
    SectionOf::refresh();
    const bool isOther = isNews();
    for (const auto& [frame, origin, x, y] : lines_) {
      const auto show = [&, frame = frame](VectorEdit* line, auto Frame::*vector) {
        line->setNumbers(commonVector([&](const Constraint& c) {
          return std::optional<Vector3>(framesOf(std::get<HandleConstraint>(c.what)).*frame.*vector);
        }));
      };
      showWhileGiven(origin,
                     [frame = frame](const HandleConstraint& handle) { return (framesOf(handle).*frame).origin; });
      if (!isOther) continue;
      show(origin, &Frame::origin);
      show(x, &Frame::x);
      show(y, &Frame::y);
    }
  }

  void chooseOrigin(Frame FrameMotion::*place, int choice)
  {
    const QString name = choice == 0 ? tr("take the origin of %1 from its vertices") : tr("give %1 an origin");
    change(name.arg(subject()), [&](Constraint constraint) -> std::optional<Constraint> {
      HandleConstraint& handle = std::get<HandleConstraint>(constraint.what);
      Frame& frame = framesOf(handle).*place;
      if (frame.origin.has_value() == (choice == 1)) return std::nullopt;
      if (choice == 0)
        frame.origin.reset();
      else
        frame.origin = framesOf(handle).from.origin.value_or(centroid(settingOf(editor(), constraint)));
      requireValid(handle);
      return constraint;
    });
  }

  void takeFrames()
  {
    edit(tr("set the frames of %1").arg(subject()), [this](HandleConstraint& handle) {
      for (const auto& [ofMotion, origin, x, y] : lines_) {
        Frame& frame = framesOf(handle).*ofMotion;
        if (frame.origin) take(*origin, *frame.origin);
        take(*x, frame.x);
        take(*y, frame.y);
      }
      requireValid(handle);
      return true;
    });
  }

  std::vector<Lines> lines_;
};

constexpr int kMostRowsInSight = 6;

/// Why the vertices cannot have entries of their own; empty if they can.
QString whyNotSingle(HandleConstraint handle)
{
  const auto* listed = std::get_if<VertexIds>(&handle.select.what);
  if (listed == nullptr)
    return InspectorSection::tr(
               "Only a handle that lists its vertices can give each its own. This one selects by its shape: %1.")
        .arg(selectionText(handle.select));
  handle.motion = std::monostate{};
  handle.rotations.assign(listed->ids.size(), {});
  const auto error = validateHandle(handle);
  return error ? QString::fromStdString(error->reason) : QString();
}

QTableView* newVertexTable(VertexTableModel& model, const QString& name, const QString& spoken)
{
  auto* table = named(new QTableView, name, spoken);
  table->setModel(&model);
  setTableLook(*table);
  table->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
  table->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  table->verticalHeader()->hide();
  table->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  return table;
}

int heightOfRows(const QTableView& table)
{
  const int rows = std::min(table.model()->rowCount(), kMostRowsInSight);
  return table.horizontalHeader()->sizeHint().height() + rows * table.verticalHeader()->defaultSectionSize() +
         2 * table.frameWidth();
}

class SingleVerticesSection : public SectionOf<HandleConstraint> {
 public:
  explicit SingleVerticesSection(Editor& editor) : SectionOf(editor, tr("Single vertices"))
  {
    reason_ = newText("singleVerticesReason");
    addRow({}, reason_);
    rotations_ = addPart(VertexTableModel::What::Rotations, tr("&Rotations"), "vertexRotations");
    targets_ = addPart(VertexTableModel::What::Targets, tr("Tar&gets"), "vertexTargets");
    connect(rotations_.button, &QPushButton::clicked, this, &SingleVerticesSection::switchRotations);
    connect(targets_.button, &QPushButton::clicked, this, &SingleVerticesSection::switchTargets);
    connect(rotations_.model, &VertexTableModel::entered, this, &SingleVerticesSection::setRotation);
    connect(targets_.model, &VertexTableModel::entered, this, &SingleVerticesSection::setTarget);
  }

 private:
  void refresh() override
  {
    setVisible(rows().size() == 1);
    if (rows().size() != 1 || !isNews()) return;
    // A drag selects no other vertices, and there may be many.
    if (!editor().history().isInGesture()) reason_->setText(whyNotSingle(what()));
    const QString reason = reason_->text();
    setFieldVisible(reason_, !reason.isEmpty());
    showPart(rotations_, !what().rotations.empty(), reason);
    showPart(targets_, std::holds_alternative<VertexTargets>(what().motion), reason);
  }

  /// The switch, and the table that is visible while it is on.
  struct Part {
    QPushButton* button = nullptr;
    QTableView* table = nullptr;
    VertexTableModel* model = nullptr;
  };

  Part addPart(VertexTableModel::What what, const QString& title, const QString& name)
  {
    const QString spoken = QString(title).remove('&');
    Part part;
    part.model = new VertexTableModel(what, this);
    part.button = named(new QPushButton, name + "Switch");
    addRow(title, part.button);
    part.table = newVertexTable(*part.model, name, tr("%1 of single vertices").arg(spoken));
    addRow({}, part.table);
    connect(part.model, &VertexTableModel::refused, this, &InspectorSection::refused);
    connect(part.model, &VertexTableModel::righted, this, &InspectorSection::righted);
    return part;
  }

  void showPart(const Part& part, bool isOwn, const QString& reason)
  {
    setFieldVisible(part.button, reason.isEmpty());
    setFieldVisible(part.table, isOwn);
    part.button->setText(isOwn ? tr("Take one for all") : tr("Give each vertex its own"));
    if (!isOwn) return;
    part.model->show(editor().history().state(), rows().front(), editor().decimals());
    part.table->setFixedHeight(heightOfRows(*part.table));
  }

  void setRotation(int row, int column, double number)
  {
    const QString vertex = QString::number(rotations_.model->vertex(row));
    edit(tr("rotate vertex %1 of %2 otherwise").arg(vertex, subject()), [&](HandleConstraint& handle) {
      AxisAngle& turn = handle.rotations[row];
      (column == VertexTableModel::Degrees ? turn.degrees : turn.axis[column - VertexTableModel::X]) = number;
      requireAxis(turn.axis);
      return true;
    });
  }

  void setTarget(int row, int column, double number)
  {
    const QString vertex = QString::number(targets_.model->vertex(row));
    const int axis = column - VertexTableModel::X;
    edit(tr("move vertex %1 of %2 to %3 = %4").arg(vertex, subject(), axisText(axis), exactText(number)),
         [&](HandleConstraint& handle) {
           std::get<VertexTargets>(handle.motion).places[row][axis] = number;
           return true;
         });
  }

  void switchRotations()
  {
    const bool isOwn = !what().rotations.empty();
    const QString name =
        isOwn ? tr("take one rotation for all vertices of %1") : tr("give each vertex of %1 its own rotation");
    change(name.arg(subject()), [&](Constraint constraint) {
      if (!isOwn) return restated(editor(), constraint, withRotations);
      std::get<HandleConstraint>(constraint.what).rotations.clear();
      return constraint;
    });
  }

  void switchTargets()
  {
    const bool isOwn = std::holds_alternative<VertexTargets>(what().motion);
    const QString name =
        isOwn ? tr("take one motion for all vertices of %1") : tr("give each vertex of %1 its own target");
    change(name.arg(subject()),
           [&](const Constraint& constraint) { return restated(editor(), constraint, isOwn ? byFrames : byTargets); });
  }

  QLabel* reason_ = nullptr;
  Part rotations_;
  Part targets_;
};

}  // namespace

Sections newHandleSections(Editor& editor)
{
  return {new HandleSection(editor), new FrameSection(editor), new SingleVerticesSection(editor)};
}

}  // namespace holdfast
