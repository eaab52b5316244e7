// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/check/hardcase.h"
#include "tests/support/testprogram.h"

#include <QtTest>

namespace tst_shapecasefile {

using namespace pixelplumb;

namespace {

QByteArray caseFile(const QByteArray &members)
{
    return "{\"version\": 1, \"cases\": [{\"id\": \"a\", \"scale\": 2, \"canvas\": [9, 9], "
           "\"origin\": [0, 0], "
        + members + "}]}";
}

} // namespace

/// The members of a hard-case file that circles, polygons and attributes use.
class TestShapeCaseFile : public QObject {
    Q_OBJECT

private slots:
    void namesTheFaultOfACase_data()
    {
        QTest::addColumn<QByteArray>("members");
        QTest::addColumn<QString>("message");
        const QByteArray circle = R"("kind": "circle", "centre": [4, 4], )";
        const QByteArray polygon = R"("kind": "polygon", "fill": "even-odd", )";
        QTest::newRow("fill") << circle + R"("radius": 2, "fill": "round")"
                              << "cases[0].fill: “round”; expected one of even-odd, non-zero, "
                                 "outline";
        QTest::newRow("radius") << circle + R"("radius": -2, "fill": "outline")"
                                << "cases[0].radius: -2; expected 0 or more, and a circle within "
                                   "±1073741824 px";
        QTest::newRow("radius too large")
            << circle + R"("radius": 2147483647, "fill": "outline")"
            << "cases[0].radius: 2147483647; expected 0 or more, and a circle within "
               "±1073741824 px";
        QTest::newRow("no polygon") << polygon + R"("polygons": [])"
                                    << "cases[0].polygons: no polygon; expected 1 or more";
        QTest::newRow("no contour") << polygon + R"("polygons": [[]])"
                                    << "cases[0].polygons[0]: no contour; expected 1 or more";
        QTest::newRow("a contour of two vertices")
            << polygon + R"("polygons": [[[[0, 0], [4, 4]]]])"
            << "cases[0].polygons[0][0]: 2 vertices; expected 3 or more";
        QTest::newRow("an outlined polygon")
            << QByteArray(R"("kind": "polygon", "fill": "outline", "polygons": [])")
            << "cases[0].fill: “outline”; expected one of even-odd, non-zero";
        QTest::newRow("too few attributes")
            << attributes("[]", "{}")
            << "cases[0].attributes: an array of 0; expected an array of 3";
        QTest::newRow("no fraction")
            << attributes(corners, R"({"z": "1.5"})")
            << "cases[0].points[0].values.z: “1.5”; expected a fraction such as “85/42”";
        QTest::newRow("denominator 0")
            << attributes(corners, R"({"z": "1/0"})")
            << "cases[0].points[0].values.z: “1/0”; expected a fraction such as “85/42”";
        QTest::newRow("unknown value")
            << attributes(corners, R"({"w": "1"})")
            << "cases[0].points[0].values.w: “w”; expected a title of what is interpolated: R, G, "
               "B, z, u, v, N_x, N_y, N_z";
        QTest::newRow("good") << attributes(corners, R"({"N_x": "-1/3"})") << "no error";
    }
    void namesTheFaultOfACase()
    {
        QFETCH(QByteArray, members);
        QFETCH(QString, message);

        const Result<std::vector<HardCase>> cases = readHardCases(caseFile(members));

        const QString found = cases ? u"no error"_s : cases.error().message();
        QVERIFY2(found.endsWith(message), qPrintable(found));
    }

    void refusesALineOffTheLattice()
    {
        const QByteArray line = caseFile(R"("kind": "line", "endpoints": [[0, 0], [8, 1]], )"
                                         R"~("rule": "major axis, floor(minor + 1/2)")~");
        QVERIFY(readHardCases(line).isOk());

        const auto cases = readHardCases(QByteArray(line).replace("\"scale\": 2", "\"scale\": 3"));

        QVERIFY(!cases.isOk());
        QVERIFY(cases.error().message().endsWith(
            u"cases[0].endpoints: ends off the lattice; expected multiples of "
            "1/256 px"_s));
    }

private:
    static inline const QByteArray corners = R"([{"z": 1, "uv": [0, 0], "normal": [0, 0, 1]},
        {"z": 2, "uv": [0, 1], "normal": [0, 0, 1]}, {"z": 3, "uv": [1, 0], "normal": [0, 0, 1]}])";
    static QByteArray attributes(const QByteArray &ofCorners, const QByteArray &values)
    {
        return R"("kind": "attributes", "vertices": [[0, 0], [8, 0], [0, 8]], "attributes": )"
            + ofCorners
            + R"(, "points": [{"x": 1, "y": 1, "rgb": ["1", "1", "1"], "rgb8": [1, 1, 1], )"
              R"("values": )"
            + values + "}]";
    }
};

PIXELPLUMB_TEST(TestShapeCaseFile)

} // namespace tst_shapecasefile

#include "tst_shapecasefile.moc"
