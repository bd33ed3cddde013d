#include "holdfast/window/window/preferences_dialog.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLineEdit>

#include <holdfast/document/session_file.h>
#include <holdfast/window/controls/panel_parts.h>

namespace holdfast {
namespace {

/// The choice of a menu as a box, which follows the menu.
QComboBox* newChoice(QActionGroup& group)
{
  const QString title = group.objectName();
  auto* box = named(new QComboBox, group.actions().front()->objectName() + "Choice", title);
  for (const QAction* action : group.actions()) box->addItem(action->text().remove('&'));
  const auto follow = [box, &group] { box->setCurrentIndex(group.actions().indexOf(group.checkedAction())); };
  follow();
  QObject::connect(&group, &QActionGroup::triggered, box, follow);
  QObject::connect(box, qOverload<int>(&QComboBox::activated), box,
                   [&group](int choice) { group.actions()[choice]->trigger(); });
  return box;
}

// The number of decimals that stands for none.
constexpr int kSignificantDigits = -1;

/// "0.001" of three decimals.
QString exampleOf(int decimals)
{
  return decimals == 0 ? QString("1") : QString("0.%1").arg(1, decimals, 10, QChar('0'));
}

QComboBox* newDecimals(const Preferences& preferences)
{
  auto* box = named(new QComboBox, "decimals");
  box->addItem(QObject::tr("four significant digits"), kSignificantDigits);
  for (int decimals = 0; decimals <= kMostLengthDecimals; ++decimals) box->addItem(exampleOf(decimals), decimals);
  box->setCurrentIndex(box->findData(preferences.decimals.value_or(kSignificantDigits)));
  box->setToolTip(QObject::tr("The last digit of lengths that are shown. Tool tips have all digits"));
  QObject::connect(box, qOverload<int>(&QComboBox::activated), box, [box, set = preferences.setDecimals] {
    const int decimals = box->currentData().toInt();
    set(decimals == kSignificantDigits ? std::nullopt : std::optional(decimals));
  });
  return box;
}

}  // namespace

QDialog* newPreferencesDialog(const Preferences& preferences, QWidget* window)
{
  auto* dialog = named(new QDialog(window), "preferencesDialog");
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(QObject::tr("Preferences"));
  auto* form = new QFormLayout;
  for (QActionGroup* group : preferences.choices) form->addRow(group->objectName(), newChoice(*group));
  auto* unit = named(new QLineEdit(preferences.unit), "unit");
  unit->setPlaceholderText(QObject::tr("none"));
  unit->setToolTip(QObject::tr("Stands beside lengths of this document, and of meshes that are opened later"));
  form->addRow(QObject::tr("Unit of &length"), unit);
  QObject::connect(unit, &QLineEdit::editingFinished, unit,
                   [unit, set = preferences.setUnit] { set(unit->text().simplified()); });
  QComboBox* decimals = newDecimals(preferences);
  form->addRow(QObject::tr("&Digits of lengths"), decimals);

  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
  QPushButton* reset = named(buttons->addButton(preferences.reset->text(), QDialogButtonBox::ResetRole), "reset");
  reset->setToolTip(preferences.reset->toolTip());
  // Enter in the line takes what was typed, and closes nothing.
  for (QPushButton* button : {reset, buttons->button(QDialogButtonBox::Close)}) button->setAutoDefault(false);
  QObject::connect(reset, &QPushButton::clicked, preferences.reset, &QAction::trigger);
  QObject::connect(reset, &QPushButton::clicked, unit, &QLineEdit::clear);
  QObject::connect(reset, &QPushButton::clicked, decimals, [decimals] { decimals->setCurrentIndex(0); });
  QObject::connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::reject);
  auto* layout = newLayout<QVBoxLayout>(dialog, 16, 16);
  layout->addLayout(form);
  layout->addWidget(buttons);
  return dialog;
}

}  // namespace holdfast
