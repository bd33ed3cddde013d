#include <QGuiApplication>
#include <QScreen>

#include <fmt/format.h>

#include <holdfast/window/controls/theme.h>

#include "chapters.h"

namespace holdfast::tour {
namespace {

/// A point selected, a probe, a ruler and a saved selection; the panels that are about them.
void bracket(TourWindow& tour, const std::string& look)
{
  tour.open("bracket.obj", "bracket.constraints.json");
  tour.trigger("frameAll");
  tour.raise("constraintsDock");
  tour.raise("inspectorDock");
  tour.clickVertices("toolRuler", {Vector3(-60, -30, 80), Vector3(60, -30, 80)});
  tour.clickVertices("toolProbe", {Vector3(0, -30, 70)});
  tour.clickVertices("toolFlood", {Vector3(20, 10, 12)});
  tour.trigger("saveSelection");
  tour.trigger("deselect");
  tour.trigger("toolSelect");
  tour.raise("measuredDock");
  tour.picture(look + "_selections_and_measured");
  tour.raise("constraintsDock");
  tour.raise("inspectorDock");
  tour.select("flange east");
  tour.picture(look + "_selected_point");
}

void panels(TourWindow& tour, const std::string& look)
{
  tour.open("bracket.obj", "bracket.conflict.constraints.json");
  tour.trigger("frameAll");
  tour.raise("conflictsDock");
  tour.raise("colorsDock");
  tour.picture(look + "_conflicts_and_colours");
  tour.open("bar.obj", "bar.twist_360.constraints.json");
  tour.trigger("frameAll");
  tour.raise("sphereDock");
  tour.raise("reportDock");
  tour.picture(look + "_rotations_and_solution");
  tour.raise("histogramDock");
  tour.raise("findingsDock");
  tour.picture(look + "_distributions_and_mesh");
  tour.raise("constraintsDock");
  tour.raise("inspectorDock");
  tour.select("top");
  tour.picture(look + "_selected_handle");
  tour.trigger("close");
  tour.picture(look + "_start_page");
}

}  // namespace

void sizes(TourWindow& tour)
{
  for (const QSize size : {QSize(1024, 700), QGuiApplication::primaryScreen()->size()}) {
    tour.resize(size.width(), size.height());
    for (const auto& [appearance, name] :
         {std::pair(Appearance::Light, "light"), std::pair(Appearance::Dark, "dark")}) {
      apply(appearance);
      const std::string look = fmt::format("{}x{}_{}", size.width(), size.height(), name);
      bracket(tour, look);
      panels(tour, look);
    }
  }
  apply(Appearance::Light);
}

}  // namespace holdfast::tour
