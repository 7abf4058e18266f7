// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <QJsonObject>
#include <QPluginLoader>
#include <QString>

namespace {

QString metadata(const char* file, const char* key) {
    const QPluginLoader loader(QString(PLUGIN_FOLDER "/") + file);
    return loader.metaData().value(key).toString();
}

struct Plugin {
    const char* file;
    const char* interface;
    const char* className;
};

class PluginMetadata : public testing::TestWithParam<Plugin> {};

TEST_P(PluginMetadata, NamesTheInterfaceThatItsHostLooksFor) {
    EXPECT_EQ(metadata(GetParam().file, "IID"), GetParam().interface);
    EXPECT_EQ(metadata(GetParam().file, "className"), GetParam().className);
}

INSTANTIATE_TEST_SUITE_P(
    Hosts,
    PluginMetadata,
    testing::Values(
        Plugin{
            "libfilter_bspline_curve.so", "vcg.meshlab.FilterPlugin/1.0", "FilterBsplineCurvePlugin"
        },
        Plugin{
            "meshlab-2022.02/libfilter_bspline_curve.so",
            "vcg.meshlab.FilterPlugin/1.0",
            "FilterBsplineCurvePlugin"
        },
        Plugin{
            "meshlab-2020.09/libfilter_bspline_curve_legacy.so",
            "vcg.meshlab.MeshFilterInterface/1.0",
            "FilterBsplineCurveLegacyPlugin"
        }
    )
);

}  // namespace
