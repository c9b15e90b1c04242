#pragma once

#include "core/base/fields.h"

namespace mirrorball {

/// Flecks: cells on the surface, each of which looks the sphere map up elsewhere, as facets that are turned at random. Scene and renderer
/// hold the same value. Source: 003 section 6.2
struct Flecks {
    double density = 0.0;
    double size = 0.02;
    double spread = 0.4;
    int seed = 0;

    bool operator==(const Flecks&) const = default;
    template <typename Self, typename Visit>
    static void visitFields(Self& self, Visit&& visit)
    {
        visit(Field{"density", "share of the cells that are flecks; 0: none", 0, 1}, self.density);
        visit(Field{"size", "of a cell; the object's radius is 1", 1e-3, 1}, self.size);
        visit(Field{"spread", "how far a fleck's lookup may lie from the surface's own, in radii of the disc", 0, 2}, self.spread);
        visit(Field{"seed", "another number, another arrangement", 0, 1000000}, self.seed);
    }
};

} // namespace mirrorball
