#include "holdfast/window/panels/findings_panel.h"

#include <QLabel>
#include <QPushButton>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include <holdfast/document/list_edits.h>
#include <holdfast/window/controls/labels.h>
#include <holdfast/window/controls/status_style.h>
#include <holdfast/window/model/constraint_actions.h>

namespace holdfast {
namespace {

// More are read by nobody; the report has them all.
constexpr std::size_t kMostFindings = 200;

/// The constraints that a finding names by their places in the list that was solved, by those in the list on screen.
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

}  // namespace

std::vector<Index> verticesOf(const Finding& finding, const Mesh& mesh)
{
  std::vector<Index> vertices;
  if (finding.idsOf == "vertex") vertices = finding.ids;
  if (finding.idsOf == "face")
    for (const Index face : finding.ids)
      vertices.insert(vertices.end(), mesh.faces[face].begin(), mesh.faces[face].end());
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

FindingsPanel::FindingsPanel(Editor& editor, QWidget* parent) : QWidget(parent), editor_(editor)
{
  setObjectName("findingsPanel");
  empty_ = newHint("findingsEmpty");
  list_ = new CardList;
  list_->setAccessibleName(tr("Findings about the mesh"));
  pages_ = new QStackedWidget;
  pages_->addWidget(empty_);
  pages_->addWidget(list_);
  QVBoxLayout* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(pages_);
  connect(&editor, &Editor::opened, this, &FindingsPanel::refresh);
  connect(&editor, &Editor::deformed, this, &FindingsPanel::refresh);
  refresh();
}

void FindingsPanel::showEvent(QShowEvent* event)
{
  refresh();
  QWidget::showEvent(event);
}

void FindingsPanel::refresh()
{
  if (!isVisible()) return;
  // The report begins with those of the mesh.
  findings_ = !editor_.isOpen()                  ? std::vector<Finding>()
              : editor_.deformation() == nullptr ? editor_.model()->findings
                                                 : editor_.deformation()->report.mesh.findings;
  if (findings_.size() > kMostFindings) findings_.resize(kMostFindings);
  while (cards_.size() < findings_.size()) addCard();
  for (std::size_t k = 0; k < cards_.size(); ++k) {
    cards_[k]->setVisible(k < findings_.size());
    if (k < findings_.size()) fill(k);
  }
  pages_->setCurrentIndex(findings_.empty() ? 0 : 1);
  empty_->setText(editor_.isOpen() ? tr("Nothing is doubtful about the mesh or the constraints.")
                                   : tr("No mesh is open."));
}

void FindingsPanel::addCard()
{
  const std::size_t k = cards_.size();
  Card* card = new Card;
  card->setObjectName(QStringLiteral("finding%1").arg(k));
  connect(card->addButton(tr("Show Me"), "findingShow"), &QPushButton::clicked, this, [this, k] { showWhere(k); });
  list_->add(card);
  cards_.push_back(card);
}

void FindingsPanel::fill(std::size_t card)
{
  const Finding& finding = findings_[card];
  QString kind = QString::fromStdString(finding.kind).replace('_', ' ');
  kind[0] = kind[0].toUpper();
  const bool isAboutConstraints = finding.idsOf == "constraint";
  cards_[card]->setTitle(isAboutConstraints ? tr("Constraints: %1").arg(kind.toLower()) : kind);
  cards_[card]->setText(QString::fromStdString(finding.message));
  cards_[card]->findChild<QPushButton*>("findingShow")->setVisible(!finding.ids.empty());
}

void FindingsPanel::showWhere(std::size_t card)
{
  const Finding& finding = findings_[card];
  if (finding.idsOf == "constraint")
    editor_.selectConstraints(constraintsOf(finding, editor_));
  else
    Q_EMIT showVertices(verticesOf(finding, editor_.model()->mesh));
}

}  // namespace holdfast
