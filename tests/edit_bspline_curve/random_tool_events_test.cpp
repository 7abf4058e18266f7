// SPDX-License-Identifier: GPL-3.0-or-later
// Any events in any order reach the tool in a host's window: no curve is lost whatever ends it, the
// mesh stays as it is to the last bit, and no key of the tool reaches the host's shortcuts.
#include "host_window.h"
#include "offscreen_context.h"
#include "support/many_cases.h"
#include "support/meshes.h"
#include "support/random.h"

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QApplication>
#include <QColorDialog>
#include <QComboBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QMdiArea>
#include <QMdiSubWindow>
#include <QMessageBox>
#include <QMouseEvent>
#include <QPushButton>
#include <QSettings>
#include <QSlider>
#include <QSpinBox>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <QWheelEvent>
#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <sstream>
#include <string>

namespace bspline_curve {
namespace {

using namespace test_support;

/// Of each sequence.
constexpr int kEvents = 40;
/// Nothing that is computed for these small meshes takes as long, sanitized and on a busy machine.
constexpr std::chrono::seconds kPatient(60);

/// A pick comes back from its layer to within this: a layer keeps places of the curve.
constexpr double kSamePlace = 1e-12;

struct Key {
    Qt::Key key;
    Qt::KeyboardModifiers modifiers = Qt::NoModifier;
};

/// Those of the guide, and ways to delete that a host may have.
const std::array kToolKeys = {
    Key{Qt::Key_A},
    Key{Qt::Key_A},
    Key{Qt::Key_M},
    Key{Qt::Key_Period},
    Key{Qt::Key_Comma},
    Key{Qt::Key_K},
    Key{Qt::Key_C},
    Key{Qt::Key_N},
    Key{Qt::Key_X},
    Key{Qt::Key_T},
    Key{Qt::Key_Delete},
    Key{Qt::Key_Backspace},
    Key{Qt::Key_Delete, Qt::ShiftModifier},
    Key{Qt::Key_Delete, Qt::ControlModifier},
    Key{Qt::Key_Delete, Qt::ControlModifier | Qt::ShiftModifier},
    Key{Qt::Key_Z, Qt::ControlModifier},
    Key{Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier},
    Key{Qt::Key_Y, Qt::ControlModifier},
    Key{Qt::Key_Return},
    Key{Qt::Key_Enter, Qt::KeypadModifier},
    Key{Qt::Key_Escape},
};

/// Of others that fields or the host may take.
const std::array kOtherKeys = {
    Key{Qt::Key_Tab}, Key{Qt::Key_1}, Key{Qt::Key_Up}, Key{Qt::Key_Q}, Key{Qt::Key_Shift}
};

template <class List>
const auto& anyOf(const List& list, Random& random) {
    return list[random.integer(0, static_cast<int>(list.size()) - 1)];
}

/// Answers whatever asks, while it asks.
class Answers {
public:
    explicit Answers(Random& random) : random_(random) {
        QObject::connect(&timer_, &QTimer::timeout, &timer_, [this] { answer(); });
        timer_.start(1);
    }

    bool wereSaved = false;    ///< curves, to a file
    bool wereGivenUp = false;  ///< by their user

private:
    void answer() {
        if (QWidget* const popup = QApplication::activePopupWidget()) {
            popup->close();
        }
        QWidget* const asking = QApplication::activeModalWidget();
        if (auto* const box = qobject_cast<QMessageBox*>(asking)) {
            const QList<QAbstractButton*> buttons = box->buttons();
            QAbstractButton* const chosen = buttons[random_.integer(0, buttons.size() - 1)];
            wereGivenUp |= box->buttonRole(chosen) == QMessageBox::DestructiveRole;
            chosen->click();
        } else if (auto* const file = qobject_cast<QFileDialog*>(asking)) {
            answerFile(*file);
        } else if (auto* const dialog = qobject_cast<QDialog*>(asking)) {
            dialog->done(random_.integer(0, 1));
        }
    }

    void answerFile(QFileDialog& dialog) {
        const QString path = folder_.filePath("curves.json");
        const bool saves = dialog.acceptMode() == QFileDialog::AcceptSave;
        if (random_.integer(0, 2) == 0 || (!saves && !QFileInfo::exists(path))) {
            dialog.reject();
            return;
        }
        QFile::remove(saves ? path : QString());  // nothing asks whether to replace it
        dialog.selectFile(path);
        wereSaved |= saves;
        static_cast<QDialog&>(dialog).done(QDialog::Accepted);
    }

    Random& random_;
    QTimer timer_;
    QTemporaryDir folder_;
};

bool waitFor(const std::function<bool()>& isSo) {
    const auto end = std::chrono::steady_clock::now() + kPatient;
    while (!isSo()) {
        if (std::chrono::steady_clock::now() > end) {
            return false;
        }
        QApplication::processEvents(QEventLoop::AllEvents | QEventLoop::WaitForMoreEvents);
    }
    return true;
}

bool areSame(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
    return std::ranges::equal(a, b, [](const Vec3& p, const Vec3& q) {
        return (p - q).norm() <= kSamePlace;
    });
}

PicksOfCurves picksOf(const Sketch& sketch) {
    PicksOfCurves curves;
    for (const std::shared_ptr<SketchCurve>& curve : sketch.curves) {
        curves.push_back(curve->positions());
    }
    return curves;
}

std::string describe(const std::vector<Vec3>& points) {
    std::ostringstream text;
    text.precision(17);
    for (const Vec3& point : points) {
        text << "(" << point.transpose() << ") ";
    }
    return text.str();
}

std::string describeAll(const PicksOfCurves& curves) {
    std::string text;
    for (const std::vector<Vec3>& curve : curves) {
        text += "\n  " + describe(curve);
    }
    return text;
}

/// One sequence of events in a window.
class Sequence {
public:
    Sequence(const TriangleMesh& mesh, int seed)
        : random_(seed),
          answers_(random_),
          mesh_(mesh),
          host_(std::make_unique<HostWindow>(mesh, random_.point(-1.0, 1.0))),
          bytes_(host_->bytesOfSurface()) {}

    void run() {
        begin();
        for (int i = 0; i < kEvents && host_ && !testing::Test::HasFailure(); ++i) {
            event();
            if (!host_) {
                return;
            }
            checkAlways();
            if (host_->tool() == nullptr) {
                checkEnd();
                begin();
            }
        }
        end();
    }

private:
    // ---- Events ----

    void begin() {
        if (host_->document().size() == 0 || host_->tool() != nullptr) {
            return;
        }
        host_->startTool();
        ASSERT_TRUE(host_->tool() != nullptr);
        if (random_.integer(0, 9) > 0) {  // else it ends, or has events, before it is prepared
            prepare();
        }
    }

    void prepare() {
        ASSERT_TRUE(waitFor([&] {
            host_->startTool();  // an end that was asked for before may come now
            return host_->session() != nullptr;
        }));
        host_->view().repaint();  // so that it knows where things are
    }

    [[nodiscard]] QPoint place() {
        const DrawingSession* const session = host_->session();
        if (session != nullptr && !session->sketch().curves.empty() && random_.integer(0, 1) == 0) {
            const auto& curve = *anyOf(session->sketch().curves, random_);
            return host_->view().placeOf(anyOf(curve.picks, random_).position) +
                   QPoint(random_.integer(-6, 6), random_.integer(-6, 6));
        }
        if (random_.integer(0, 9) == 0) {
            return {random_.integer(0, host_->view().width()), 0};  // beside the mesh
        }
        return host_->view().placeOf(anyOf(mesh_.vertices, random_));
    }

    void mouse(QEvent::Type type) {
        HostView& view = host_->view();
        const QPoint at = place();
        const int which = random_.integer(0, 11);
        const Qt::MouseButton button = which == 0   ? Qt::RightButton
                                       : which == 1 ? Qt::MiddleButton
                                                    : Qt::LeftButton;
        const int held = random_.integer(0, 7);
        const Qt::KeyboardModifiers modifiers = held == 0   ? Qt::ShiftModifier
                                                : held == 1 ? Qt::ControlModifier
                                                : held == 2 ? Qt::AltModifier
                                                            : Qt::NoModifier;
        const bool isMove = type == QEvent::MouseMove;
        QMouseEvent event(
            type,
            at,
            view.mapToGlobal(at),
            isMove ? Qt::NoButton : button,
            type == QEvent::MouseButtonRelease ? Qt::NoButton : button,
            modifiers
        );
        QApplication::sendEvent(&view, &event);
    }

    void wheel() {
        const QPoint at = place();
        QWheelEvent event(
            at,
            host_->view().mapToGlobal(at),
            {},
            {0, random_.integer(0, 1) == 0 ? 120 : -120},
            Qt::NoButton,
            Qt::NoModifier,
            Qt::NoScrollPhase,
            false
        );
        QApplication::sendEvent(&host_->view(), &event);
    }

    void press(const Key& key) {
        QWidget* const focus = QApplication::focusWidget();
        QTest::keyClick(focus != nullptr ? focus : &host_->view(), key.key, key.modifiers);
    }

    // Whatever can be clicked or changed in the panel.
    void usePanel() {
        auto* const panel = host_->findChild<ToolPanel*>();
        if (panel == nullptr) {
            return;
        }
        std::vector<QWidget*> parts;
        for (QWidget* const part : panel->findChildren<QWidget*>()) {
            if (part->isEnabled() && part->isVisibleTo(panel)) {
                parts.push_back(part);
            }
        }
        QWidget* const part = anyOf(parts, random_);
        if (auto* const button = qobject_cast<QAbstractButton*>(part)) {
            button->click();
        } else if (auto* const box = qobject_cast<QAbstractSpinBox*>(part)) {
            box->stepBy(random_.integer(-1, 1));
        } else if (auto* const slider = qobject_cast<QSlider*>(part)) {
            slider->setValue(random_.integer(slider->minimum(), slider->maximum()));
        } else if (auto* const choice = qobject_cast<QComboBox*>(part)) {
            choice->setCurrentIndex(random_.integer(0, choice->count() - 1));
        }
    }

    void useList() {
        auto* const list = host_->findChild<CurveList*>();
        if (list == nullptr || list->topLevelItemCount() == 0) {
            return;
        }
        QTreeWidgetItem* const item =
            list->topLevelItem(random_.integer(0, list->topLevelItemCount() - 1));
        const int column = random_.integer(0, 2);
        switch (random_.integer(0, 2)) {
            case 0:
                item->setCheckState(
                    0, item->checkState(0) == Qt::Checked ? Qt::Unchecked : Qt::Checked
                );
                break;
            case 1:
                item->setText(2, QString("curve %1").arg(random_.integer(0, 9)));
                break;
            default:
                emit list->itemClicked(item, column);
        }
    }

    void moveFocus() {
        auto* const panel = host_->findChild<ToolPanel*>();
        std::vector<QWidget*> places = {&host_->view(), &host_->view(), &host_->field()};
        if (panel != nullptr) {
            for (QWidget* const part : panel->findChildren<QWidget*>()) {
                if (part->focusPolicy() != Qt::NoFocus) {
                    places.push_back(part);
                }
            }
        }
        anyOf(places, random_)->setFocus();
    }

    void changeLayers() {
        MeshDocument& document = host_->document();
        const std::vector<const MeshModel*> layers = host::layersOf(document);
        const int layer = anyOf(layers, random_)->id();
        const bool removes = random_.integer(0, 5) == 0 && layer != host_->surface();
        const DrawingSession* const session = host_->session();
        if (removes && session != nullptr) {
            host_->remove(layer);
        } else {
            host_->makeCurrent(layer);
        }
    }

    void event() {
        switch (random_.integer(0, 16)) {
            case 0:
            case 1:
            case 2:
                mouse(QEvent::MouseButtonPress);
                break;
            case 3:
            case 4:
                mouse(QEvent::MouseMove);
                break;
            case 5:
            case 6:
            case 7:
                mouse(QEvent::MouseButtonRelease);
                break;
            case 8:
                wheel();
                break;
            case 9:
            case 10:
            case 11:
                press(anyOf(kToolKeys, random_));
                break;
            case 12:
                random_.integer(0, 2) == 0 ? press(anyOf(kOtherKeys, random_)) : moveFocus();
                break;
            case 13:
                usePanel();
                break;
            case 14:
                useList();
                break;
            case 15:
                seldom();
                break;
            default:
                QApplication::processEvents();
        }
    }

    void seldom() {
        switch (random_.integer(0, 9)) {
            case 0:
            case 1:
            case 2:
                changeLayers();
                break;
            case 3: {
                QEvent leaves(QEvent::Leave);
                QApplication::sendEvent(&host_->view(), &leaves);
                break;
            }
            case 4:
                host_->escape().trigger();
                break;
            case 5:
                settle();
                break;
            case 6:
                end();
                break;
            default:
                QApplication::processEvents();
        }
    }

    void settle() {
        ASSERT_TRUE(waitFor([&] {
            const DrawingSession* const session = host_->session();
            return session == nullptr || session->isSettled() || session->isDragging();
        }));
    }

    // ---- Ends ----

    void end() {
        switch (random_.integer(0, 6)) {
            case 0:
                host_->endTool();
                break;
            case 1:
                if (auto* const panel = host_->findChild<ToolPanel*>()) {
                    panel->close();
                }
                QApplication::processEvents();
                break;
            case 2:
                closeDocument();
                break;
            case 3:
                useCurves();
                break;
            case 4:
                removeSurface();
                return;
            case 5:
                closeWindow();
                return;
            default:
                host_->document().addNewMesh("", "other", true);  // a host's filter ends the tool
                host_->endTool();
        }
        host_->endTool();
        checkEnd();
    }

    // The host asks, and its user goes on with the document.
    void closeDocument() { host_->findChild<QMdiArea*>()->subWindowList().front()->close(); }

    // Imprint, Cut or Segment.
    void useCurves() {
        const auto buttons = host_->findChild<ToolPanel*>()->findChildren<QAbstractButton*>();
        for (QAbstractButton* const button : buttons) {
            if (button->text() == "Imprint" && button->isEnabled()) {
                button->click();
            }
        }
        QApplication::processEvents();
    }

    void removeSurface() {
        if (host_->session() != nullptr) {
            settle();
        }
        if (host_->tool() == nullptr) {
            checkEnd();
            return;
        }
        const int surface = host_->surface();
        host_->remove(surface);
        ASSERT_TRUE(host_->lastEnd());
        // Layers stay, and all other curves that can be seen become polylines.
        EXPECT_GE(countOfLines(), host_->lastEnd()->settled);
        host_.reset();
    }

    void closeWindow() {
        answers_.wereGivenUp = false;
        const DrawingSession* const session = host_->session();
        const bool isDrawn = session != nullptr && !session->isDragging() &&  // which it ends
                             !session->sketch().curves.empty();
        if (host_->close()) {
            EXPECT_TRUE(!isDrawn || answers_.wereGivenUp || answers_.wereSaved);
            QMetaObject::invokeMethod(qApp, "aboutToQuit", Qt::DirectConnection);
            delete host_->findChild<ToolPanel*>();  // as the window's end does
            host_.reset();
            return;
        }
        checkAlways();
        // Where an end that was asked for before came during the question, there are layers.
        ASSERT_TRUE(host_->session() != nullptr || host_->tool() == nullptr);
        host_->endTool();
        checkEnd();
    }

    // ---- What must be true ----

    void checkAlways() {
        EXPECT_EQ(host_->firedShortcuts(), 0);
        if (host::layerWithId(host_->document(), host_->surface()) != nullptr) {
            EXPECT_TRUE(host_->bytesOfSurface() == bytes_);
        }
    }

    // The tool starts again with all that was drawn.
    void checkEnd() {
        checkAlways();
        const std::optional<EndState> last = host_->lastEnd();
        if (!last || !last->isSurfaceThere) {
            return;
        }
        host_->makeCurrent(host_->surface());
        host_->startTool();
        prepare();
        ASSERT_TRUE(host_->session() != nullptr);
        PicksOfCurves now = picksOf(host_->session()->sketch());
        int others = 0;
        for (const std::vector<Vec3>& curve : last->changing) {
            others += takeOut(now, curve) ? 0 : 1;
        }
        for (const std::vector<Vec3>& curve : last->curves) {
            EXPECT_TRUE(takeOut(now, curve))
                << "a curve of " << curve.size() << " picks is lost: " << describe(curve)
                << "; there are " << describeAll(now);
        }
        EXPECT_GE(static_cast<int>(now.size()), others);
    }

    // Whether it was among them.
    static bool takeOut(PicksOfCurves& curves, const std::vector<Vec3>& wanted) {
        const auto found =
            std::ranges::find_if(curves, [&](const auto& other) { return areSame(wanted, other); });
        if (found == curves.end()) {
            return false;
        }
        curves.erase(found);
        return true;
    }

    [[nodiscard]] int countOfLines() {
        return static_cast<int>(
            std::ranges::count_if(host::layersOf(host_->document()), [](const MeshModel* layer) {
                return layer->cm.en > 0;
            })
        );
    }

    Random random_;
    Answers answers_;
    const TriangleMesh& mesh_;
    std::unique_ptr<HostWindow> host_;
    std::vector<std::uint8_t> bytes_;
};

int numberOr(const char* variable, int standard) {
    const char* const asked = std::getenv(variable);
    return asked == nullptr ? standard : std::stoi(asked);
}

struct Ground {
    std::string name;
    TriangleMesh mesh;
};

std::ostream& operator<<(std::ostream& stream, const Ground& ground) {
    return stream << ground.name;
}

class RandomToolEvents : public testing::TestWithParam<Ground> {};

TEST_P(RandomToolEvents, LoseNothingAndReachNothingElse) {
    const OffscreenContext context(64, 64);
    if (!context.isThere()) {
        GTEST_SKIP() << "no context of OpenGL";
    }
    // For long runs: how many on each mesh, and from which seed on.
    const int count = numberOr("BSPLINE_CURVE_SEQUENCES", caseCount(30, 8));
    const int first = numberOr("BSPLINE_CURVE_FIRST_SEQUENCE", 1);
    for (int seed = first; seed < first + count && !HasFailure(); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        QSettings().clear();
        Sequence(GetParam().mesh, seed).run();
    }
}

INSTANTIATE_TEST_SUITE_P(
    All,
    RandomToolEvents,
    testing::Values(
        Ground{"Sphere", withNoise(icosphere(2), 0.01, 7)}, Ground{"Box", box(4, {1.0, 0.8, 0.6})}
    ),
    [](const auto& testInfo) { return testInfo.param.name; }
);

}  // namespace
}  // namespace bspline_curve

int main(int argc, char** argv) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    QCoreApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
    QStandardPaths::setTestModeEnabled(true);
    // Nobody's own; in memory where that can be, since Qt waits for the disk at each change.
    const QTemporaryDir settings(QDir("/dev/shm").exists() ? "/dev/shm/settings-XXXXXX" : "");
    QSettings::setDefaultFormat(QSettings::IniFormat);
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, settings.path());
    qInstallMessageHandler([](QtMsgType, const QMessageLogContext&, const QString&) {});
    const QApplication application(argc, argv);
    QCoreApplication::setOrganizationName("bspline_curve");
    QCoreApplication::setApplicationName("tool_tests");
    testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
