#include "holdfast/window/files/start_page.h"

#include <QApplication>
#include <QDir>
#include <QEvent>
#include <QFileInfo>
#include <QPainter>
#include <algorithm>
#include <utility>

#include <holdfast/window/controls/panel_parts.h>
#include <holdfast/window/files/bundled_files.h>
#include <holdfast/window/files/recent_files.h>

namespace holdfast {
namespace {

constexpr int kPageMargin = 28;
constexpr int kGap = 8;
constexpr int kEntryWidth = kRecentPictureSize.width() / 2 + 2 * kGap;

/// In the place of a picture: the format.
QPixmap blankPicture(const QString& path, const QPalette& palette)
{
  QPixmap blank(kRecentPictureSize);
  blank.fill(palette.color(QPalette::Base));
  QPainter painter(&blank);
  painter.setPen(palette.color(QPalette::PlaceholderText));
  painter.drawText(blank.rect(), Qt::AlignCenter, QFileInfo(path).suffix().toUpper());
  return blank;
}

QLabel* newHeading(const QString& text, double size)
{
  auto* label = new QLabel(text);
  QFont font = label->font();
  font.setPointSizeF(font.pointSizeF() * size);
  font.setBold(true);
  label->setFont(font);
  label->setWordWrap(true);
  return label;
}

}  // namespace

Gallery::Gallery() : grid_(new QGridLayout(this))
{
  grid_->setContentsMargins(0, 0, 0, 0);
  grid_->setSpacing(kGap);
}

void Gallery::clear()
{
  for (QToolButton* button : std::exchange(buttons_, {})) delete button;
}

void Gallery::add(const QString& title, const QString& tip, const QPixmap& picture, std::function<void()> open)
{
  auto* button = named(new QToolButton(this), "galleryEntry", title);
  button->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
  button->setAutoRaise(true);
  button->setIconSize(kRecentPictureSize / 2);
  button->setFixedWidth(kEntryWidth);
  button->setIcon(picture);
  button->setText(fontMetrics().elidedText(title, Qt::ElideMiddle, kRecentPictureSize.width() / 2).replace('&', "&&"));
  button->setToolTip(plainTip(tip));
  button->setFocusPolicy(Qt::StrongFocus);
  connect(button, &QToolButton::clicked, this, std::move(open));
  buttons_.push_back(button);
  arrange();
}

QSize Gallery::minimumSizeHint() const
{
  return {kEntryWidth, QWidget::minimumSizeHint().height()};
}

void Gallery::arrange()
{
  const int columns = std::max(1, (width() + kGap) / (kEntryWidth + kGap));
  for (int k = 0; k < static_cast<int>(buttons_.size()); ++k) {
    grid_->removeWidget(buttons_[k]);
    grid_->addWidget(buttons_[k], k / columns, k % columns);
  }
  // What is left over is at the right.
  for (int column = 0; column < grid_->columnCount(); ++column) grid_->setColumnStretch(column, 0);
  grid_->setColumnStretch(columns, 1);
}

void Gallery::resizeEvent(QResizeEvent* event)
{
  arrange();
  QWidget::resizeEvent(event);
}

StartPage::StartPage(Editor& editor, DocumentFiles& files, QWidget* parent)
    : QWidget(parent),
      files_(files),
      recentTitle_(newHeading(tr("Recent"), 1)),
      recent_(named(new Gallery, "recentGallery")),
      examples_(named(new Gallery, "exampleGallery"))
{
  setObjectName("startPage");
  setAutoFillBackground(true);
  setGeometry(parent->rect());
  parent->installEventFilter(this);
  auto* content = new QWidget;
  auto* column = newLayout<QVBoxLayout>(content, kPageMargin, kGap);
  column->addWidget(newHeading(tr("Hold points of a surface exactly where you want them"), 1.4));
  auto* open = named(new QPushButton(tr("&Open…")), "startOpen");
  connect(open, &QPushButton::clicked, &files_, &DocumentFiles::openDialog);
  auto* drop = new QLabel(tr("or drop a mesh or a session (.holdfast) here"));
  drop->setWordWrap(true);
  auto* line = newLayout<QHBoxLayout>(nullptr, 0, 12, {open, drop});
  line->setStretch(1, 1);
  column->addSpacing(kGap);
  column->addLayout(line);
  column->addSpacing(kGap);
  const auto found = examples();
  auto* examplesTitle = newHeading(tr("Examples"), 1);
  examplesTitle->setVisible(!found.empty());
  for (QWidget* widget : std::initializer_list<QWidget*>{recentTitle_, recent_, examplesTitle, examples_})
    column->addWidget(widget);
  column->addStretch(1);
  newLayout<QVBoxLayout>(this, 0, 0, {newScrollArea(content, tr("Start page"))});
  for (const Example& example : found) {
    QImage picture(example.picture);
    // Its left part: the legend is at the right.
    picture = picture.copy(0, 0, picture.width() * 4 / 5, picture.height());
    examples_->add(example.title, QDir::toNativeSeparators(example.mesh),
                   picture.isNull() ? blankPicture(example.mesh, palette()) : QPixmap::fromImage(fitted(picture)),
                   [this, example] { files_.openExample(example); });
  }
  connect(&editor, &Editor::opened, this, [this, &editor] {
    const bool hadKeys = isAncestorOf(QApplication::focusWidget());
    setVisible(!editor.isOpen());
    if (hadKeys && editor.isOpen()) parentWidget()->setFocus();
  });
}

bool StartPage::eventFilter(QObject* watched, QEvent* event)
{
  if (event->type() == QEvent::Resize) setGeometry(parentWidget()->rect());
  return QWidget::eventFilter(watched, event);
}

void StartPage::showEvent(QShowEvent* event)
{
  QWidget::showEvent(event);
  recent_->clear();
  QStringList there = recentFiles();
  there.erase(std::remove_if(there.begin(), there.end(), [](const QString& path) { return !QFileInfo::exists(path); }),
              there.end());
  recentTitle_->setVisible(!there.isEmpty());
  for (const QString& path : there) {
    const QPixmap picture(recentPicture(path));
    recent_->add(QFileInfo(path).fileName(), QDir::toNativeSeparators(path),
                 picture.isNull() ? blankPicture(path, palette()) : picture, [this, path] { files_.open(path); });
  }
}

}  // namespace holdfast
