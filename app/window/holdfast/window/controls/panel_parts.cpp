#include "holdfast/window/controls/panel_parts.h"

#include <QHeaderView>
#include <QStyle>
#include <QTextDocument>

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

QString plainTip(const QString& text)
{
  return Qt::mightBeRichText(text) ? Qt::convertFromPlainText(text, Qt::WhiteSpaceNormal) : text;
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

Card::Card(QWidget* parent)
    : QFrame(parent),
      icon_(new QLabel),
      title_(newText("cardTitle")),
      text_(newText("cardText")),
      buttons_(new QGridLayout)
{
  setFrameShape(StyledPanel);
  setAutoFillBackground(true);
  setBackgroundRole(QPalette::Base);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(10, 8, 10, 8);
  layout->setSpacing(8);
  layout->addWidget(icon_, 0, Qt::AlignTop);
  auto* column = newLayout<QVBoxLayout>(nullptr, 0, 4, {title_, text_});
  buttons_->setSpacing(6);
  buttons_->setColumnStretch(2, 1);
  column->addLayout(buttons_);
  layout->addLayout(column, 1);
  icon_->setVisible(false);
  for (QLabel* label : {title_, text_}) label->setForegroundRole(QPalette::Text);
}

void Card::setIcon(const QIcon& icon)
{
  const int side = style()->pixelMetric(QStyle::PM_SmallIconSize);
  icon_->setPixmap(icon.pixmap(side, side));
  icon_->setVisible(!icon.isNull());
}

void Card::setText(const QString& text)
{
  text_->setText(text);
  text_->setVisible(!text.isEmpty());
}

QPushButton* Card::addButton(const QString& text, const QString& name)
{
  auto* button = named(new QPushButton(text), name);
  button->setAutoDefault(false);
  const int place = buttons_->count() % 3;
  const int line = buttons_->count() / 3 * 2 + place / 2;
  buttons_->addWidget(button, line, place % 2, 1, place == 2 ? 2 : 1, Qt::AlignLeft);
  return button;
}

CardList::CardList(QWidget* parent) : QScrollArea(parent)
{
  setWidget(new QWidget);
  layout_ = newLayout<QVBoxLayout>(widget(), 8, 8);
  layout_->addStretch(1);
  setWidgetResizable(true);
  setFrameShape(NoFrame);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
}

}  // namespace holdfast
