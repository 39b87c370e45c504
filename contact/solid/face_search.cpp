// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/solid/face_search.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace parison::contact {

using core::Index;
using core::Vector3;

SpaceBox box_around(const std::vector<Vector3>& nodes, const core::QuadFace& face, double widened) {
  SpaceBox box{nodes[face.nodes[0]], nodes[face.nodes[0]]};
  for (const Index node : face.nodes) {
    box.low = box.low.cwiseMin(nodes[node]);
    box.high = box.high.cwiseMax(nodes[node]);
  }
  return {box.low.array() - widened, box.high.array() + widened};
}

BoxSearch::BoxSearch(std::vector<SpaceBox> boxes) : boxes_(std::move(boxes)) {
  constexpr Index most_bins = 128;  // along one direction
  SpaceBox all = boxes_.empty() ? SpaceBox{Vector3::Zero(), Vector3::Zero()} : boxes_.front();
  double extent = 0;
  for (const SpaceBox& box : boxes_) {
    all = {all.low.cwiseMin(box.low), all.high.cwiseMax(box.high)};
    extent += (box.high - box.low).maxCoeff() / static_cast<double>(boxes_.size());
  }
  low_ = all.low;
  size_ = std::max(extent, (all.high - all.low).maxCoeff() / most_bins);
  if (!(size_ > 0)) size_ = 1;
  for (int k = 0; k < 3; ++k) count_[k] = static_cast<Index>((all.high[k] - all.low[k]) / size_) + 1;
  start_.assign(static_cast<std::size_t>(count_[0] * count_[1] * count_[2] + 1), 0);
  for (const SpaceBox& box : boxes_) for_each_bin(box, [&](Index bin) { ++start_[bin + 1]; });
  std::partial_sum(start_.begin(), start_.end(), start_.begin());
  listed_.resize(static_cast<std::size_t>(start_.back()));
  std::vector<Index> next(start_.begin(), start_.end() - 1);
  for (std::size_t i = 0; i < boxes_.size(); ++i)
    for_each_bin(boxes_[i], [&](Index bin) { listed_[next[bin]++] = static_cast<Index>(i); });
}

BoxSearch::Bin BoxSearch::bin_at(const Vector3& x) const {
  Bin bin;
  for (int k = 0; k < 3; ++k)
    bin[k] = static_cast<Index>(std::clamp(std::floor((x[k] - low_[k]) / size_), 0.0, count_[k] - 1.0));
  return bin;
}

template <typename Visit>
void BoxSearch::for_each_bin(const SpaceBox& box, const Visit& visit) const {
  const Bin first = bin_at(box.low), last = bin_at(box.high);
  for (Index k = first[2]; k <= last[2]; ++k)
    for (Index j = first[1]; j <= last[1]; ++j)
      for (Index i = first[0]; i <= last[0]; ++i) visit((k * count_[1] + j) * count_[0] + i);
}

std::vector<Index> BoxSearch::find(const SpaceBox& box) const {
  std::vector<Index> found;
  for_each_bin(box, [&](Index bin) {
    for (Index at = start_[bin]; at < start_[bin + 1]; ++at)
      if (boxes_[listed_[at]].meets(box)) found.push_back(listed_[at]);
  });
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

}  // namespace parison::contact
