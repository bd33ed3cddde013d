#pragma once
/// Terms of linear combinations.

#include <algorithm>
#include <array>
#include <compare>
#include <initializer_list>
#include <span>
#include <vector>

#include <holdfast/numbers/types.h>

namespace holdfast {

/// `coefficient` times what `index` names: a vertex of a surface point, an unknown of a row, a row of a dependency.
struct Term {
  Index index = 0;
  double coefficient = 0;

  friend bool operator==(const Term&, const Term&) = default;
  friend auto operator<=>(const Term&, const Term&) = default;
};

/// A combination that seldom has more than three terms. Up to three are in place, so that a copy takes no memory
/// elsewhere.
class FewTerms {
 public:
  FewTerms() = default;
  FewTerms(const std::vector<Term>& terms) : FewTerms(std::span(terms)) {}
  FewTerms(std::initializer_list<Term> terms) : FewTerms(std::span(terms.begin(), terms.size())) {}

  [[nodiscard]] std::size_t size() const noexcept { return size_; }
  [[nodiscard]] bool empty() const noexcept { return size_ == 0; }
  [[nodiscard]] const Term* begin() const noexcept { return size_ > few_.size() ? many_.data() : few_.data(); }
  [[nodiscard]] const Term* end() const noexcept { return begin() + size_; }
  [[nodiscard]] const Term& front() const noexcept { return *begin(); }
  [[nodiscard]] const Term& operator[](std::size_t k) const noexcept { return begin()[k]; }
  operator std::vector<Term>() const { return {begin(), end()}; }

  friend bool operator==(const FewTerms& x, const FewTerms& y) { return std::ranges::equal(x, y); }

 private:
  explicit FewTerms(std::span<const Term> terms) : size_(terms.size())
  {
    if (size_ > few_.size())
      many_.assign(terms.begin(), terms.end());
    else
      std::ranges::copy(terms, few_.begin());
  }

  std::array<Term, 3> few_{};
  std::size_t size_ = 0;
  std::vector<Term> many_;  // where there are more
};

}  // namespace holdfast
