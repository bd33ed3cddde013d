#include <QCheckBox>
#include <QLineEdit>
#include <algorithm>
#include <set>

#include <holdfast/window/inspector/inspector_section.h>
#include <holdfast/window/text/constraint_text.h>
#include <holdfast/words/error.h>

namespace holdfast {
namespace {

class InspectorPanel final : public RefreshedPanel {
 public:
  explicit InspectorPanel(Editor& editor) : editor_(editor)
  {
    setObjectName("inspectorPanel");
    QWidget* content = new QWidget;
    auto* layout = newLayout<QVBoxLayout>(content, 10, 6);
    makeHead(*layout);
    for (const auto newSections : kNewSections) {
      const Sections sections = newSections(editor);
      sections_.insert(sections_.end(), sections.begin(), sections.end());
    }
    for (InspectorSection* section : sections_) {
      layout->addWidget(section);
      connect(section, &InspectorSection::refused, this, [this](const QString& why) { showRefusal(*reason_, why); });
      connect(section, &InspectorSection::righted, reason_, &QWidget::hide);
    }
    layout->addStretch(1);
    int widest = 0;
    for (const InspectorSection* section : sections_) widest = std::max(widest, section->titleWidth());
    for (InspectorSection* section : sections_) section->setTitleWidth(widest);
    // Below the fields, so that none moves; nor does a scroll bar come that would take their width.
    auto* page = new QWidget;
    QScrollArea* fields = newScrollArea(content, tr("Selected constraints"));
    fields->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn);
    newLayout<QVBoxLayout>(page, 0, 0, {fields, reason_});
    pages_ = new HintedContent(page, "inspectorEmpty");
    fill(*this, pages_);

    for (const auto signal : {&Editor::opened, &Editor::deformed, &Editor::solveStateChanged, &Editor::decimalsChanged})
      connect(&editor, signal, this, &InspectorPanel::refresh);
    for (const auto signal : {&Editor::stateChanged, &Editor::constraintSelectionChanged})
      connect(&editor, signal, this, [this] {
        reason_->setVisible(false);
        // The fields follow a drag together with the picture.
        if (!editor_.isOpen() || !editor_.history().isInGesture()) refresh();
      });
    refresh();
  }

 private:
  void makeHead(QVBoxLayout& layout)
  {
    kind_ = named(new QLabel, "inspectorKind");
    name_ = named(new QLineEdit, "inspectorName", tr("Name of the constraint"));
    enabled_ = named(new QCheckBox(tr("Ena&bled")), "inspectorEnabled");
    reason_ = newText("inspectorRefusal");
    reason_->setVisible(false);
    reason_->setMargin(10);
    for (QWidget* widget : std::initializer_list<QWidget*>{kind_, name_, enabled_}) layout.addWidget(widget);
    connect(name_, &QLineEdit::editingFinished, this, &InspectorPanel::rename);
    connect(name_, &QLineEdit::textEdited, reason_, &QWidget::hide);
    connect(enabled_, &QCheckBox::clicked, this, &InspectorPanel::enable);
  }

  void refresh() override
  {
    if (!isVisible()) return;
    const Rows& rows = editor_.selectedConstraints();
    if (!editor_.isOpen()) return pages_->showHint(tr("No mesh is open."));
    // While the editor reports a change, the selection may still be that of a longer list.
    if (rows.empty() || rows.back() >= static_cast<Index>(editor_.list().constraints.size()))
      return pages_->showHint(tr("Select a constraint to see and edit it."));
    pages_->showContent();
    refreshHead();
    for (InspectorSection* section : sections_) {
      const bool areFit = std::all_of(rows.begin(), rows.end(),
                                      [&](Index row) { return section->fits(editor_.list().constraints[row]); });
      section->setVisible(areFit);
      if (areFit) section->inspect(rows);
    }
  }

  void refreshHead()
  {
    const Rows& rows = editor_.selectedConstraints();
    const auto& constraints = editor_.list().constraints;
    std::set<QString> kinds;
    for (const Index row : rows) kinds.insert(kindText(constraints[row]));
    const QStringList words(kinds.begin(), kinds.end());
    kind_->setText(rows.size() == 1 ? words.front()
                                    : tr("%1 constraints: %2").arg(QString::number(rows.size()), words.join(", ")));
    name_->setVisible(rows.size() == 1);
    const QString name = QString::fromStdString(constraints[rows.front()].name);
    if (!(name_->isModified() && name_->hasFocus()) && name_->text() != name) name_->setText(name);
    const auto on = std::count_if(rows.begin(), rows.end(), [&](Index row) { return constraints[row].isEnabled; });
    const bool isMixed = on > 0 && on < static_cast<std::ptrdiff_t>(rows.size());
    enabled_->setCheckState(isMixed ? Qt::PartiallyChecked : on > 0 ? Qt::Checked : Qt::Unchecked);
    enabled_->setTristate(false);
  }

  void rename()
  {
    if (!name_->isModified() || editor_.selectedConstraints().size() != 1) return;
    name_->setModified(false);
    try {
      renameConstraint(editor_, editor_.selectedConstraints().front(), name_->text());
    } catch (const InputError& error) {
      showRefusal(*reason_, QString::fromStdString(error.reason()));
    }
    refreshHead();
  }

  void enable(bool isEnabled)
  {
    switchConstraints(editor_, Rows(editor_.selectedConstraints()), isEnabled ? Enabling::Enabled : Enabling::Disabled);
    refreshHead();
  }

  Editor& editor_;
  HintedContent* pages_ = nullptr;
  QLabel* kind_ = nullptr;
  QLineEdit* name_ = nullptr;
  QCheckBox* enabled_ = nullptr;
  QLabel* reason_ = nullptr;
  Sections sections_;
};

}  // namespace

QWidget* newInspectorPanel(Editor& editor)
{
  return new InspectorPanel(editor);
}

}  // namespace holdfast
