#include "holdfast/window/controls/card.h"

#include <QHBoxLayout>
#include <QIcon>
#include <QStyle>

#include <holdfast/window/controls/panel_parts.h>

namespace holdfast {

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
