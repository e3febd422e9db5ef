// SPDX-License-Identifier: Apache-2.0
#include "core/tessellation/stored_nets.h"

#include <algorithm>

namespace burin::tessellation {

void StoredNets::Start(std::uint64_t revision, std::size_t patch_count, bool has_tangents) {
  if (revision != 0 && revision == revision_ && patch_count == entries_.size() && has_tangents == has_tangents_) return;
  revision_ = revision;
  has_tangents_ = has_tangents;
  entries_.clear();
  entries_.resize(revision == 0 ? 0 : patch_count);
  bytes_ = 0;
}

bool StoredNets::Restore(std::size_t patch, PatchNets& nets) const {
  if (patch >= entries_.size() || entries_[patch].values == nullptr) return false;
  const Entry& entry = entries_[patch];
  const Lanes* from = entry.values.get();
  for (std::size_t c = 0; c < kChannelCount; ++c) {
    nets.has[c] = entry.shapes[c].u_degree >= 0;
    if (!nets.has[c]) continue;
    Net& net = nets.net[c];
    net.domain = entry.domain;
    net.u_degree = entry.shapes[c].u_degree;
    net.v_degree = entry.shapes[c].v_degree;
    std::copy_n(from, net.Count(), net.value.begin());
    from += net.Count();
  }
  return true;
}

void StoredNets::Store(std::size_t patch, const PatchNets& nets) {
  if (patch >= entries_.size()) return;
  std::size_t count = 0;
  for (std::size_t c = 0; c < kChannelCount; ++c)
    count += nets.has[c] ? static_cast<std::size_t>(nets.net[c].Count()) : 0;
  const std::size_t bytes = count * sizeof(Lanes);
  if (bytes_.fetch_add(bytes) + bytes > kMaxBytes) {
    bytes_ -= bytes;
    return;
  }
  Entry& entry = entries_[patch];
  entry.values.reset(new Lanes[count]);
  entry.domain = nets.net[0].domain;
  Lanes* to = entry.values.get();
  for (std::size_t c = 0; c < kChannelCount; ++c) {
    if (!nets.has[c]) continue;
    const Net& net = nets.net[c];
    entry.shapes[c] = {static_cast<std::int8_t>(net.u_degree), static_cast<std::int8_t>(net.v_degree)};
    to = std::copy_n(net.value.begin(), net.Count(), to);
  }
}

}  // namespace burin::tessellation
