// SPDX-License-Identifier: BSD-3-Clause
#include "tube_object.h"

#include <OgreSceneNode.h>

#include <algorithm>

namespace drill_rig_sim
{
namespace
{
constexpr std::size_t rings_a_piece = 150;
}

void TubeObject::clear()
{
  for (const auto& piece : pieces_) node_->detachObject(piece.get());
  pieces_.clear();
  used_ = 0;
}

void TubeObject::set(const std::vector<Ring>& rings, int sides, bool inside, bool closed)
{
  used_ = 0;
  for (std::size_t first = 0; first + 1 < rings.size(); first += rings_a_piece)
  {
    const std::size_t end =
        std::min(first + rings_a_piece + 1, rings.size());  // a piece begins with the ring that the one before ends with
    part_.assign(rings.begin() + static_cast<std::ptrdiff_t>(first), rings.begin() + static_cast<std::ptrdiff_t>(end));
    mesh_.clear();
    add_tube(mesh_, part_, sides, inside);
    if (closed && end == rings.size()) add_disc(mesh_, rings.back(), sides, inside);
    shade(mesh_);
    if (used_ == pieces_.size())
    {
      pieces_.push_back(std::make_unique<MeshObject>(style_));
      node_->attachObject(pieces_.back().get());
    }
    pieces_[used_++]->set(mesh_);
  }
  for (std::size_t i = used_; i < pieces_.size(); ++i) pieces_[i]->show(false);
}

void TubeObject::show(bool shown)
{
  for (std::size_t i = 0; i < used_; ++i) pieces_[i]->show(shown);
}

}  // namespace drill_rig_sim
