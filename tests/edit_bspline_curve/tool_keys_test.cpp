// SPDX-License-Identifier: GPL-3.0-or-later
#include "edit_bspline_curve/common/tool_keys.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QKeyEvent>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>
#include <vector>

namespace bspline_curve {
namespace {

QKeyEvent keyEvent(int key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    return {QEvent::KeyPress, key, modifiers};
}

std::optional<ToolKey> meaning(int key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    return toolKeyOf(keyEvent(key, modifiers));
}

TEST(ToolKeys, MeanWhatTheGuideSays) {
    const std::vector<std::pair<int, SketchKey>> plain = {
        {Qt::Key_A, SketchKey::Add},
        {Qt::Key_M, SketchKey::Move},
        {Qt::Key_Period, SketchKey::Next},
        {Qt::Key_Comma, SketchKey::Previous},
        {Qt::Key_K, SketchKey::NextCurve},
        {Qt::Key_C, SketchKey::Close},
        {Qt::Key_N, SketchKey::NewCurve},
        {Qt::Key_T, SketchKey::Kind},
        {Qt::Key_X, SketchKey::Cancel},
        {Qt::Key_Delete, SketchKey::Remove},
        {Qt::Key_Backspace, SketchKey::Remove},
    };
    for (const auto& [key, means] : plain) {
        const auto found = meaning(key);
        ASSERT_TRUE(found) << key;
        EXPECT_EQ(found->action, ToolKey::Action::Sketch) << key;
        EXPECT_EQ(found->sketch, means) << key;
    }
    EXPECT_EQ(meaning(Qt::Key_Z, Qt::ControlModifier)->sketch, SketchKey::Undo);
    EXPECT_EQ(meaning(Qt::Key_Y, Qt::ControlModifier)->sketch, SketchKey::Redo);
    EXPECT_EQ(meaning(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier)->sketch, SketchKey::Redo);
    EXPECT_EQ(meaning(Qt::Key_Return)->action, ToolKey::Action::MakeLayers);
    EXPECT_EQ(meaning(Qt::Key_Enter, Qt::KeypadModifier)->action, ToolKey::Action::MakeLayers);
    EXPECT_EQ(meaning(Qt::Key_Escape)->action, ToolKey::Action::TurnView);
}

TEST(ToolKeys, LeaveNoWayToDeleteElseToTheHost) {
    for (const int key : {Qt::Key_Delete, Qt::Key_Backspace}) {
        for (const auto modifiers :
             {Qt::KeyboardModifiers(Qt::ShiftModifier),
              Qt::KeyboardModifiers(Qt::ControlModifier),
              Qt::ShiftModifier | Qt::ControlModifier,
              Qt::KeyboardModifiers(Qt::AltModifier)}) {
            ASSERT_TRUE(meaning(key, modifiers));
            EXPECT_EQ(meaning(key, modifiers)->action, ToolKey::Action::Nothing);
        }
    }
}

TEST(ToolKeys, LeaveAllOthersToTheHost) {
    for (const int key : {Qt::Key_F1, Qt::Key_Tab, Qt::Key_Q, Qt::Key_S, Qt::Key_Space}) {
        EXPECT_FALSE(meaning(key)) << key;
    }
    for (const int key : {Qt::Key_A, Qt::Key_C, Qt::Key_N, Qt::Key_X, Qt::Key_M, Qt::Key_K}) {
        EXPECT_FALSE(meaning(key, Qt::ControlModifier)) << key;
        EXPECT_FALSE(meaning(key, Qt::AltModifier)) << key;
    }
    EXPECT_FALSE(meaning(Qt::Key_Return, Qt::AltModifier));  // MeshLab's full screen
}

class KeysInAWindow : public testing::Test {
protected:
    KeysInAWindow() : panel_(&window_) {
        for (QWidget* const widget : std::vector<QWidget*>{&own_, &choice_, &button_}) {
            widget->setParent(&panel_);
        }
        hosts_.setParent(&window_);
    }

    [[nodiscard]] bool isOurs(
        int key, const QWidget* focus, Qt::KeyboardModifiers modifiers = {}
    ) const {
        return isForTool(*meaning(key, modifiers), focus, panel_);
    }

    QWidget window_;
    QWidget panel_;
    QDoubleSpinBox own_;
    QComboBox choice_;
    QPushButton button_;
    QLineEdit hosts_;
};

TEST_F(KeysInAWindow, AreTheToolsButWhereSomethingIsTyped) {
    EXPECT_TRUE(isOurs(Qt::Key_Delete, nullptr));
    EXPECT_TRUE(isOurs(Qt::Key_Delete, &window_));
    EXPECT_TRUE(isOurs(Qt::Key_Return, &button_));
    EXPECT_FALSE(isOurs(Qt::Key_Delete, &hosts_));
    EXPECT_FALSE(isOurs(Qt::Key_Z, &hosts_, Qt::ControlModifier));
    EXPECT_FALSE(isOurs(Qt::Key_Delete, &own_));
    EXPECT_FALSE(isOurs(Qt::Key_Period, &own_));
    EXPECT_FALSE(isOurs(Qt::Key_Return, &own_));
    EXPECT_FALSE(isOurs(Qt::Key_A, &choice_));  // chooses what begins so
    EXPECT_TRUE(isOurs(Qt::Key_Return, &choice_));
    // Letters are no numbers, and undo is the tool's wherever its user is in the panel.
    EXPECT_TRUE(isOurs(Qt::Key_N, &own_));
    EXPECT_TRUE(isOurs(Qt::Key_Z, &own_, Qt::ControlModifier));
    EXPECT_TRUE(isOurs(Qt::Key_Z, &choice_, Qt::ControlModifier));
}

}  // namespace
}  // namespace bspline_curve

int main(int argc, char** argv) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    const QApplication application(argc, argv);
    testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
