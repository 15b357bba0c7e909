// SPDX-License-Identifier: MIT
#include <cmath>

#include "energy/limb_curve.h"
#include "energy/outline.h"
#include "energy/wood.h"

namespace edaha {
namespace {

Site site_at(const LimbSlice& slice, const Limb& limb) {
    Site site;
    site.position = slice.centre;
    site.direction = slice.tangent;
    site.key = limb.key;
    site.wood_width_mm = 2 * slice.half_width;
    site.clump = limb.clump;
    site.back = limb.back;
    return site;
}

}  // namespace

std::vector<Site> sites(const Limbs& limbs, const LookParams& look, const SiteParams& params) {
    std::vector<Site> result;
    result.reserve(limbs.limbs.size());
    for (const Limb& limb : limbs.limbs) {
        const LimbCurve curve = curve_of(limbs, limb, look);
        if (limb.terminal) {
            Site tip = site_at(curve.slice_at_node(curve.spans()), limb);
            tip.terminal = true;
            result.push_back(tip);
        }
        if (params.along_mm <= 0) continue;
        // Counted from the tip, so that the outer ones stay put when the limb grows longer below.
        const double length = curve.length_mm(0, curve.spans());
        Key key = step(limb.key, 0x616c6f6e67);
        for (double s = params.along_mm; s < length; s += params.along_mm) {
            key = step(key, 0);
            const LimbSlice slice = curve.slice(curve.walk(curve.spans(), -s));
            if (2 * slice.half_width >= params.along_width_mm) break;
            Site site = site_at(slice, limb);
            site.key = key;
            site.along_mm = s;
            result.push_back(site);
        }
    }
    return result;
}

}  // namespace edaha
