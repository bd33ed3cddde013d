#include "holdfast/window/files/picture_dialog.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QSpinBox>
#include <QVBoxLayout>

#include <holdfast/window/controls/panel_parts.h>

namespace holdfast {
namespace {

constexpr PictureSize kUsualSize{1920, 1200};

constexpr const char* kWidthKey = "picture/width";
constexpr const char* kHeightKey = "picture/height";
constexpr const char* kLegendKey = "picture/legend";

QSpinBox* sideBox(const char* key, int usual)
{
  auto* box = new QSpinBox;
  box->setRange(kLeastPictureSide, kLargestPictureSide);
  box->setValue(QSettings().value(key, usual).toInt());
  box->setSingleStep(10);
  box->setAccelerated(true);
  box->setSuffix(PictureDialog::tr(" px"));
  return box;
}

}  // namespace

PictureDialog::PictureDialog(QWidget* parent)
    : QDialog(parent),
      width_(sideBox(kWidthKey, kUsualSize.width)),
      height_(sideBox(kHeightKey, kUsualSize.height)),
      legend_(new QCheckBox(tr("With a &legend of the colours")))
{
  setObjectName("pictureDialog");
  setWindowTitle(tr("Export a picture"));
  width_->setObjectName("width");
  height_->setObjectName("height");
  legend_->setObjectName("legend");
  legend_->setChecked(QSettings().value(kLegendKey, true).toBool());

  auto* form = new QFormLayout;
  form->addRow(tr("&Width"), width_);
  form->addRow(tr("&Height"), height_);
  form->addRow(QString(), legend_);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
  QPushButton* go = named(buttons->addButton(tr("&Export…"), QDialogButtonBox::AcceptRole), "export");
  go->setDefault(true);
  buttons->button(QDialogButtonBox::Cancel)->setAutoDefault(false);
  connect(buttons, &QDialogButtonBox::accepted, this, &PictureDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);

  auto* layout = new QVBoxLayout(this);
  layout->setSizeConstraint(QLayout::SetFixedSize);
  layout->setSpacing(2 * layout->spacing());
  layout->addWidget(new QLabel(tr("The picture is drawn from where you look at the mesh now.")));
  layout->addLayout(form);
  layout->addWidget(buttons);
  width_->setFocus();
  width_->selectAll();
}

PictureSize PictureDialog::size() const
{
  return {width_->value(), height_->value()};
}

Legend PictureDialog::legend() const
{
  return legend_->isChecked() ? Legend::Shown : Legend::Hidden;
}

void PictureDialog::accept()
{
  QSettings settings;
  settings.setValue(kWidthKey, width_->value());
  settings.setValue(kHeightKey, height_->value());
  settings.setValue(kLegendKey, legend_->isChecked());
  QDialog::accept();
}

}  // namespace holdfast
