#pragma once
/// \file
/// What a user does, as events sent to the real widgets, and waiting for what comes of it.

#include <QPointF>
#include <QString>
#include <Qt>
#include <chrono>
#include <functional>
#include <vector>

class QImage;
class QWidget;

namespace holdfast::test {

/// Handles events until `condition` holds. False where it does not within `limit`: the test fails then, nothing hangs.
/// The limit is far beyond what a starved machine takes: with two more programs for each core, and the lowest priority,
/// tests took 15 to 60 times as long as alone.
[[nodiscard]] bool waitUntil(const std::function<bool()>& condition,
                             std::chrono::milliseconds limit = std::chrono::minutes(3));

/// Tells whether nothing behind the picture would be seen through it.
[[nodiscard]] bool isOpaque(const QImage& picture);

/// Shows the widget, and waits for it to be on the screen.
[[nodiscard]] bool showAndWait(QWidget& widget);

/// Mouse events sent to `widget` at places in its own coordinates (Qt's: from the upper left corner).
void moveMouse(QWidget& widget, const QPointF& place, Qt::MouseButtons buttons = Qt::NoButton,
               Qt::KeyboardModifiers modifiers = Qt::NoModifier);
void pressMouse(QWidget& widget, const QPointF& place, Qt::MouseButton button = Qt::LeftButton,
                Qt::KeyboardModifiers modifiers = Qt::NoModifier);
void releaseMouse(QWidget& widget, const QPointF& place, Qt::MouseButton button = Qt::LeftButton,
                  Qt::KeyboardModifiers modifiers = Qt::NoModifier);
/// Moves there, presses and releases.
void click(QWidget& widget, const QPointF& place, Qt::MouseButton button = Qt::LeftButton,
           Qt::KeyboardModifiers modifiers = Qt::NoModifier);
/// The second press of a double click comes as an event of its own.
void doubleClick(QWidget& widget, const QPointF& place, Qt::MouseButton button = Qt::LeftButton,
                 Qt::KeyboardModifiers modifiers = Qt::NoModifier);
/// Presses at the first place, moves through the others, releases at the last.
void drag(QWidget& widget, const std::vector<QPointF>& way, Qt::MouseButton button = Qt::LeftButton,
          Qt::KeyboardModifiers modifiers = Qt::NoModifier);

/// What a keyboard of the United States types with a key; empty for keys of no character.
[[nodiscard]] QString textOf(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier);

/// A key pressed and released, and a text typed, at `widget`.
void pressKey(QWidget& widget, Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier);
void type(QWidget& widget, const char* text);

}  // namespace holdfast::test
