// SPDX-License-Identifier: GPL-3.0-or-later
// The process of a batch that reads and prepares one mesh, once, and starts a copy of itself for
// each curve on it. So a curve that crashes ends alone, and so does a mesh.
#include "cli/child_process.h"
#include "cli/curve_options.h"
#include "cli/interrupt.h"
#include "cli/packet_socket.h"
#include "cli/verb.h"

#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace bspline_curve::cli {

namespace {

/// The command line of one curve, after its number.
CurveArguments argumentsOf(const std::vector<std::string>& request) {
    std::vector<const char*> words;
    for (const std::string& text : request) {
        words.push_back(text.c_str());
    }
    return readCurveArguments(Arguments(words).subspan(1));
}

class MeshServer {
public:
    MeshServer(const CurveArguments& arguments, std::vector<std::string> first)
        : loaded_(loadMesh(arguments.mesh, arguments.mending.strict)) {
        loaded_.prepareForCurves(arguments, arguments.noCache, [](double, const char*) {
            return !interrupted();
        });
        start(std::move(first));
    }

    /// Until there are no more requests and all curves have ended.
    void run() {
        while (isOpen_ || !curves_.empty()) {
            passOnInterrupt();
            wait();
        }
    }

private:
    struct RunningCurve {
        std::string number;
        std::unique_ptr<ChildProcess> process;
    };

    void start(std::vector<std::string> request) {
        auto process = std::make_unique<ChildProcess>([&] {
            return reportingErrors([&] { return drawOn(loaded_, argumentsOf(request)); });
        });
        curves_.push_back({std::move(request.front()), std::move(process)});
    }

    void passOnInterrupt() {
        if (interrupted() && !std::exchange(isInterruptPassedOn_, true)) {
            isOpen_ = false;
            for (const RunningCurve& curve : curves_) {
                curve.process->interrupt();
            }
        }
    }

    /// Waits a moment for requests, and for curves that print something or end.
    void wait() {
        constexpr int kMilliseconds = 100;
        std::vector<pollfd> descriptors{
            {.fd = isOpen_ ? STDIN_FILENO : -1, .events = POLLIN, .revents = 0}
        };
        for (const RunningCurve& curve : curves_) {
            descriptors.push_back(
                {.fd = curve.process->descriptor(), .events = POLLIN, .revents = 0}
            );
        }
        if (::poll(descriptors.data(), descriptors.size(), kMilliseconds) <= 0) {
            return;
        }
        std::vector<RunningCurve> still;
        for (std::size_t i = 0; i < curves_.size(); ++i) {
            RunningCurve& curve = curves_[i];
            if (descriptors[i + 1].revents == 0 || curve.process->read()) {
                still.push_back(std::move(curve));
            } else {
                tellEnd(curve);
            }
        }
        curves_ = std::move(still);
        if (descriptors[0].revents != 0) {
            takeRequest();
        }
    }

    void takeRequest() {
        if (std::optional<std::vector<std::string>> request = receivePacket(STDIN_FILENO)) {
            start(std::move(*request));
        } else {
            isOpen_ = false;
        }
    }

    static void tellEnd(RunningCurve& curve) {
        const ChildProcess::End end = curve.process->wait();
        std::string printed = curve.process->printed();
        std::erase(printed, '\0');
        // Where nobody listens any more, this process is about to be interrupted.
        static_cast<void>(sendPacket(
            STDIN_FILENO,
            {std::move(curve.number),
             std::to_string(end.exitCode),
             std::to_string(end.signal),
             std::to_string(end.peakMemoryBytes),
             std::move(printed)}
        ));
    }

    LoadedMesh loaded_;
    std::vector<RunningCurve> curves_;
    bool isOpen_ = true;  // more requests may come
    bool isInterruptPassedOn_ = false;
};

}  // namespace

ExitCode runMeshProcess() {
    std::optional<std::vector<std::string>> first = receivePacket(STDIN_FILENO);
    if (!first) {
        return ExitCode::Success;
    }
    const CurveArguments arguments = argumentsOf(*first);
    return runVerb(
        [&](ProgressBar&) {
            MeshServer(arguments, std::move(*first)).run();
            return ExitCode::Success;
        },
        AfterInterrupt::Finish
    );
}

}  // namespace bspline_curve::cli
