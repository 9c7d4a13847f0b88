#include "core/job/contour_numbers.h"

#include <algorithm>
#include <map>

namespace arris::job {
namespace {

/// New numbers by old ones.
std::map<int, int> numbersAsMachined(const Job& job) {
  std::map<int, int> numbers;
  const auto add = [&numbers](int id) { numbers.emplace(id, static_cast<int>(numbers.size()) + 1); };
  for (const toolpath::Chain& chain : job.toolpath.chains) {
    add(chain.contour);
  }
  for (const pattern::Contour& contour : job.contours) {
    add(contour.id);
  }
  return numbers;
}

} // namespace

void numberContoursAsMachined(Job& job) {
  const std::map<int, int> numbers = numbersAsMachined(job);
  const auto renumber = [&numbers](int& id) {
    const auto number = numbers.find(id);
    id = number != numbers.end() ? number->second : id;
  };
  std::vector<pattern::Contour> contours(job.contours.size());
  std::vector<double> unground(job.toolpath.unground.size());
  for (std::size_t i = 0; i < job.contours.size(); ++i) {
    const auto place = static_cast<std::size_t>(numbers.at(job.contours[i].id) - 1);
    contours[place] = std::move(job.contours[i]);
    renumber(contours[place].id);
    renumber(contours[place].parent);
    if (i < job.toolpath.unground.size()) {
      unground[place] = job.toolpath.unground[i];
    }
  }
  job.contours = std::move(contours);
  job.toolpath.unground = std::move(unground);
  for (toolpath::Chain& chain : job.toolpath.chains) {
    renumber(chain.contour);
  }
  for (toolpath::Corner& corner : job.toolpath.corners) {
    renumber(corner.contour);
  }
  for (base::Problems* problems : {&job.problems, &job.toolpath.problems}) {
    for (base::Problem& problem : *problems) {
      if (problem.contour) {
        renumber(*problem.contour);
      }
    }
  }
}

} // namespace arris::job
