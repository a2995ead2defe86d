// Stacks whose sections differ in topology: nesting, branching, holes, isolated and empty.
#include <algorithm>
#include <cmath>

#include "support/stacks/kinds.hpp"
#include "support/stacks/shapes.hpp"

namespace tetloft::testing {
namespace {

Layer blobs(Prng& prng, const std::vector<Disc>& discs) {
  Layer layer;
  for (const Disc& disc : discs) layer.push_back(blob_in(prng, disc, number(prng, 3, 14)));
  return layer;
}

// One large contour that covers about [−5, 5]².
Layer trunk(Prng& prng) {
  switch (number(prng, 0, 3)) {
    case 0: return {rectangle({-5, -5}, {5, 5}, number(prng, 1, 4))};
    case 1: return {rectangle({-6, -1}, {6, 1}, number(prng, 1, 6))};
    case 2: return {regular_polygon({0, 0}, 5, number(prng, 3, 24), 0.1)};
    default: return {blob(prng, {0, 0}, 3.5, 6, number(prng, 6, 24))};
  }
}

}  // namespace

SectionStack draft_nesting(Prng& prng) {
  const bool squares = prng.chance(0.3);
  const std::size_t depth = number(prng, 2, 5);
  const std::size_t towers = prng.chance(0.25) ? 2 : 1;
  std::vector<Layer> layers(number(prng, 2, 4));
  double drift = 0;
  for (Layer& layer : layers) {
    for (std::size_t tower = 0; tower < towers; ++tower) {
      const double x = 14 * static_cast<double>(tower) + drift;
      const std::size_t rings = 1 + (prng.chance(0.7) ? depth : number(prng, 0, depth));
      for (std::size_t ring = 0; ring < rings; ++ring) {
        const double radius = 6 - static_cast<double>(ring);
        if (squares) {
          layer.push_back(
              rectangle({x - radius, -radius}, {x + radius, radius}, number(prng, 1, 3)));
        } else {
          // A band of a third of the spacing and this many vertices keep rings apart.
          const std::size_t n = ring == 5 ? number(prng, 3, 12) : 18 - 2 * ring;
          layer.push_back(blob(prng, {x, 0}, radius - 0.3, radius, n));
        }
      }
    }
    drift += squares ? static_cast<double>(number(prng, 0, 2)) / 2 : prng.between(-0.8, 0.8);
  }
  return stack_of(layers, heights(prng, layers.size()));
}

SectionStack draft_branching_one_to_many(Prng& prng) {
  const Layer branches = blobs(prng, pack_discs(prng, number(prng, 2, 6), 6, 0.6, 2, 0.2));
  std::vector<Layer> layers;
  switch (number(prng, 0, 3)) {
    case 0: layers = {trunk(prng), branches}; break;
    case 1: layers = {branches, trunk(prng)}; break;
    case 2: layers = {trunk(prng), branches, trunk(prng)}; break;
    default: {
      const Layer others = blobs(prng, pack_discs(prng, number(prng, 2, 4), 6, 0.6, 2, 0.2));
      layers = {branches, trunk(prng), others};
    }
  }
  return stack_of(layers, heights(prng, layers.size()));
}

SectionStack draft_branching_many_to_many(Prng& prng) {
  std::vector<Layer> layers(number(prng, 2, 4));
  for (Layer& layer : layers) {
    layer = blobs(prng, pack_discs(prng, number(prng, 2, 5), 5, 0.8, 2.4, 0.1));
  }
  return stack_of(layers, heights(prng, layers.size()));
}

SectionStack draft_holes(Prng& prng) {
  std::vector<Disc> holes = pack_discs(prng, number(prng, 1, 4), 3.2, 0.4, 1.4, 0.3);
  std::vector<Layer> layers(number(prng, 2, 4));
  for (std::size_t i = 0; i < layers.size(); ++i) {
    // Now and then the outer contour moves away, and holes lie over exterior.
    const double away = i > 0 && prng.chance(0.2) ? prng.between(2, 6) : 0;
    if (prng.chance(0.3)) {
      layers[i].push_back(rectangle({away - 6, -6}, {away + 6, 6}, number(prng, 1, 3)));
    } else {
      layers[i].push_back(blob(prng, {away, 0}, 5.5, 7, number(prng, 10, 20)));
    }
    for (Disc& hole : holes) {
      hole.centre = displaced(prng, hole.centre, 0.2);
      if (prng.chance(0.3)) continue;
      const Disc here{{hole.centre.x + away, hole.centre.y}, hole.radius};
      layers[i].push_back(blob_in(prng, here, number(prng, 3, 9)));
      if (prng.chance(0.2)) {
        layers[i].push_back(regular_polygon(here.centre, 0.3 * here.radius, number(prng, 3, 6), 0));
      }
    }
  }
  return stack_of(layers, heights(prng, layers.size()));
}

SectionStack draft_triangular_holes(Prng& prng) {
  const auto triangle = [&](const Disc& disc) {
    return regular_polygon(disc.centre, disc.radius, 3, prng.between(0, 2 * kPi));
  };
  const bool large = prng.chance(0.3);  // one hole that leaves a thin frame
  const Contour outer = large              ? regular_polygon({0, 0}, 6, number(prng, 3, 9), 0.2)
                        : prng.chance(0.5) ? rectangle({-6, -6}, {6, 6}, number(prng, 1, 3))
                                           : blob(prng, {0, 0}, 5.5, 7, number(prng, 8, 16));
  std::vector<Disc> discs;
  if (large) {
    discs = {{{0, 0}, prng.between(1, 2.8)}};
  } else {
    discs = pack_discs(prng, number(prng, 1, 4), 3.5, 0.4, 1.8, 0.2);
  }
  Layer holes;
  for (const Disc& disc : discs) holes.push_back(triangle(disc));

  std::vector<Layer> layers(number(prng, 2, 3));
  for (std::size_t i = 0; i < layers.size(); ++i) {
    layers[i].push_back(outer);
    switch (number(prng, 0, 5)) {
      case 0: break;                            // filled
      case 1: append(layers[i], holes); break;  // the same
      case 2: {                                 // shifted
        const Point2 by = displaced(prng, {0, 0}, 1);
        for (Contour hole : holes) {
          for (Point2& p : hole.vertices) p = {p.x + by.x, p.y + by.y};
          layers[i].push_back(std::move(hole));
        }
        break;
      }
      case 3:  // turned
        for (const Disc& disc : discs) layers[i].push_back(triangle(disc));
        break;
      case 4:  // only islands where the others have holes
        layers[i].clear();
        for (const Disc& disc : discs) {
          layers[i].push_back(triangle({disc.centre, disc.radius * prng.between(0.2, 1.5)}));
        }
        break;
      default:  // each with an island of its own
        append(layers[i], holes);
        for (const Disc& disc : discs)
          layers[i].push_back(triangle({disc.centre, 0.3 * disc.radius}));
        break;
    }
  }
  return stack_of(layers, heights(prng, layers.size()));
}

SectionStack draft_isolated_contours(Prng& prng) {
  const std::vector<Disc> columns = pack_discs(prng, number(prng, 0, 2), 5, 1, 2.5, 0.3);
  std::vector<Layer> layers(number(prng, 2, 4));
  const double spread = prng.chance(0.5) ? 8 : 20;
  for (Layer& layer : layers) {
    layer = blobs(prng, columns);
    append(layer, blobs(prng, pack_discs(prng, number(prng, 1, 3), spread, 0.3, 2, 0.2)));
  }
  return stack_of(layers, heights(prng, layers.size()));
}

SectionStack draft_empty_sections(Prng& prng) {
  const std::vector<Disc> columns = pack_discs(prng, number(prng, 1, 3), 4, 0.7, 2, 0.3);
  std::vector<Layer> layers(number(prng, 2, 5));
  const std::size_t empty = number(prng, 0, layers.size() - 1);
  const std::size_t full = (empty + number(prng, 1, layers.size() - 1)) % layers.size();
  for (std::size_t i = 0; i < layers.size(); ++i) {
    if (i == empty || (i != full && prng.chance(0.3))) continue;
    layers[i] = blobs(prng, columns);
    if (prng.chance(0.3)) layers[i].push_back(rectangle({-9, -9}, {9, 9}, number(prng, 1, 3)));
  }
  return stack_of(layers, heights(prng, layers.size()));
}

SectionStack draft_changing_classes(Prng& prng) {
  const std::size_t columns = number(prng, 2, 4);
  const double shift = prng.chance(0.5) ? 0 : prng.between(-0.3, 0.3);
  std::vector<Layer> layers(number(prng, 3, 4));
  for (std::size_t i = 0; i < layers.size(); ++i) {
    const double dx = i % 2 == 0 ? 0 : shift;
    const std::size_t form = number(prng, 0, 2);
    const double last = 2 * static_cast<double>(columns) - 1;
    if (form == 0) {
      layers[i].push_back(rectangle({dx, 0}, {last + dx, 1}));  // joins all
      continue;
    }
    for (std::size_t k = 0; k < columns; ++k) {
      const double x = 2 * static_cast<double>(k) + dx;
      // Joins two where there is room for one.
      const bool wide = form == 2 && k + 1 < columns && prng.chance(0.5);
      layers[i].push_back(rectangle({x, 0}, {x + (wide ? 3 : 1), 1}));
      if (wide) ++k;
    }
  }
  return stack_of(layers, heights(prng, layers.size()));
}

}  // namespace tetloft::testing
