// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/option_bindings.h"

#include "bspline_curve/error.h"
#include "filters/edit_requests.h"
#include "filters/filter_description.h"
#include "filters/fit_requests.h"
#include "filters/imprint_requests.h"
#include "filters/parameter_values.h"
#include "filters/pattern_requests.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <string_view>
#include <utility>

// The description of the filters and the options of the libraries say the same.
namespace bspline_curve {
namespace {

/// Initialises any member.
struct Anything {
    template <class Member>
    operator Member() const;  // NOLINT(google-explicit-constructor)
};

/// How many members an aggregate has.
template <class Options, class... Members>
consteval std::size_t memberCount() {
    if constexpr (requires { Options{Members{}..., Anything{}}; }) {
        return memberCount<Options, Members..., Anything>();
    } else {
        return sizeof...(Members);
    }
}

bool leavesAsItIs(const std::string& option) {
    return option == "preset" || option == "none" || option == kAutomaticField;
}

/// A value of the parameter that differs from `value`; one that the options accept.
ParameterValue otherValue(const ParameterDescription& parameter, const ParameterValue& value) {
    if (const auto* const flag = std::get_if<bool>(&value)) {
        return !*flag;
    }
    if (const auto* const whole = std::get_if<int>(&value)) {
        return parameter.max == *whole ? *whole - 1 : *whole + 1;
    }
    if (const auto* const number = std::get_if<double>(&value)) {
        return *number == 0.5 ? 0.25 : 0.5;
    }
    if (parameter.type == ParameterType::Text) {
        return "0 0 2";
    }
    if (parameter.type == ParameterType::Tolerances || parameter.type == ParameterType::Length) {
        return "2 edges";
    }
    if (parameter.type == ParameterType::Tangents) {
        return "2:1,0,0.5";
    }
    if (parameter.type == ParameterType::Picks) {
        return "2,3";
    }
    for (const EnumOption& option : parameter.options) {
        if (ParameterValue(option.id) != value && !leavesAsItIs(option.id)) {
            return option.id;
        }
    }
    throw std::logic_error(parameter.id + " has only one value");
}

/// Each binding sets a member of its own, and there are as many as members.
template <class Options>
void expectAllMembersBound(
    const FilterDescription& filter,
    const Bindings<Options>& bindings,
    std::size_t count = memberCount<Options>()
) {
    EXPECT_EQ(bindings.size(), count);
    const Options standard;
    for (const Binding<Options>& binding : bindings) {
        const ParameterValue before = binding.write(standard);
        const ParameterValue other = otherValue(filter.parameter(binding.id), before);
        Options options;
        binding.read(other, options);
        EXPECT_EQ(binding.write(options), other) << binding.id;
        for (const Binding<Options>& rest : bindings) {
            if (rest.id != binding.id) {
                EXPECT_EQ(rest.write(options), rest.write(standard))
                    << binding.id << " sets " << rest.id << " too";
            }
        }
    }
}

TEST(OptionBindings, EveryMemberOfTheOptionsHasAParameterOfItsOwn) {
    // The numbers of the paper are a struct of their own.
    const std::size_t ofSolver = memberCount<SolverOptions>() - 1 + memberCount<PaperOptions>();
    expectAllMembersBound(curveFilter(), solverBindings(), ofSolver);
    expectAllMembersBound(curveFilter(), samplingBindings());
    expectAllMembersBound(curveFilter(), shellBindings());
    expectAllMembersBound(curveFilter(), fieldBindings("field", "field_"));
    expectAllMembersBound(fieldFilter(), fieldBindings("kind", ""));
    expectAllMembersBound(cutFilter(), placingBindings());
    expectAllMembersBound(cutFilter(), imprintBindings());
}

template <class Options>
void addIds(std::multiset<std::string>& ids, const Bindings<Options>& bindings) {
    for (const Binding<Options>& binding : bindings) {
        ids.insert(binding.id);
    }
}

std::multiset<std::string> idsOf(const FilterDescription& filter) {
    std::multiset<std::string> ids;
    for (const ParameterDescription& parameter : filter.parameters) {
        ids.insert(parameter.id);
    }
    return ids;
}

TEST(OptionBindings, EveryParameterIsBoundOnce) {
    std::multiset<std::string> curve{"preset", "strict", "weld", "slits"};  // read apart
    addIds(curve, solverBindings());
    addIds(curve, samplingBindings());
    addIds(curve, shellBindings());
    addIds(curve, fieldBindings("field", "field_"));
    addIds(curve, regionBindings("field_"));
    addIds(curve, curveBindings());
    addIds(curve, avoidBindings());
    EXPECT_EQ(curve, idsOf(curveFilter()));

    std::multiset<std::string> field{"strict", "weld", "slits"};
    addIds(field, fieldBindings("kind", ""));
    addIds(field, regionBindings(""));
    EXPECT_EQ(field, idsOf(fieldFilter()));

    std::multiset<std::string> use{"strict", "weld", "slits"};
    addIds(use, useBindings());
    addIds(use, placingBindings());
    std::multiset<std::string> offset = use;
    addIds(offset, offsetBindings());
    addIds(offset, bandBindings());
    EXPECT_EQ(offset, idsOf(offsetFilter()));
    std::multiset<std::string> pattern = use;
    addIds(pattern, patternBindings());
    addIds(pattern, scaleBindings());
    addIds(pattern, rowBindings());
    addIds(pattern, carryingBindings());
    EXPECT_EQ(pattern, idsOf(patternFilter()));
    std::multiset<std::string> points = use;
    addIds(points, pointsBindings());
    EXPECT_EQ(points, idsOf(pointsFilter()));
    std::multiset<std::string> fill{"surface_layer", "strict", "weld", "slits"};
    addIds(fill, fillBindings());
    EXPECT_EQ(fill, idsOf(fillFilter()));
    std::multiset<std::string> fit(fittedParameters().begin(), fittedParameters().end());
    addIds(fit, fitBindings());
    addIds(fit, fitOptionBindings());
    EXPECT_EQ(fit, idsOf(fitFilter()));
    std::multiset<std::string> edit = use;
    addIds(edit, editBindings());
    addIds(edit, joinBindings());
    EXPECT_EQ(edit, idsOf(editFilter()));
    addIds(use, imprintBindings());
    EXPECT_EQ(use, idsOf(imprintFilter()));
    std::multiset<std::string> cut = use;
    addIds(cut, cutBindings());
    EXPECT_EQ(cut, idsOf(cutFilter()));
    addIds(use, segmentBindings());
    EXPECT_EQ(use, idsOf(segmentFilter()));
}

template <class Options>
void expectDefaults(
    const FilterDescription& filter,
    const Bindings<Options>& bindings,
    const Options& standard = Options()
) {
    for (const Binding<Options>& binding : bindings) {
        const ParameterDescription& parameter = filter.parameter(binding.id);
        const ParameterValue& value = parameter.defaultValue;
        const auto* const word = std::get_if<std::string>(&value);
        if (word != nullptr && leavesAsItIs(*word) && parameter.id != "avoid") {
            const EnumOption& option = parameter.options[parameter.defaultOption()];
            const auto actual = std::get<std::string>(binding.write(standard));
            EXPECT_TRUE(parameter.indexOf(actual)) << parameter.id << " has no " << actual;
            if (*word == "preset") {
                EXPECT_EQ(option.help, "as the preset says, by default " + actual) << parameter.id;
            }
        } else {
            EXPECT_EQ(value, binding.write(standard)) << parameter.id;
        }
    }
}

TEST(OptionBindings, DefaultsAreThoseOfTheOptions) {
    expectDefaults(curveFilter(), solverBindings());
    expectDefaults(curveFilter(), samplingBindings());
    expectDefaults(curveFilter(), shellBindings());
    expectDefaults(curveFilter(), fieldBindings("field", "field_"));
    const FaceChoice region = FieldRequest().region;
    expectDefaults(curveFilter(), regionBindings("field_"), region);
    expectDefaults(curveFilter(), avoidBindings());
    expectDefaults(curveFilter(), curveBindings());
    expectDefaults(fieldFilter(), fieldBindings("kind", ""));
    expectDefaults(fieldFilter(), regionBindings(""), region);
    expectDefaults(cutFilter(), useBindings());
    expectDefaults(cutFilter(), placingBindings());
    expectDefaults(cutFilter(), imprintBindings());
    expectDefaults(segmentFilter(), segmentBindings());
    expectDefaults(offsetFilter(), offsetBindings());
    expectDefaults(offsetFilter(), bandBindings());
    expectDefaults(patternFilter(), patternBindings());
    expectDefaults(patternFilter(), scaleBindings());
    expectDefaults(patternFilter(), rowBindings());
    expectDefaults(patternFilter(), carryingBindings());
    expectDefaults(fitFilter(), fitOptionBindings());
    expectDefaults(editFilter(), editBindings());
    expectDefaults(editFilter(), joinBindings());
    expectDefaults(pointsFilter(), pointsBindings());
    expectDefaults(fillFilter(), fillBindings());
    const CutWords choice;
    for (const Binding<CutWords>& binding : cutBindings()) {
        EXPECT_EQ(cutFilter().parameter(binding.id).defaultValue, binding.write(choice));
    }
}

/// Whether a value is one of the enumerators: compilers write others as casts.
template <auto Value>
consteval bool isEnumerator() {
    return std::string_view(__PRETTY_FUNCTION__).find("= (") == std::string_view::npos;
}

template <class Enum, int... Values>
consteval std::size_t enumeratorCount(std::integer_sequence<int, Values...> /*candidates*/) {
    return (std::size_t{isEnumerator<static_cast<Enum>(Values)>()} + ...);
}

/// Every option of the parameter stands for an enumerator of its own, and every enumerator has one.
template <class Options, class Enum>
void expectEnumerators(
    const FilterDescription& filter, const Binding<Options>& binding, Enum Options::* member
) {
    std::set<Enum> reached;
    for (const EnumOption& option : filter.parameter(binding.id).options) {
        Options options;
        binding.read(option.id, options);
        if (!leavesAsItIs(option.id)) {
            EXPECT_EQ(binding.write(options), ParameterValue(option.id));
            EXPECT_TRUE(reached.insert(options.*member).second) << option.id;
        }
    }
    constexpr std::make_integer_sequence<int, 64> kCandidates;
    EXPECT_EQ(reached.size(), enumeratorCount<Enum>(kCandidates)) << binding.id;
}

template <class Options>
Binding<Options> named(const Bindings<Options>& bindings, const std::string& id) {
    for (const Binding<Options>& binding : bindings) {
        if (binding.id == id) {
            return binding;
        }
    }
    throw std::logic_error("no binding " + id);
}

TEST(OptionBindings, EnumOptionsAreTheEnumerators) {
    const auto check = [](const auto& bindings, const std::string& id, auto member) {
        expectEnumerators(curveFilter(), named(bindings, id), member);
    };
    using S = SolverOptions;
    check(solverBindings(), "bending", &S::bending);
    check(solverBindings(), "initial_curve", &S::initialCurve);
    check(solverBindings(), "quadrature", &S::quadrature);
    check(solverBindings(), "barrier_width", &S::barrierWidth);
    check(solverBindings(), "distance_weight", &S::distanceWeight);
    check(solverBindings(), "interpolation", &S::interpolation);
    check(solverBindings(), "knot_rule", &S::knotRule);
    check(solverBindings(), "field_cost", &S::fieldCost);
    check(shellBindings(), "shell", &ShellOptions::kind);
    check(fieldBindings("field", "field_"), "field", &FieldOptions::kind);
    expectEnumerators(fieldFilter(), named(fieldBindings("kind", ""), "kind"), &FieldOptions::kind);
    expectEnumerators(cutFilter(), named(cutBindings(), "keep"), &CutWords::keep);
    expectEnumerators(offsetFilter(), named(offsetBindings(), "side"), &OffsetOptions::sides);
    expectEnumerators(patternFilter(), named(patternBindings(), "place"), &PatternRequest::place);
    expectEnumerators(fitFilter(), named(fitBindings(), "boundaries"), &FitRequest::labels);
    expectEnumerators(editFilter(), named(editBindings(), "edit"), &EditRequest::edit);
    expectEnumerators(editFilter(), named(editBindings(), "ends"), &EditRequest::ends);
}

TEST(OptionBindings, EnumOptionsAreWhatCanBeAvoided) {
    using By = FaceChoice::By;
    const auto reached = [](const Binding<FaceChoice>& binding, const std::string& id) {
        std::set<By> all;
        for (const EnumOption& option : curveFilter().parameter(id).options) {
            FaceChoice choice{.by = By::Ids};
            binding.read(option.id, choice);
            EXPECT_TRUE(all.insert(choice.by).second) << option.id;
        }
        EXPECT_FALSE(all.contains(By::Ids));
        return all.size();
    };
    EXPECT_EQ(reached(named(avoidBindings(), "avoid"), "avoid"), 5U);
    EXPECT_EQ(reached(named(regionBindings("field_"), "field_region"), "field_region"), 2U);
}

// ---- ranges ----

bool isAccepted(
    const FilterDescription& filter, const std::string& id, const ParameterValue& value
) {
    ParameterValues values(filter);
    values.set(id, value);
    const bool isCurve = &filter == &curveFilter();
    if (isCurve) {
        values.set("field", std::string("ridge"));  // else nothing of the field is asked for
    }
    try {
        if (isCurve) {
            static_cast<void>(curveRequest(values));
        } else if (&filter == &cutFilter()) {
            values.set("keep", std::string("inside"));  // which parts become what is asked for
            if (id.starts_with("profile")) {
                values.set("relief", 1.0);
            }
            static_cast<void>(cutRequest(values));
        } else if (&filter == &offsetFilter()) {
            static_cast<void>(offsetRequest(values));
        } else if (&filter == &patternFilter()) {
            values.set("drawing", std::string("a.svg"));
            static_cast<void>(patternRequest(values));
        } else if (&filter == &fitFilter()) {
            static_cast<void>(fitRequest(values));
        } else if (&filter == &editFilter()) {
            static_cast<void>(editRequest(values));
        } else if (&filter == &pointsFilter()) {
            static_cast<void>(pointsRequest(values));
        } else if (&filter == &fillFilter()) {
            static_cast<void>(fillRequest(values));
        } else {
            static_cast<void>(fieldRequest(values));
        }
        return true;
    } catch (const InputError& error) {
        EXPECT_EQ(error.code(), InputErrorCode::BadOption);
        return false;
    }
}

void expectWholeRange(const FilterDescription& filter, const ParameterDescription& parameter) {
    const auto check = [&](int value, bool isInside) {
        EXPECT_EQ(isAccepted(filter, parameter.id, value), isInside)
            << parameter.id << " " << value;
    };
    ASSERT_TRUE(parameter.min) << parameter.id;
    check(static_cast<int>(*parameter.min), true);
    check(static_cast<int>(*parameter.min) - 1, false);
    if (parameter.max) {
        check(static_cast<int>(*parameter.max), true);
        check(static_cast<int>(*parameter.max) + 1, false);
    } else {
        check(std::numeric_limits<int>::max(), true);
    }
}

void expectRealRange(const FilterDescription& filter, const ParameterDescription& parameter) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    const auto check = [&](double value, bool isInside) {
        EXPECT_EQ(isAccepted(filter, parameter.id, value), isInside)
            << parameter.id << " " << value;
    };
    ASSERT_TRUE(parameter.min) << parameter.id;
    check(*parameter.min, !parameter.excludesMin);
    check(std::nextafter(*parameter.min, kInfinity), true);
    check(std::nextafter(*parameter.min, -kInfinity), false);
    const double max = parameter.max.value_or(std::numeric_limits<double>::max());
    check(max, true);
    check(std::nextafter(max, kInfinity), false);
    check(std::numeric_limits<double>::quiet_NaN(), false);
}

TEST(OptionBindings, RangesAreWhatTheOptionsAccept) {
    for (const FilterDescription* const filter :
         {&curveFilter(),
          &fieldFilter(),
          &cutFilter(),
          &offsetFilter(),
          &patternFilter(),
          &fitFilter(),
          &editFilter(),
          &pointsFilter(),
          &fillFilter()}) {
        for (const ParameterDescription& parameter : filter->parameters) {
            if (parameter.type == ParameterType::Int) {
                expectWholeRange(*filter, parameter);
            } else if (std::holds_alternative<double>(parameter.defaultValue) &&
                       parameter.id != "avoid_threshold" && parameter.id != "shift" &&
                       parameter.id != "relief" && parameter.id != "thickness" &&
                       parameter.id != "base_height") {
                // Those may be any number.
                expectRealRange(*filter, parameter);
            }
        }
    }
}

}  // namespace
}  // namespace bspline_curve
