#include "holdfast/window/controls/labels.h"

#include <QLabel>

namespace holdfast {
namespace {

QLabel* newWrapped(const QString& objectName)
{
  auto* label = new QLabel;
  label->setObjectName(objectName);
  label->setWordWrap(true);
  return label;
}

}  // namespace

QLabel* newHint(const QString& objectName)
{
  QLabel* label = newWrapped(objectName);
  label->setAlignment(Qt::AlignCenter);
  label->setMargin(12);
  return label;
}

QLabel* newText(const QString& objectName)
{
  QLabel* label = newWrapped(objectName);
  label->setTextFormat(Qt::PlainText);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  return label;
}

}  // namespace holdfast
