#include "holdfast/window/window/help_dialog.h"

#include <QDialogButtonBox>
#include <QGridLayout>
#include <QLabel>
#include <QVBoxLayout>
#include <array>

namespace holdfast {
namespace {

struct Gesture {
  QString what;
  QString how;
};

}  // namespace

HelpDialog::HelpDialog(QWidget* parent) : QDialog(parent)
{
  setObjectName("helpDialog");
  setWindowTitle(tr("Ten gestures"));
  const std::array gestures{
      Gesture{tr("Turn the picture"), tr("Drag with the right button, or beside what the tool takes")},
      Gesture{tr("Shift it, go nearer"), tr("Drag with the middle button; turn the wheel")},
      Gesture{tr("Hold a point exactly"), tr("P, then click a vertex, an edge or a face; V, E and F choose which. "
                                             "K and two clicks keep the vector between two points")},
      Gesture{tr("Move it"),
              tr("Drag an arrow or a square of what is selected; Ctrl snaps; a typed number counts exactly")},
      Gesture{tr("Select a region"), tr("B paints, M draws a rectangle, L a line around, W takes a whole side; "
                                        "Shift adds, Ctrl takes away")},
      Gesture{tr("Say what it does"), tr("F fixes the region, H makes a handle, R a rigid feature")},
      Gesture{tr("Turn a handle"),
              tr("Drag one of its rings, as many times round as you like, or type degrees over it")},
      Gesture{tr("Draw around a feature"), tr("C, click places around it, Enter; then R keeps it rigid")},
      Gesture{tr("Measured points"), tr("Ctrl+I imports a list, and shows how far each lay from the surface")},
      Gesture{tr("Take it back"), tr("Escape during a drag; Ctrl+Z afterwards")}};
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(24);
  grid->setVerticalSpacing(8);
  grid->setColumnStretch(1, 1);
  int row = 0;
  for (const Gesture& gesture : gestures) {
    auto* what = new QLabel(QString("<b>%1</b>").arg(gesture.what), this);
    auto* how = new QLabel(gesture.how, this);
    how->setWordWrap(true);
    how->setMinimumWidth(380);
    grid->addWidget(what, row, 0, Qt::AlignTop);
    grid->addWidget(how, row, 1, Qt::AlignTop);
    ++row;
  }
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(20, 18, 20, 14);
  layout->setSpacing(16);
  layout->addLayout(grid);
  layout->addWidget(buttons);
}

}  // namespace holdfast
