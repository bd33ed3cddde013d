#include <algorithm>
#include <iterator>
#include <utility>

#include <holdfast/document/list_edits.h>
#include <holdfast/geometry/bounding_box.h>
#include <holdfast/mesh/index_lists.h>
#include <holdfast/window/controls/panel_parts.h>
#include <holdfast/window/controls/status_style.h>
#include <holdfast/window/model/constraint_actions.h>
#include <holdfast/window/panels/panels.h>
#include <holdfast/window/text/number_text.h>
#include <holdfast/words/printable.h>

namespace holdfast {
namespace {

// The report has all of them.
constexpr std::size_t kMostFindings = 200;

/// The places in the list on screen of the constraints that a finding names by places in the list that was solved.
Rows constraintsOf(const Finding& finding, const Editor& editor)
{
  Rows rows;
  if (editor.deformedState() == nullptr) return rows;
  const auto& solved = editor.deformedState()->list.constraints;
  for (const Index id : finding.ids)
    if (id < static_cast<Index>(solved.size()))
      if (const std::optional<Index> row = indexOf(editor.list(), solved[id].name)) rows.push_back(*row);
  return rows;
}

/// The file, its size, its parts, and the box around it now.
QString aboutMesh(const Editor& editor)
{
  const Model& model = *editor.model();
  const QString units = toText(editor.list().units);
  const Eigen::AlignedBox3d rest = boundingBox(model.mesh.positions);
  const Eigen::AlignedBox3d now = boundingBox(editor.positions());
  const LengthStyle style = editor.lengthStyle();
  const auto sizesOf = [&style](const Eigen::AlignedBox3d& box) {
    const Vector3 sizes = box.sizes();
    return QString("%1 × %2 × %3")
        .arg(numberText(sizes.x(), style), numberText(sizes.y(), style), numberText(sizes.z(), style));
  };
  const Index parts = model.solverMesh.componentCount;
  const QStringList lines{
      QString::fromStdString(printable(editor.mesh().path.filename().string())),
      QObject::tr("%1 vertices, %2 faces, %3")
          .arg(countText(model.mesh.vertexCount()), countText(model.mesh.faces.size()),
               parts == 1 ? QObject::tr("1 part") : QObject::tr("%1 parts").arg(countText(parts))),
      QObject::tr("Size: %1 %2").arg(sizesOf(now), units.isEmpty() ? QObject::tr("(no unit)") : units) +
          (sizesOf(now) == sizesOf(rest) ? QString() : QObject::tr("; at rest %1").arg(sizesOf(rest))),
      QObject::tr("Bounds: %1 to %2").arg(placeText(now.min(), style), placeText(now.max(), style))};
  return lines.join('\n');
}

class FindingsPanel final : public RefreshedPanel {
 public:
  FindingsPanel(Editor& editor, const std::function<void(const std::vector<Index>&)>& showVertices)
      : editor_(editor), showVertices_(showVertices)
  {
    setObjectName("findingsPanel");
    list_ = named(new CardList, "findingsList", tr("Findings about the mesh"));
    pages_ = new HintedContent(list_, "findingsEmpty");
    about_ = newText("meshAbout");
    newLayout<QVBoxLayout>(this, 0, 0, {about_, pages_})->setStretch(1, 1);
    about_->setContentsMargins(9, 6, 9, 3);
    connect(&editor, &Editor::opened, this, &FindingsPanel::refresh);
    connect(&editor, &Editor::deformed, this, &FindingsPanel::refresh);
    connect(&editor, &Editor::decimalsChanged, this, &FindingsPanel::refresh);
    connect(&editor, &Editor::examined, this, &FindingsPanel::refresh);
    refresh();
  }

 private:
  void refresh() override
  {
    if (!isVisible()) return;
    about_->setVisible(editor_.isOpen());
    if (editor_.isOpen()) {
      about_->setText(aboutMesh(editor_));
      about_->setToolTip(plainTip(QString::fromStdString(printable(editor_.mesh().path.string()))));
    }
    collect();
    if (findings_.size() > kMostFindings) findings_.resize(kMostFindings);
    while (cards_.size() < findings_.size()) addCard();
    for (std::size_t k = 0; k < cards_.size(); ++k) {
      cards_[k]->setVisible(k < findings_.size());
      if (k < findings_.size()) fill(k);
    }
    if (!findings_.empty()) return pages_->showContent();
    pages_->showHint(editor_.isOpen() ? tr("No problems found.") : tr("No mesh is open."));
  }

  /// Warnings first. Until a result was looked at, those of the one before stay: cards do not flicker in a drag.
  void collect()
  {
    const auto& report = editor_.report();
    Findings findings;
    if (!editor_.isResultKnown())
      std::ranges::copy_if(findings_, std::back_inserter(findings), [this](const auto& f) { return isWarning(f); });
    else
      warnings_ = report == nullptr ? std::vector<std::string>() : report->result.warnings;
    // The report begins with those of the mesh.
    if (editor_.isOpen())
      std::ranges::copy(report == nullptr ? editor_.model()->findings : report->mesh.findings,
                        std::back_inserter(findings));
    findings_ = std::move(findings);
    std::stable_partition(findings_.begin(), findings_.end(),
                          [this](const Finding& finding) { return isWarning(finding); });
  }

  /// Tells whether it is about what the solution made of the part.
  [[nodiscard]] bool isWarning(const Finding& finding) const
  {
    return std::ranges::find(warnings_, finding.kind) != warnings_.end();
  }

  void addCard()
  {
    const std::size_t k = cards_.size();
    Card* card = named(new Card, QString("finding%1").arg(k));
    connect(card->addButton(tr("Show"), "findingShow"), &QPushButton::clicked, this, [this, k] { showWhere(k); });
    list_->add(card);
    cards_.push_back(card);
  }

  void fill(std::size_t card)
  {
    const Finding& finding = findings_[card];
    QString kind = QString::fromStdString(finding.kind).replace('_', ' ');
    kind[0] = kind[0].toUpper();
    const bool isAboutConstraints = finding.idsOf == "constraint";
    cards_[card]->setIcon(isWarning(finding) ? statusIcon(ConstraintStatus::Missed, palette()) : QIcon());
    cards_[card]->setTitle(isAboutConstraints ? tr("Constraints: %1").arg(kind.toLower()) : kind);
    cards_[card]->setText(QString::fromStdString(finding.message));
    cards_[card]->findChild<QPushButton*>("findingShow")->setVisible(!finding.ids.empty());
  }

  void showWhere(std::size_t card)
  {
    const Finding& finding = findings_[card];
    if (finding.idsOf == "constraint")
      editor_.selectConstraints(constraintsOf(finding, editor_));
    else
      showVertices_(verticesOf(finding, editor_.model()->mesh));
  }

  Editor& editor_;
  std::function<void(const std::vector<Index>&)> showVertices_;
  HintedContent* pages_ = nullptr;
  QLabel* about_ = nullptr;
  CardList* list_ = nullptr;
  std::vector<Card*> cards_;
  Findings findings_;  // those on the cards
  std::vector<std::string> warnings_;
};

}  // namespace

std::vector<Index> verticesOf(const Finding& finding, const Mesh& mesh)
{
  std::vector<Index> vertices;
  if (finding.idsOf == "vertex") vertices = finding.ids;
  if (finding.idsOf == "face")
    for (const Index face : finding.ids)
      vertices.insert(vertices.end(), mesh.faces[face].begin(), mesh.faces[face].end());
  return sortedOnce(std::move(vertices));
}

QWidget* newFindingsPanel(Editor& editor, const std::function<void(const std::vector<Index>&)>& showVertices)
{
  return new FindingsPanel(editor, showVertices);
}

}  // namespace holdfast
