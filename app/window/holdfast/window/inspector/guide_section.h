#pragma once
/// A section of constraints that keep something on a plane, a line or another mesh.

#include <QFileInfo>

#include <holdfast/window/inspector/inspector_section.h>
#include <holdfast/words/error.h>

namespace holdfast {

/// Sets one number of a direction. Throws `InputError` where nothing but zeros is left.
inline void setDirection(Vector3& direction, int axis, double number)
{
  direction[axis] = number;
  if (direction.isZero(0))
    throw InputError({}, "a direction cannot be zero in x, y and z; type the new direction first, then this 0");
}

/// `On` is the member that holds an `OnPlane`, an `OnLine` or something else.
template <class What, auto On>
class GuideSection : public SectionOf<What> {
 public:
  using SectionOf<What>::SectionOf;

 protected:
  /// Adds fields for the normal and the offset of planes, for the direction of lines and for meshes. Their names begin
  /// with `prefix`.
  void bindGuides(const QString& prefix)
  {
    this->bindVector(QObject::tr("&Normal"), prefix + "Normal", ofGuide(&OnPlane::normal),
                     QObject::tr("rotate the plane of %1 to %2 = %3"), [](What& what, int axis, double number) {
                       setDirection(std::get<OnPlane>(what.*On).normal, axis, number);
                     });
    this->bindNumber(QObject::tr("&Offset"), prefix + "Offset", ofGuide(&OnPlane::offset),
                     QObject::tr("offset the plane of %1 by %2"),
                     [](What& what, double number) { std::get<OnPlane>(what.*On).offset = number; });
    this->bindVector(QObject::tr("&Along"), prefix + "Direction", ofGuide(&OnLine::direction),
                     QObject::tr("rotate the line of %1 to %2 = %3"), [](What& what, int axis, double number) {
                       setDirection(std::get<OnLine>(what.*On).direction, axis, number);
                     });
    QLabel* mesh = this->addText(QObject::tr("Mesh"), prefix + "Mesh");
    this->addRefresh([=, this] {
      const OnMesh* on = std::get_if<OnMesh>(&(this->what().*On));
      this->setFieldVisible(mesh, on != nullptr);
      if (on == nullptr) return;
      mesh->setText(QFileInfo(QString::fromStdString(on->path)).fileName());
      mesh->setToolTip(QString::fromStdString(on->path));
    });
  }

  /// Asks for a mesh that the constraints are to stay on.
  void askForMesh() { Q_EMIT this->editor().guideMeshWanted(this->rows()); }

  /// Returns the point that a plane or a line leads through, if it has one; null for anything else.
  static std::optional<Vector3>* throughOf(What& what)
  {
    if (auto* plane = std::get_if<OnPlane>(&(what.*On))) return &plane->point;
    if (auto* line = std::get_if<OnLine>(&(what.*On))) return &line->point;
    return nullptr;
  }

 private:
  /// Reads a member of a plane or a line; nothing from what is on none.
  template <class Guide, class Member>
  static auto ofGuide(Member Guide::*member)
  {
    return [=](const What& what) -> std::optional<Member> {
      const Guide* guide = std::get_if<Guide>(&(what.*On));
      return guide == nullptr ? std::nullopt : std::optional(guide->*member);
    };
  }
};

}  // namespace holdfast
