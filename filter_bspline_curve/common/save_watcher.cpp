// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_bspline_curve/common/save_watcher.h"

#include "filter_bspline_curve/common/curve_side_file.h"
#include "filter_bspline_curve/common/curve_source.h"

#include <QFileInfo>
#include <QObject>
#include <QRegularExpression>
#include <QString>
#include <QTimer>
#include <algorithm>
#include <map>
#include <set>
#include <vector>

namespace bspline_curve {

namespace {

constexpr const char* kIsWatched = "bspline_curve_is_watched";
/// How often names of files are looked at, in milliseconds: where a project is saved with all its
/// files, MeshLab 2025.07 logs nothing.
constexpr int kLookEvery = 1000;

/// A child of the document's log, and ends with it.
class SaveWatcher : public QObject {
public:
    explicit SaveWatcher(MeshDocument& document)
        : QObject(&document.Log),
          document_(document),
          logged_(document.Log.logStringList().size()) {
        for (const MeshModel* const layer : host::layersOf(document_)) {
            files_[layer->id()] = layer->fullName();
        }
        // Later, when the layer has the name of its file.
        connect(
            &document.Log, &GLLogStream::logUpdated, this, [this] { look(); }, Qt::QueuedConnection
        );
        auto* const timer = new QTimer(this);
        connect(timer, &QTimer::timeout, this, [this] { look(); });
        timer->start(kLookEvery);
    }

private:
    void look() {
        const std::set<QString> saved = newlySaved();
        std::map<QString, std::vector<const MeshModel*>> layers;
        for (const MeshModel* const layer : host::layersOf(document_)) {
            const QString file = layer->fullName();
            QString& known = files_[layer->id()];
            if (file != known && !wasReadFrom(*layer, file)) {
                keep(*layer);
            } else if (saved.contains(file)) {
                layers[file].push_back(layer);
            }
            known = file;
        }
        for (const auto& [file, candidates] : layers) {
            keep(*likely(candidates));
        }
    }

    /// Files that the log names since the last look.
    std::set<QString> newlySaved() {
        static const QRegularExpression kSaved("^Saved Mesh (.*) in \\d+ msec$");
        const auto& lines = document_.Log.logStringList();
        std::set<QString> files;
        for (int i = std::min(logged_, lines.size()); i < lines.size(); ++i) {
            const QRegularExpressionMatch match = kSaved.match(lines[i].second);
            if (match.hasMatch()) {
                files.insert(QFileInfo(match.captured(1)).absoluteFilePath());
            }
        }
        logged_ = lines.size();
        return files;
    }

    static bool wasReadFrom(const MeshModel& layer, const QString& file) {
        const CurveSource* const source = sourceOf(layer);
        return source != nullptr && source->file == file.toStdString();
    }

    /// Of several layers with the same file, the one that was saved.
    [[nodiscard]] const MeshModel* likely(const std::vector<const MeshModel*>& candidates) const {
        for (const MeshModel* const layer : candidates) {
            if (layer == document_.mm()) {
                return layer;
            }
        }
        return candidates.back();
    }

    void keep(const MeshModel& layer) {
        const SavedLine line = writeSideFile(document_, layer);
        if (!line.text.empty()) {
            const auto level = line.isWarning ? GLLogStream::WARNING : GLLogStream::SYSTEM;
            host::log(document_, level, line.text);
        }
    }

    MeshDocument& document_;
    int logged_;                    // lines of the log that were looked at
    std::map<int, QString> files_;  // of each layer, when it was looked at
};

}  // namespace

void watchSaving(MeshDocument& document) {
    if (!document.Log.property(kIsWatched).toBool()) {
        document.Log.setProperty(kIsWatched, true);
        new SaveWatcher(document);
    }
}

}  // namespace bspline_curve
