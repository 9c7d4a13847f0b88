#include "core/toolpath/chain.h"

#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/index/rtree.hpp>

#include <map>

namespace arris::toolpath {
namespace {

namespace bgi = boost::geometry::index;
using geometry::Point;
using TreePoint = boost::geometry::model::d2::point_xy<double>;
using Entry = std::pair<TreePoint, std::size_t>;
using Tree = bgi::rtree<Entry, bgi::quadratic<16>>;

/// Which chains must be done before others, and which may come next.
class Queue {
public:
  Queue(const std::vector<Chain>& chains, const std::vector<pattern::Contour>& contours) : m_chains(chains) {
    for (const pattern::Contour& contour : contours) {
      m_parents[contour.id] = contour.kind == pattern::ContourKind::CutOut ? contour.parent : 0;
    }
    for (const Chain& chain : chains) {
      ++m_cutOutsLeft[m_parents[chain.contour]];
    }
    for (std::size_t i = 0; i < chains.size(); ++i) {
      if (m_cutOutsLeft[chains[i].contour] == 0) {
        m_ready.insert(entry(i));
      } else {
        m_waiting[chains[i].contour].push_back(i);
      }
    }
  }

  [[nodiscard]] bool empty() const {
    return m_ready.empty();
  }

  /// Takes out the chain that starts nearest to `from`.
  std::size_t takeNearest(const Point& from) {
    const Entry nearest = *m_ready.qbegin(bgi::nearest(TreePoint(from.x(), from.y()), 1));
    m_ready.remove(nearest);
    const int parent = m_parents[m_chains[nearest.second].contour];
    if (--m_cutOutsLeft[parent] == 0) {
      for (const std::size_t freed : m_waiting[parent]) {
        m_ready.insert(entry(freed));
      }
    }
    return nearest.second;
  }

private:
  [[nodiscard]] Entry entry(std::size_t chain) const {
    const Point start = geometry::startPoint(m_chains[chain].segments.front().shape);
    return {TreePoint(start.x(), start.y()), chain};
  }

  const std::vector<Chain>& m_chains;
  std::map<int, int> m_parents;                      ///< outline in which a cut-out lies, by contour; 0 for outlines
  std::map<int, int> m_cutOutsLeft;                  ///< chains along cut-outs to come, by outline
  std::map<int, std::vector<std::size_t>> m_waiting; ///< chains along outlines whose cut-outs are not done
  Tree m_ready;
};

} // namespace

std::vector<std::size_t> orderOfChains(const std::vector<Chain>& chains, const std::vector<pattern::Contour>& contours,
                                       const Point& park) {
  Queue queue(chains, contours);
  std::vector<std::size_t> order;
  order.reserve(chains.size());
  for (Point at = park; !queue.empty(); at = geometry::endPoint(chains[order.back()].segments.back().shape)) {
    order.push_back(queue.takeNearest(at));
  }
  return order;
}

} // namespace arris::toolpath
