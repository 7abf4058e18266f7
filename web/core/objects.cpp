// SPDX-License-Identifier: GPL-3.0-or-later
#include "web/core/objects.h"

#include <stdexcept>
#include <utility>

namespace bspline_curve::web {

namespace {

std::map<int, Object>& allObjects() {
    static std::map<int, Object> objects;
    return objects;
}

template <class Kept>
Kept objectOfType(int number, const char* name) {
    const Kept* const object = std::get_if<Kept>(&objectOf(number));
    if (object == nullptr) {
        throw std::invalid_argument("this is no " + std::string(name));
    }
    return *object;
}

}  // namespace

int keep(Object object) {
    static int last = 0;
    allObjects().emplace(++last, std::move(object));
    return last;
}

void forget(int number) {
    allObjects().erase(number);
}

int objectCount() {
    return static_cast<int>(allObjects().size());
}

const Object& objectOf(int number) {
    const auto place = allObjects().find(number);
    if (place == allObjects().end()) {
        throw std::invalid_argument("this was freed");
    }
    return place->second;
}

std::shared_ptr<const Mesh> meshOf(int number) {
    return objectOfType<std::shared_ptr<const Mesh>>(number, "mesh");
}

std::shared_ptr<const DrawnOnMesh> curveOf(int number) {
    return objectOfType<std::shared_ptr<const DrawnOnMesh>>(number, "curve");
}

std::shared_ptr<const ImprintOnMesh> imprintOf(int number) {
    return objectOfType<std::shared_ptr<const ImprintOnMesh>>(number, "imprint");
}

std::shared_ptr<Session> sessionOf(int number) {
    return objectOfType<std::shared_ptr<Session>>(number, "session");
}

}  // namespace bspline_curve::web
