// Progress of a long piece of work and the wish to stop it, passed by value into loading, baking and reporting.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <functional>
#include <stop_token>

namespace relievo {

struct Progress {
    std::function<void(float)> report; // share done in [0, 1]; called from any thread; may be empty
    std::stop_token stop; // asked at least every 100 ms of work

    void at(float share) const
    {
        if (report)
            report(share);
    }
    bool cancelled() const { return stop.stop_requested(); }

    // Of work that takes the share from `from` to `to` of this.
    Progress part(float from, float to) const
    {
        if (!report)
            return {{}, stop};
        return {[whole = report, from, to](float share) { whole(from + (to - from) * share); }, stop};
    }
};

} // namespace relievo
