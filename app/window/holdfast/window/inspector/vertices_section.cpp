#include <holdfast/window/inspector/inspector_section.h>
#include <holdfast/window/model/at_rest.h>
#include <holdfast/window/text/constraint_text.h>

namespace holdfast {
namespace {

// Each one takes a pass over all vertices at every change of the selection.
constexpr std::size_t kMostCounted = 50;

class VerticesSection : public InspectorSection {
 public:
  explicit VerticesSection(Editor& editor) : InspectorSection(editor, tr("Vertices"))
  {
    how_ = addText(tr("Selects"), "verticesHow");
    count_ = addText(tr("Holds"), "verticesCount");
    select_ = named(new QPushButton(tr("Select its ver&tices"), this), "verticesSelect");
    addRow(QStringLiteral(""), select_);
    connect(select_, &QPushButton::clicked, this, &VerticesSection::selectThem);
  }

  bool fits(const Constraint& constraint) const override { return selectionOf(constraint) != nullptr; }

 private:
  void refresh() override
  {
    setFieldVisible(how_, rows().size() == 1);
    if (rows().size() == 1) how_->setText(selectionText(*selectionOf(constraint(rows().front()))));
    // A drag moves what is selected and selects nothing else.
    if (isNews() && !(editor().history().isInGesture() && !count_->text().isEmpty())) count();
  }

  void count()
  {
    select_->setEnabled(true);
    if (rows().size() > kMostCounted) return count_->setText(tr("not counted for so many constraints"));
    Index count = 0;
    QString reason;
    for (const Index row : rows()) {
      const FoundVertices found = findVertices(editor(), *selectionOf(constraint(row)));
      count += static_cast<Index>(found.vertices.size());
      if (!found.reason.empty()) reason = quoted(constraint(row).name) + ": " + QString::fromStdString(found.reason);
    }
    const QString number = countText(count, "1 vertex", "%1 vertices");
    count_->setText(reason.isEmpty() ? number : reason);
    select_->setEnabled(reason.isEmpty());
  }

  void selectThem()
  {
    std::vector<Index> all;
    for (const Index row : rows()) {
      const FoundVertices found = findVertices(editor(), *selectionOf(constraint(row)));
      all.insert(all.end(), found.vertices.begin(), found.vertices.end());
    }
    editor().selectVertices(std::move(all));
  }

  QLabel* count_ = nullptr;
  QLabel* how_ = nullptr;
  QPushButton* select_ = nullptr;
};

}  // namespace

Sections newVerticesSections(Editor& editor)
{
  return {new VerticesSection(editor)};
}

}  // namespace holdfast
