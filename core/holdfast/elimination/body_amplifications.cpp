#include "holdfast/elimination/body_amplifications.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <span>

#include <holdfast/elimination/block_elimination.h>

namespace holdfast {
namespace {

double rootOfSize(const Bodies& bodies, Index body)
{
  return std::sqrt(static_cast<double>(bodies.sizeOf(body)));
}

/// The rows of a component of contracted rows, over the coordinates w_b = sqrt(n_b) v_b of its bodies: |w| is the
/// length over all unknowns.
class ScaledComponent {
 public:
  ScaledComponent(const RowComponent& component, const std::vector<RowTerms>& contracted, const Bodies& bodies)
      : rows_(scaledRows(component, contracted, bodies)),
        elimination_(rows_, allRows(), static_cast<Index>(component.unknowns.size()),
                     std::vector<bool>(component.unknowns.size(), false))
  {
  }

  [[nodiscard]] std::vector<double> amplifications() const { return elimination_.amplifications(rows_.size()); }

  /// What the rows have at the body of this place in the component, by their places.
  [[nodiscard]] RowTerms column(Index place) const
  {
    RowTerms result;
    for (std::size_t k = 0; k < rows_.size(); ++k)
      for (const PointTerm& term : rows_[k])
        if (term.vertex == place) result.push_back({static_cast<Index>(k), term.weight});
    return result;
  }

  /// The shortest w for which the rows of these places have these values, and all others 0.
  [[nodiscard]] Eigen::VectorXd shortest(const RowTerms& values) const
  {
    Columns3 d = Columns3::Zero(static_cast<Index>(rows_.size()), 3);
    for (const PointTerm& value : values) d(value.vertex, 0) = value.weight;
    return elimination_.particular(d).col(0);
  }

 private:
  static std::vector<RowTerms> scaledRows(const RowComponent& component, const std::vector<RowTerms>& contracted,
                                          const Bodies& bodies)
  {
    std::vector<RowTerms> result;
    for (const Index row : component.rows) {
      RowTerms terms = contracted[row];
      for (auto& [body, weight] : terms) {
        weight /= rootOfSize(bodies, body);
        body =
            std::lower_bound(component.unknowns.begin(), component.unknowns.end(), body) - component.unknowns.begin();
      }
      result.push_back(std::move(terms));
    }
    return result;
  }

  [[nodiscard]] std::vector<Index> allRows() const
  {
    std::vector<Index> result(rows_.size());
    std::iota(result.begin(), result.end(), Index{0});
    return result;
  }

  std::vector<RowTerms> rows_;
  BlockElimination elimination_;
};

/// By difference row: what a unit of it is in the rows of a component, by their places, where only the unknowns that
/// hang on it move.
std::map<Index, RowTerms> valuesByDifference(const RowComponent& component, const std::vector<RowTerms>& rows,
                                             const Bodies& bodies)
{
  std::map<Index, RowTerms> result;
  for (std::size_t k = 0; k < component.rows.size(); ++k)
    for (const Partner& difference : bodies.combinationOf(rows[component.rows[k]]))
      result[difference.row].push_back({static_cast<Index>(k), difference.coefficient});
  return result;
}

/// A difference row moves the s of n unknowns that hang on it against the others, about the centroid of their body.
double spread(const Bodies::Link& link, const Bodies& bodies)
{
  const auto n = static_cast<double>(bodies.sizeOf(bodies.bodyOf(link.unknown)));
  const auto s = static_cast<double>(link.hanging);
  return std::sqrt(s * (n - s) / n);
}

/// The rows of one component, and the difference rows of its bodies.
void amplifyComponent(std::vector<double>& amplifications, const RowComponent& component,
                      const std::vector<RowTerms>& rows, const std::vector<RowTerms>& contracted, const Bodies& bodies)
{
  const ScaledComponent scaled(component, contracted, bodies);
  const std::vector<double> ofRows = scaled.amplifications();
  for (std::size_t k = 0; k < ofRows.size(); ++k)
    amplifications[component.rows[k]] = std::max(amplifications[component.rows[k]], ofRows[k]);

  // Where a difference row changes, bodies have to move as well, so that the other rows stay met.
  const std::map<Index, RowTerms> values = valuesByDifference(component, rows, bodies);
  for (std::size_t b = 0; b < component.unknowns.size(); ++b) {
    const std::span<const Bodies::Link> links = bodies.linksOf(component.unknowns[b]);
    if (links.empty()) continue;
    const Eigen::VectorXd centroid =
        scaled.shortest(scaled.column(static_cast<Index>(b))) / rootOfSize(bodies, component.unknowns[b]);
    const double length = centroid.norm();
    for (const Bodies::Link& link : links) {
      const auto s = static_cast<double>(link.hanging);
      const auto own = values.find(link.row);
      const double moved =
          own == values.end() ? s * length : (scaled.shortest(own->second) - link.sign * s * centroid).norm();
      amplifications[link.row] = std::hypot(spread(link, bodies), moved);
    }
  }
}

}  // namespace

void amplifyBodies(std::vector<double>& amplifications, const std::vector<RowTerms>& rows,
                   const std::vector<RowTerms>& contracted, const std::vector<Index>& others, const Bodies& bodies)
{
  for (Index body = 0; body < bodies.count(); ++body)
    for (const Bodies::Link& link : bodies.linksOf(body)) amplifications[link.row] = spread(link, bodies);
  std::vector<RowTerms> left(rows.size());
  for (const Index row : others) left[row] = contracted[row];
  for (const RowComponent& component : connectedRows(left, bodies.count()))
    if (std::any_of(component.unknowns.begin(), component.unknowns.end(),
                    [&](Index body) { return bodies.sizeOf(body) > 1; }))
      amplifyComponent(amplifications, component, rows, contracted, bodies);
}

}  // namespace holdfast
