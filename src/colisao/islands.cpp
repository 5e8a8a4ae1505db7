#include "colisao/islands.hpp"

#include <algorithm>
#include <numeric>

namespace animado::colisao {

namespace {

// Union–find whose root is the lowest member, so that the order of islands is the order of bodies.
class Components {
 public:
  explicit Components(size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }

  int root(int i) {
    while (parent_[static_cast<size_t>(i)] != i) {
      int& up = parent_[static_cast<size_t>(i)];
      up = parent_[static_cast<size_t>(up)];
      i = up;
    }
    return i;
  }
  void join(int i, int j) {
    const int a = root(i), b = root(j);
    parent_[static_cast<size_t>(std::max(a, b))] = std::min(a, b);
  }

 private:
  std::vector<int> parent_;
};

}  // namespace

std::vector<Island> islands(const std::vector<bool>& is_dynamic, std::span<const std::pair<int, int>> links) {
  const auto dynamic = [&](int i) { return static_cast<bool>(is_dynamic[static_cast<size_t>(i)]); };
  Components components(is_dynamic.size());
  std::vector<bool> linked(is_dynamic.size(), false);
  for (const auto& [a, b] : links) {
    linked[static_cast<size_t>(a)] = linked[static_cast<size_t>(b)] = true;
    if (dynamic(a) && dynamic(b)) components.join(a, b);
  }

  std::vector<Island> all;
  std::vector<int> island_of(is_dynamic.size(), -1);
  for (int i = 0; i < static_cast<int>(is_dynamic.size()); ++i) {
    if (!dynamic(i) || !linked[static_cast<size_t>(i)]) continue;
    int& island = island_of[static_cast<size_t>(components.root(i))];
    if (island < 0) {
      island = static_cast<int>(all.size());
      all.emplace_back();
    }
    all[static_cast<size_t>(island)].bodies.push_back(i);
  }
  for (int n = 0; n < static_cast<int>(links.size()); ++n) {
    const auto& [a, b] = links[static_cast<size_t>(n)];
    if (!dynamic(a) && !dynamic(b)) continue;
    const int island = island_of[static_cast<size_t>(components.root(dynamic(a) ? a : b))];
    all[static_cast<size_t>(island)].links.push_back(n);
  }
  return all;
}

}  // namespace animado::colisao
