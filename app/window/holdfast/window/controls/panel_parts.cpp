#include "holdfast/window/controls/panel_parts.h"

#include <QHeaderView>
#include <QVBoxLayout>

#include <holdfast/window/controls/status_style.h>

namespace holdfast {

QLabel* newText(const QString& name)
{
  auto* label = named(new QLabel, name);
  label->setWordWrap(true);
  label->setTextFormat(Qt::PlainText);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  return label;
}

QScrollArea* newScrollArea(QWidget* content, const QString& spoken)
{
  auto* area = new QScrollArea;
  area->setAccessibleName(spoken);
  area->setWidget(content);
  area->setWidgetResizable(true);
  area->setFrameShape(QFrame::NoFrame);
  return area;
}

void setQuiet(QWidget& text, bool isQuiet)
{
  QPalette own = text.parentWidget()->palette();
  if (isQuiet) own.setColor(QPalette::WindowText, quietColor(own));
  text.setPalette(own);
}

void fill(QWidget& panel, QWidget* content)
{
  newLayout<QVBoxLayout>(&panel, 0, 0, {content});
}

void setTableLook(QTableView& table)
{
  table.setAlternatingRowColors(true);
  table.setShowGrid(false);
  table.setWordWrap(false);
  table.setTabKeyNavigation(false);
  table.verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
  table.verticalHeader()->setDefaultSectionSize(table.fontMetrics().height() * 3 / 2);
  table.verticalHeader()->setHighlightSections(false);
  table.horizontalHeader()->setHighlightSections(false);
}

void showRefusal(QLabel& label, const QString& reason)
{
  QPalette own = label.parentWidget()->palette();
  own.setColor(QPalette::WindowText, statusColor(ConstraintStatus::Conflicting, own));
  label.setPalette(own);
  label.setText(reason);
  label.setVisible(true);
}

HintedContent::HintedContent(QWidget* content, const QString& hintName) : hint_(named(new QLabel, hintName))
{
  hint_->setWordWrap(true);
  hint_->setAlignment(Qt::AlignCenter);
  hint_->setMargin(12);
  addWidget(hint_);
  addWidget(content);
}

void HintedContent::showHint(const QString& hint)
{
  hint_->setText(hint);
  setCurrentIndex(0);
}

void RefreshedPanel::showEvent(QShowEvent* event)
{
  refresh();
  QWidget::showEvent(event);
}

}  // namespace holdfast
