// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "scene.hpp"

#include <algorithm>

#include "ocean/internal/text.hpp"

namespace ocean::app {

std::string Scene::probe_line(preview::Renderer&, const PreviewOptions&,
                              const std::array<double, 2>& place) {
    return probe_text(place, {ground().height(place[0], place[1])});
}

std::vector<const SceneRow*>& scene_rows() {
    static std::vector<const SceneRow*> rows = {&kSeaScene, &kTerrainScene};
    return rows;
}

const SceneRow& row_of(const Subject& subject) {
    return **std::ranges::find(scene_rows(), subject.kind(), &SceneRow::kind);
}

std::string probe_text(const std::array<double, 2>& place, std::initializer_list<double> numbers) {
    std::string line = shortest_text(place[0]) + "," + shortest_text(place[1]);
    for (const double number : numbers) line += "," + shortest_text(static_cast<float>(number));
    return line + "\n";
}

}  // namespace ocean::app
