// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/manual.h"

#include "bspline_curve/version.h"
#include "text/text_parsing.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <cctype>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

namespace bspline_curve::cli {

namespace {

constexpr std::string_view kProgram = "bspline_curve";
constexpr std::string_view kPaperWord = "paper";  // after --help
constexpr std::string_view kExitStatus = "Exit status: ";

/// The options of a verb that it lists, without MESH and the like.
std::vector<const CLI::Option*> listedOptions(const CLI::App& app, const std::string& group = "") {
    return app.get_options([&](const CLI::Option* option) {
        return option->nonpositional() && !option->get_group().empty() &&
               (group.empty() || option->get_group() == group);
    });
}

/// In the order in which they are listed.
std::vector<std::string> listedGroups(const CLI::App& app) {
    std::vector<std::string> groups = app.get_groups();
    std::ranges::stable_partition(groups, [](const std::string& group) {
        return group != kDrawingGroup && group != kMendingGroup && group != kPaperGroup;
    });
    std::erase(groups, "");
    return groups;
}

/// Lists the settings of the paper, or all the others, with an empty line between groups.
class GroupedHelp : public CLI::Formatter {
public:
    explicit GroupedHelp(bool isOfPaper) : isOfPaper_(isOfPaper) {}

    [[nodiscard]] std::string make_help(
        const CLI::App* app, std::string name, CLI::AppFormatMode /*mode*/
    ) const override {
        std::string text =
            make_description(app) + make_usage(app, std::move(name)) + make_positionals(app);
        for (const std::string& group : listedGroups(*app)) {
            text += make_group(group, false, listedOptions(*app, group));
        }
        return text;
    }

    [[nodiscard]] std::string make_group(
        std::string group, bool isPositional, std::vector<const CLI::Option*> options
    ) const override {
        if ((group == kPaperGroup) == isOfPaper_) {
            return Formatter::make_group(group, isPositional, std::move(options));
        }
        return isOfPaper_ ? "" : "\n" + group + ": --help paper lists them\n";
    }

private:
    bool isOfPaper_;
};

std::vector<std::string> flagsOf(const CLI::Option& option) {
    std::vector<std::string> flags;
    for (const std::string& name : option.get_snames()) {
        flags.push_back("-" + name);
    }
    for (const std::string& name : option.get_lnames()) {
        flags.push_back("--" + name);
    }
    return flags;
}

/// What follows an option, as "FILE" or "left|right"; empty: nothing.
std::string valueOf(const CLI::Option& option) {
    return option.get_expected_max() == 0 ? "" : option.get_type_name();
}

/// The words that may follow an option; those in capitals stand for something else.
std::vector<std::string> wordsFor(const CLI::Option& option) {
    std::vector<std::string> words;
    if (const std::string value = valueOf(option); value.find('|') != std::string::npos) {
        for (const std::string_view word : splitAt(value, '|')) {
            if (word.find_first_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ") == std::string_view::npos) {
                words.emplace_back(word);
            }
        }
    }
    return words;
}

bool takesFile(const CLI::Option& option) {
    const std::string value = valueOf(option);
    return value.find("FILE") != std::string::npos || value.find("JOBS") != std::string::npos;
}

std::string replaced(std::string text, std::string_view what, std::string_view with) {
    return CLI::detail::find_and_replace(std::move(text), std::string(what), std::string(with));
}

/// The first sentence of a help, for one line of a menu.
std::string firstSentence(const std::string& help) {
    const std::size_t end = std::min(help.find(". "), help.find("; "));
    std::string sentence = help.substr(0, end);
    if (sentence.ends_with('.')) {
        sentence.pop_back();
    }
    return sentence;
}

std::string quoted(std::string text) {
    return "'" + replaced(std::move(text), "'", "'\\''") + "'";
}

std::string joinedBy(const std::vector<std::string>& words, const std::string& between) {
    return CLI::detail::join(words, between);
}

// ---- manual pages ----

std::string upperCase(std::string text) {
    std::ranges::transform(text, text.begin(), [](unsigned char c) {
        return static_cast<char>(std::toupper(c));
    });
    return text;
}

/// Text for roff: dashes that can be copied, no line that is taken for a request.
std::string roff(std::string text) {
    text = replaced(std::move(text), "\\", "\\e");
    text = replaced(std::move(text), "-", "\\-");
    text = replaced(std::move(text), "\n", " ");
    return text.starts_with('.') || text.starts_with('\'') ? "\\&" + text : text;
}

std::string titleLine(const std::string& name) {
    return ".TH " + roff(upperCase(name)) + R"( 1 "" "bspline_curve )" + BSPLINE_CURVE_VERSION +
           "\" \"User Commands\"\n";
}

std::string section(const std::string& title, const std::string& text) {
    return ".SH \"" + upperCase(title) + "\"\n" + text;
}

std::string entryOf(const CLI::Option& option) {
    std::string text = ".TP\n\\fB" + roff(joinedBy(flagsOf(option), ", ")) + "\\fR";
    if (const std::string value = valueOf(option); !value.empty()) {
        text += " \\fI" + roff(value) + "\\fR";
    }
    const std::string& help = option.get_description();
    text += "\n" + roff(help) + (help.ends_with('.') ? "" : ".");
    if (!option.get_default_str().empty()) {
        text += " Default: " + roff(option.get_default_str()) + ".";
    }
    return text + (option.get_required() ? " Required.\n" : "\n");
}

std::string manualOf(const CLI::App& app, std::string_view summary) {
    const std::string name = replaced(app.get_name(), " ", "-");
    std::string page = titleLine(name) +
                       section("Name", roff(name) + R"( \- )" + roff(std::string(summary)) + "\n");
    std::string usage = "\\fB" + roff(app.get_name()) + R"(\fR [\fIOPTIONS\fR])";
    std::string positionals;
    for (const CLI::Option* const option : app.get_options()) {
        if (option->get_positional()) {
            usage += " \\fI" + roff(option->get_name()) + "\\fR";
            positionals += ".TP\n\\fI" + roff(option->get_name()) + "\\fR\n" +
                           roff(option->get_description()) + "\n";
        }
    }
    page += section("Synopsis", usage + "\n");
    const std::string description = app.get_description();
    const std::size_t split = description.find(kExitStatus);
    page += section("Description", roff(description.substr(0, split)) + "\n" + positionals);
    for (const std::string& group : listedGroups(app)) {
        std::string entries;
        for (const CLI::Option* const option : listedOptions(app, group)) {
            entries += entryOf(*option);
        }
        page += entries.empty() ? "" : section(group, entries);
    }
    if (split != std::string::npos) {
        page += section("Exit status", roff(description.substr(split + kExitStatus.size())) + "\n");
    }
    return page + section("See also", ".BR bspline_curve (1)\n");
}

// ---- completion ----

std::string bashPart(const CLI::App& app, const std::string& verb) {
    std::vector<std::string> flags;
    std::string cases;
    for (const CLI::Option* const option : listedOptions(app)) {
        const std::vector<std::string> names = flagsOf(*option);
        flags.insert(flags.end(), names.begin(), names.end());
        if (const std::vector<std::string> words = wordsFor(*option); !words.empty()) {
            cases += "        " + joinedBy(names, "|") + ") words=" + quoted(joinedBy(words, " ")) +
                     " ;;\n";
        }
    }
    return "    " + verb + ")\n        flags='" + joinedBy(flags, " ") +
           "'\n        case $previous in\n" + cases + "        esac ;;\n";
}

std::string zshPart(const CLI::App& app, const std::string& verb) {
    std::string lines;
    for (const CLI::Option* const option : listedOptions(app)) {
        const std::vector<std::string> names = flagsOf(*option);
        const bool isRepeated = option->get_expected_max() >= CLI::detail::expected_max_vector_size;
        std::string help = firstSentence(option->get_description());
        help = replaced(std::move(help), "\\", "\\\\");
        help = "[" + replaced(replaced(std::move(help), "[", "\\["), "]", "\\]") + "]";
        if (const std::string value = valueOf(*option); !value.empty()) {
            const std::vector<std::string> words = wordsFor(*option);
            std::string action = takesFile(*option) ? "_files" : " ";
            if (!words.empty()) {
                const std::string list = joinedBy(words, " ");
                action = takesFile(*option) ? "{compadd " + list + "; _files}" : "(" + list + ")";
            }
            help += ":value:" + action;
        }
        const std::string others = names.size() > 1 ? "(" + joinedBy(names, " ") + ")" : "";
        for (const std::string& name : names) {
            std::string entry = isRepeated ? "*" : others;
            entry.append(name).append(help);
            lines.append("            ").append(quoted(std::move(entry))).append(" \\\n");
        }
    }
    return "    (" + verb + ")\n        _arguments -s : \\\n" + lines +
           "            '*:file:_files' ;;\n";
}

std::string fishPart(const CLI::App& app, const std::string& verb) {
    std::string lines;
    for (const CLI::Option* const option : listedOptions(app)) {
        lines += "complete -c bspline_curve -n '__bspline_curve_is " + verb + "'";
        for (const std::string& name : option->get_snames()) {
            lines += " -s " + name;
        }
        for (const std::string& name : option->get_lnames()) {
            lines += " -l " + name;
        }
        if (!valueOf(*option).empty()) {
            lines += takesFile(*option) ? " -r" : " -x";
        }
        if (const std::vector<std::string> words = wordsFor(*option); !words.empty()) {
            lines += " -a " + quoted(joinedBy(words, " "));
        }
        std::string help = firstSentence(option->get_description());
        help = replaced(replaced(std::move(help), "\\", "\\\\"), "'", "\\'");
        lines += " -d '" + help + "'\n";
    }
    return lines;
}

/// What stands before and after the parts of the verbs in a script; % is the list of verbs.
struct Script {
    std::string_view shell;
    std::string (*part)(const CLI::App& app, const std::string& verb);
    std::string_view before, between, after;
};

constexpr std::array<Script, 3> kScripts{{
    {.shell = "bash",
     .part = bashPart,
     .before = "_bspline_curve() {\n"
               "    local current=$2 previous=$3 verb=curve flags= words=\n"
               "    if [ \"$COMP_CWORD\" = 1 ] && [[ $current != -* ]]; then\n"
               "        mapfile -t COMPREPLY < <(compgen -W '% help' -- \"$current\"; compgen -f "
               "-- \"$current\")\n"
               "        return\n"
               "    fi\n"
               "    case ' % ' in *\" ${COMP_WORDS[1]} \"*) verb=${COMP_WORDS[1]} ;; esac\n"
               "    case $verb in\n",
     .between = "",
     .after = "    esac\n"
              "    if [[ $current == -* ]]; then words=$flags; fi\n"
              "    mapfile -t COMPREPLY < <(compgen -W \"$words\" -- \"$current\"; [[ $current == "
              "-* ]] || compgen -f -- \"$current\")\n"
              "}\n"
              "complete -o filenames -F _bspline_curve bspline_curve\n"},
    {.shell = "zsh",
     .part = zshPart,
     .before = "_bspline_curve() {\n"
               "    local verb=curve\n"
               "    local -a verbs=(\n",
     .between = "    )\n"
                "    if (( CURRENT == 2 )) && [[ $PREFIX != -* ]]; then\n"
                "        _describe verb verbs\n"
                "        _files\n"
                "        return\n"
                "    fi\n"
                "    if [[ ' % ' == *\" $words[2] \"* ]]; then\n"
                "        verb=$words[2]\n"
                "        shift words\n"
                "        (( CURRENT-- ))\n"
                "    fi\n"
                "    case $verb in\n",
     .after = "    esac\n"
              "}\n"
              "_bspline_curve \"$@\"\n"},
    {.shell = "fish",
     .part = fishPart,
     .before = "function __bspline_curve_is\n"
               "    set -l words (commandline -opc)\n"
               "    set -l verb curve\n"
               "    if set -q words[2]; and contains -- $words[2] %\n"
               "        set verb $words[2]\n"
               "    end\n"
               "    test $verb = $argv[1]\n"
               "end\n",
     .between = "",
     .after = ""},
}};

const Script* scriptFor(std::string_view shell) {
    const auto* const found = std::ranges::find(kScripts, shell, &Script::shell);
    return found == kScripts.end() ? nullptr : found;
}

/// The verbs with their summaries, as the shell lists them.
std::string menuOf(std::string_view shell, std::span<const VerbSummary> verbs) {
    std::string menu;
    for (const auto& [verb, summary] : verbs) {
        const std::string name(verb);
        const std::string text(summary);
        if (shell == "zsh") {
            menu.append("        ")
                .append(quoted(CLI::detail::join(std::vector{name, text}, ":")))
                .append("\n");
        } else if (shell == "fish") {
            menu.append("complete -c bspline_curve -n 'test (count (commandline -opc)) -eq 1' -a ")
                .append(name)
                .append(" -d ")
                .append(quoted(text))
                .append("\n");
        }
    }
    return menu;
}

}  // namespace

void groupHelp(CLI::App& app) {
    app.formatter(std::make_shared<GroupedHelp>(false));
}

bool printsText(CLI::App& app, Arguments words) {
    if (words.size() < 2) {
        return false;
    }
    const std::string_view asked = words.front();
    const std::string_view what = words[1];
    if (asked == "--help" && what == kPaperWord) {
        if (listedOptions(app, std::string(kPaperGroup)).empty()) {
            std::cout << app.help();
            return true;
        }
        app.formatter(std::make_shared<GroupedHelp>(true));
        app.description(
            "Settings that the default does not need, for comparison with the method of the paper "
            "(2023);\n--preset paper chooses those of the paper.\n"
        );
        std::cout << app.help();
    } else if (asked == kManual) {
        std::cout << manualOf(app, what);
    } else if (asked == kCompletion) {
        const std::string verb = app.get_name().substr(kProgram.size() + 1);
        std::cout << scriptFor(what)->part(app, verb);
    } else {
        return false;
    }
    return true;
}

std::string programManual(std::span<const VerbSummary> verbs) {
    std::string list;
    std::string pages;
    for (const auto& [verb, summary] : verbs) {
        const std::string name(verb);
        list += ".TP\n\\fB" + name + "\\fR\n" + roff(std::string(summary)) + "\n";
        pages +=
            ".BR bspline_curve\\-" + name + " (1)" + (verb == verbs.back().first ? "" : ",") + "\n";
    }
    return titleLine(std::string(kProgram)) +
           section("Name", "bspline_curve \\- smooth B\\-spline curves on triangle meshes\n") +
           section(
               "Synopsis",
               "\\fBbspline_curve\\fR [\\fIVERB\\fR] \\fIMESH\\fR [\\fIOPTIONS\\fR]\n.br\n"
               "\\fBbspline_curve\\fR [\\fIVERB\\fR] \\fB\\-\\-help\\fR [\\fBpaper\\fR]\n.br\n"
               "\\fBbspline_curve \\-\\-completion bash\\fR|\\fBzsh\\fR|\\fBfish\\fR\n"
           ) +
           section(
               "Description",
               "Draws smooth curves through picks on a triangle mesh, and makes things of them: "
               "cuts, fills, segments, offsets, patterns. A first argument that is no verb is the "
               "mesh of a curve. In place of a file \\- is standard input or output, of a mesh as "
               ".ply, of all else as .json.\n"
           ) +
           section("Verbs", list) + section("See also", pages);
}

bool printCompletion(
    std::string_view shell,
    std::span<const VerbSummary> verbs,
    const std::function<void(std::string_view verb)>& printVerb
) {
    const Script* const script = scriptFor(shell);
    if (script == nullptr) {
        return false;
    }
    std::vector<std::string> names;
    for (const VerbSummary& verb : verbs) {
        names.emplace_back(verb.first);
    }
    const auto filled = [&](std::string_view text) {
        return replaced(std::string(text), "%", joinedBy(names, " "));
    };
    std::cout << (shell == "zsh" ? "#compdef bspline_curve\n" : "")
              << "# Completion of bspline_curve for " << shell
              << ", made by bspline_curve --completion " << shell << "\n"
              << filled(script->before) << menuOf(shell, verbs) << filled(script->between);
    std::ranges::for_each(names, printVerb);
    std::cout << script->after;
    return true;
}

}  // namespace bspline_curve::cli
