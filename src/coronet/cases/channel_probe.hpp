// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Flow in a channel (channel_flow.hpp): the velocity along x across the channel, at the centres of equal cells about a
// spacing wide, beside the exact one; steady, or from rest.

#include "coronet/cases/channel_flow.hpp"
#include "coronet/cases/probe.hpp"
#include "coronet/kernels/kernel.hpp"

namespace coronet {

template <int D>
class ChannelProbe final : public Probe<D> {
public:
    ChannelProbe(ProbeKeys const& keys, Case const& c);

    std::vector<std::string> columns() const override { return {"velocity_error"}; }
    std::vector<double> sample(Snapshot<D> const& now) override;
    std::vector<Measure> measures() const override;
    std::vector<Profile> profiles() const override { return {profile_}; }

private:
    ChannelFlow exact_;
    bool from_rest_;
    Kernel kernel_;
    Vector<double, D> centre_;
    Profile profile_{"velocity", {}, {}, {}};
};

}  // namespace coronet
