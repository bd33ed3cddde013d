#include "holdfast/window/text/constraint_text.h"

#include <QObject>
#include <QStringList>
#include <algorithm>
#include <array>

#include <holdfast/mesh/labels.h>
#include <holdfast/window/text/number_text.h>
#include <holdfast/words/printable.h>

namespace holdfast {
namespace {

constexpr std::size_t kPartsInWords = 3;
constexpr std::size_t kWeightsInWords = 6;
constexpr std::size_t kNamesInWords = 5;

struct LocationText {
  QString operator()(const AtVertex& at) const { return QObject::tr("vertex %1").arg(at.vertex); }
  QString operator()(const AtEdge& at) const
  {
    return QObject::tr("edge %1–%2, t %3").arg(QString::number(at.i), QString::number(at.j), roundedText(at.t));
  }
  QString operator()(const AtFace& at) const
  {
    QStringList weights;
    for (std::size_t k = 0; k < std::min(at.weights.size(), kWeightsInWords); ++k)
      weights << roundedText(at.weights[k]);
    if (at.weights.size() > kWeightsInWords) weights << QStringLiteral("…");
    return QObject::tr("face %1: %2").arg(QString::number(at.face), weights.join(", "));
  }
  QString operator()(const AtNear& at) const { return QObject::tr("near %1").arg(roundedText(at.place)); }
};

struct SelectionText {
  QString operator()(const VertexIds& vertices) const
  {
    return countText(static_cast<Index>(vertices.ids.size()), "1 vertex", "%1 vertices");
  }
  QString operator()(const InBox& /*box*/) const { return QObject::tr("box"); }
  QString operator()(const InSphere& sphere) const
  {
    return QObject::tr("sphere of radius %1").arg(roundedText(sphere.radius));
  }
  QString operator()(const InHalfSpace& /*half*/) const { return QObject::tr("half space"); }
  QString operator()(const InComponent& part) const { return QObject::tr("part %1").arg(part.component); }
  QString operator()(const InsideCurve& curve) const
  {
    return curve.side == CurveSide::Smaller
               ? countText(static_cast<Index>(curve.through.size()), "curve", "curve through %1 places")
               : countText(static_cast<Index>(curve.through.size()), "outside a curve",
                           "outside a curve through %1 places");
  }
  QString operator()(const AllOf& all) const
  {
    return joined(all.parts, QObject::tr(" and "), QObject::tr("everything"));
  }
  QString operator()(const AnyOf& any) const { return joined(any.parts, QObject::tr(" or "), QObject::tr("nothing")); }
  QString operator()(const NotIn& no) const { return QObject::tr("not %1").arg(inner(*no.part)); }
  QString operator()(const Grown& grown) const
  {
    return QObject::tr("%1 with %2").arg(inner(*grown.part), countText(grown.rings, "1 ring", "%1 rings"));
  }

 private:
  // Describes one level in words, and deeper levels by their kind only.
  static QString inner(const Selection& selection)
  {
    if (std::holds_alternative<AllOf>(selection.what)) return QObject::tr("(several at once)");
    if (std::holds_alternative<AnyOf>(selection.what)) return QObject::tr("(any of several)");
    if (std::holds_alternative<NotIn>(selection.what)) return QObject::tr("(all but some)");
    if (std::holds_alternative<Grown>(selection.what)) return QObject::tr("(some with rings)");
    return selectionText(selection);
  }

  static QString joined(const std::vector<Selection>& parts, const QString& glue, const QString& ofNone)
  {
    if (parts.empty()) return ofNone;
    QStringList words;
    for (std::size_t k = 0; k < std::min(parts.size(), kPartsInWords); ++k) words << inner(parts[k]);
    if (parts.size() > kPartsInWords)
      words << countText(static_cast<Index>(parts.size() - kPartsInWords), "1 more", "%1 more");
    return words.join(glue);
  }
};

QString endsOf(const QString& text, int letters)
{
  if (text.size() <= letters) return text;
  const int ofEnd = (letters - 1) / 2;
  return text.left(letters - 1 - ofEnd) + QStringLiteral("…") + text.right(ofEnd);
}

}  // namespace

QString kindText(const Constraint& constraint)
{
  return typeName(constraint);
}

QString locationText(const SurfaceLocation& location)
{
  return std::visit(LocationText{}, location);
}

QString labelText(const Mesh& mesh, const SurfaceLocation& location)
{
  std::string text;
  if (const auto* vertex = std::get_if<AtVertex>(&location)) text = labelText(mesh.labels.vertices, vertex->vertex);
  if (const auto* face = std::get_if<AtFace>(&location)) text = labelText(mesh.labels.faces, face->face);
  return QString::fromStdString(text);
}

QString selectionText(const Selection& selection)
{
  return std::visit(SelectionText{}, selection.what);
}

QString whereText(const Constraint& constraint)
{
  if (const Selection* selection = selectionOf(constraint)) return selectionText(*selection);
  QStringList places;
  for (const SurfaceLocation& at : placesOf(constraint)) places << locationText(at);
  return places.join(QObject::tr(" to "));
}

QString statusText(std::optional<ConstraintStatus> status)
{
  if (!status) return QObject::tr("not solved");
  return toText(name(*status));
}

QString statusMeaning(std::optional<ConstraintStatus> status)
{
  // In the order of `ConstraintStatus`.
  constexpr std::array kMeanings{"Earlier constraints neither imply nor contradict it; nothing was solved.",
                                 "It holds.",
                                 "It holds already: earlier constraints imply it, or nothing moves it.",
                                 "Earlier constraints contradict it; it is left out where they do.",
                                 "It is part of the solution, but holds only approximately.",
                                 "It is disabled."};
  return QObject::tr(status ? kMeanings[static_cast<std::size_t>(*status)]
                            : "Nothing was solved with this constraint yet.");
}

QString quoted(const std::string& name)
{
  return QStringLiteral("“%1”").arg(nameText(name));
}

QString nameText(const std::string& name)
{
  return QString::fromStdString(shortened(name));
}

QString quotedEnds(const std::string& name, const std::vector<std::string>& others, int letters)
{
  const QString own = QString::fromStdString(printable(name));
  const auto readsTheSame = [&](const std::string& other) {
    return other != name && endsOf(QString::fromStdString(printable(other)), letters) == endsOf(own, letters);
  };
  while (letters < own.size() && std::ranges::any_of(others, readsTheSame)) ++letters;
  return QStringLiteral("“%1”").arg(endsOf(own, letters));
}

QString quotedList(const std::vector<std::string>& names)
{
  QStringList words;
  for (std::size_t k = 0; k < std::min(names.size(), kNamesInWords); ++k) words << quoted(names[k]);
  if (names.size() > kNamesInWords) words << countText(names.size() - kNamesInWords, "1 other", "%1 others");
  if (words.size() < 2) return words.join(QString());
  const QString last = words.takeLast();
  return QObject::tr("%1 and %2").arg(words.join(", "), last);
}

}  // namespace holdfast
