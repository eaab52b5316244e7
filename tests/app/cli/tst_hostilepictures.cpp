// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/pictures/picture.h"
#include "core/scene/files/fileaccess.h"
#include "core/scene/files/picturereader.h"
#include "tests/support/programs/programrun.h"
#include "tests/support/testprogram.h"

#include <QBuffer>
#include <QImage>
#include <QTemporaryDir>
#include <QTemporaryFile>
#include <QTest>
#include <QtEndian>

#include <boost/crc.hpp>
#include <unistd.h>

#include <random>
#include <utility>

namespace tst_hostilepictures {

using namespace pixelplumb;

namespace {

struct Chunk {
    QByteArray type;
    QByteArray content;
};

QByteArray bytesOf(quint32 number)
{
    QByteArray bytes(4, '\0');
    qToBigEndian(number, bytes.data());
    return bytes;
}

QList<Chunk> chunksOf(const QByteArray &png)
{
    QList<Chunk> chunks;
    for (qsizetype at = 8; at + 12 <= png.size();) {
        const auto length = qsizetype(qFromBigEndian<quint32>(png.constData() + at));
        chunks.append({png.sliced(at + 4, 4), png.sliced(at + 8, length)});
        at += 12 + length;
    }
    return chunks;
}

QByteArray pngOf(const QList<Chunk> &chunks)
{
    QByteArray png("\x89PNG\r\n\x1a\n", 8);
    for (const Chunk &chunk : chunks) {
        const QByteArray checked = chunk.type + chunk.content;
        boost::crc_32_type check;
        check.process_bytes(checked.constData(), std::size_t(checked.size()));
        png += bytesOf(quint32(chunk.content.size())) + checked + bytesOf(check.checksum());
    }
    return png;
}

QImage picture()
{
    QImage image(23, 17, QImage::Format_ARGB32);
    for (int y = 0; y < 17; ++y) {
        for (int x = 0; x < 23; ++x)
            image.setPixel(x, y, qRgba(x * 10, y * 13, x * y % 256, 255 - x));
    }
    return image;
}

QByteArray pngOf(QImage::Format format)
{
    QByteArray png;
    QBuffer buffer(&png);
    picture().convertToFormat(format).save(&buffer, "png");
    return png;
}

QByteArray bmp()
{
    QByteArray bmp;
    QBuffer buffer(&bmp);
    picture().convertToFormat(QImage::Format_RGB888).save(&buffer, "bmp");
    return bmp;
}

/// What is written to standard error while it lives.
class WrittenErrors {
public:
    WrittenErrors()
        : m_before(dup(STDERR_FILENO))
    {
        m_file.open();
        dup2(m_file.handle(), STDERR_FILENO);
    }
    ~WrittenErrors() { end(); }
    Q_DISABLE_COPY_MOVE(WrittenErrors)

    QByteArray end()
    {
        if (m_before >= 0) {
            dup2(m_before, STDERR_FILENO);
            close(std::exchange(m_before, -1));
        }
        m_file.seek(0);
        return m_file.readAll();
    }

private:
    QTemporaryFile m_file;
    int m_before;
};

/// Damages chunks as a bad disk, a bad encoder or a bad person would; the checksums are right.
QByteArray damaged(QByteArray png, std::mt19937 &random)
{
    static const QList<QByteArray> types
        = {"PLTE", "tRNS", "gAMA", "cHRM", "sRGB", "iCCP", "sBIT",    "bKGD", "hIST", "pHYs",
           "tIME", "tEXt", "zTXt", "iTXt", "ABCD", "abcd", "a\x1b[m", "IEND", "IHDR"};
    const auto below = [&random](qsizetype end) { return qsizetype(random() % unsigned(end)); };
    QList<Chunk> chunks = chunksOf(png);
    for (qsizetype times = 1 + below(2); times > 0; --times) {
        Chunk &chunk = chunks[below(chunks.size())];
        switch (below(6)) {
        case 0:
            chunks.insert(below(chunks.size() + 1), Chunk(chunk));
            break;
        case 1:
            chunks.insert(below(chunks.size() + 1),
                          Chunk{types[below(types.size())], QByteArray(below(40), char(random()))});
            break;
        case 2:
            if (!chunk.content.isEmpty())
                chunk.content[below(chunk.content.size())] = char(random());
            break;
        case 3:
            chunk.content.truncate(below(chunk.content.size() + 1));
            break;
        case 4:
            chunk.type[below(4)] = char(random() % 128);
            break;
        case 5:
            chunks.swapItemsAt(below(chunks.size()), below(chunks.size()));
            break;
        }
    }
    return pngOf(chunks);
}

} // namespace

/// Pictures that somebody else made, and large ones that we did.
class TestHostilePictures : public QObject {
    Q_OBJECT

private slots:
    void aDecoderNeverWritesToTheTerminal()
    {
        constexpr int tries = 1500;
        std::mt19937 random(1);
        int decoded = 0, refused = 0;
        for (const QImage::Format format :
             {QImage::Format_RGB32, QImage::Format_ARGB32, QImage::Format_Indexed8,
              QImage::Format_Mono, QImage::Format_Grayscale16, QImage::Format_RGBA64}) {
            const QByteArray whole = pngOf(format);
            for (int i = 0; i < tries / 6; ++i) {
                const QByteArray png = damaged(whole, random);
                WrittenErrors errors;
                const bool isDecoded = parsePicture(png, u"p"_s).isOk();
                const QByteArray written = errors.end();
                QVERIFY2(written.isEmpty(), written.constData());
                ++(isDecoded ? decoded : refused);
            }
        }
        QVERIFY2(decoded > 50 && refused > 200, qPrintable(u"%1, %2"_s.arg(decoded).arg(refused)));
    }

    void aBmpWithItsLinesFromTheTopDownIsReadAsAnyOther()
    {
        const QByteArray upwards = bmp();
        constexpr int header = 54, line = 72; // 23 pixels of 3 bytes, padded
        QByteArray downwards = upwards.first(header);
        qToLittleEndian<qint32>(-17, downwards.data() + 22);
        for (int i = 16; i >= 0; --i)
            downwards += upwards.sliced(header + i * line, line);
        PictureReader reader(downwards);
        QCOMPARE(reader.size(), QSize(23, 17));
        QCOMPARE(parsePicture(downwards, {})->colours, parsePicture(upwards, {})->colours);
    }

    void aBmpThatMayLeavePixelsOutIsRefused()
    {
        QByteArray compressed = bmp();
        compressed[30] = 1; // runs of 8 bits
        QCOMPARE(parsePicture(compressed, u"p"_s).error().message(),
                 u"p: no picture: a compressed BMP, in which pixels may be left out; "
                 "save it uncompressed; expected a whole file"_s);
        QByteArray offset = bmp().first(60);
        qToLittleEndian<qint32>(1078, offset.data() + 10);
        QVERIFY(parsePicture(offset, {})
                    .error()
                    .message()
                    .contains(u"1224 of 1224 bytes of pixels are missing"));
    }

    void theBitsOfAPbmNeedNoSpacesBetweenThem()
    {
        const auto spaced = parsePicture("P1\n# b\n4 2\n0 1 1 0\n1 0 0 1\n", {});
        QVERIFY(spaced);
        for (const char *text :
             {"P1\n4 2\n0110\n1001\n", "P1 4 2 01101001", "P1\n4 2\n0 11# c\n01001"}) {
            const auto read = parsePicture(text, {});
            QVERIFY2(read, text);
            QCOMPARE(read->colours, spaced->colours);
        }
    }

    void coloursAreThoseThatAreStored_data()
    {
        QTest::addColumn<QImage::Format>("format");
        QTest::newRow("colours") << QImage::Format_RGB32;
        QTest::newRow("transparent") << QImage::Format_ARGB32;
        QTest::newRow("palette") << QImage::Format_Indexed8;
        QTest::newRow("bits") << QImage::Format_Mono;
        QTest::newRow("grey") << QImage::Format_Grayscale8;
        QTest::newRow("grey of two bytes") << QImage::Format_Grayscale16;
        QTest::newRow("two bytes") << QImage::Format_RGBA64;
    }
    /// Neither a gamma nor a broken remark changes anything.
    void coloursAreThoseThatAreStored()
    {
        QFETCH(QImage::Format, format);
        const QByteArray png = pngOf(format);
        QList<Chunk> chunks = chunksOf(png);
        chunks.insert(1, Chunk{"gAMA", bytesOf(100'000)});
        chunks.insert(2, Chunk{"tEXt", "broken"});

        PictureReader reader(pngOf(chunks));
        const QImage read = reader.read();

        QCOMPARE(reader.fault(), QString());
        QCOMPARE(read.convertToFormat(QImage::Format_ARGB32),
                 QImage::fromData(png).convertToFormat(QImage::Format_ARGB32));
    }

    void brokenOnesAreNamed_data()
    {
        QTest::addColumn<QByteArray>("png");
        QTest::addColumn<QString>("fault");
        const auto row = [](const char *name, const auto &change, const char *fault) {
            QList<Chunk> chunks = chunksOf(pngOf(QImage::Format_RGB32));
            change(chunks);
            QTest::newRow(name) << pngOf(chunks) << QString::fromUtf8(fault);
        };
        using Chunks = QList<Chunk>;
        row(
            "no width", [](Chunks &chunks) { chunks[0].content.replace(0, 4, bytesOf(0)); },
            "a broken PNG: Invalid IHDR data");
        row(
            "too wide", [](Chunks &chunks) { chunks[0].content.replace(0, 4, bytesOf(2'000'000)); },
            "a broken PNG: Invalid IHDR data");
        row(
            "another filter method", [](Chunks &chunks) { chunks[0].content[11] = 1; },
            "a broken PNG: Invalid IHDR data");
        row(
            "two headers", [](Chunks &chunks) { chunks.insert(1, Chunk(chunks[0])); },
            "a broken PNG: IHDR: out of place");
        row(
            "an unknown chunk",
            [](Chunks &chunks) {
                chunks.insert(1, Chunk{"ABCD", {}});
            },
            "a broken PNG: ABCD: unhandled critical chunk");
        row(
            "two palettes",
            [](Chunks &chunks) {
                chunks.insert(1, Chunk{"PLTE", "123"});
                chunks.insert(1, Chunk{"PLTE", "123"});
            },
            "a broken PNG: PLTE: duplicate");
        const auto deflated = [](Chunks &chunks, const QByteArray &pixels) {
            chunks.removeIf([](const Chunk &chunk) { return chunk.type != "IHDR"; });
            chunks.append(Chunk{"IDAT", qCompress(pixels).sliced(4)});
            chunks.append(Chunk{"IEND", {}});
        };
        constexpr qsizetype line = 1 + 3 * 23;
        row(
            "an unknown filter",
            [&](Chunks &chunks) {
                QByteArray pixels(17 * line, '\0');
                pixels[5 * line] = 5;
                deflated(chunks, pixels);
            },
            "a broken PNG: bad adaptive filter value");
        row(
            "more pixels than lines, which are left out",
            [&](Chunks &chunks) { deflated(chunks, QByteArray(1'000'000, '\0')); }, "");
        row(
            "cut short", [&](Chunks &chunks) { deflated(chunks, QByteArray(16 * line, '\0')); },
            "a broken PNG: Not enough image data");
        row(
            "whole", [&](Chunks &chunks) { deflated(chunks, QByteArray(17 * line, '\0')); }, "");
    }
    void brokenOnesAreNamed()
    {
        QFETCH(QByteArray, png);
        PictureReader reader(png);
        const bool isWhole = !reader.read().isNull();
        QCOMPARE(isWhole, reader.fault().isEmpty());
        QTEST(reader.fault(), "fault");
    }

    /// Qt's own limit is 2^26 pixels.
    void aLargePictureThatWasDrawnIsReadBack_data()
    {
        QTest::addColumn<QString>("suffix");
        for (const char *suffix : {"png", "ppm"})
            QTest::newRow(suffix) << QString::fromLatin1(suffix);
    }
    void aLargePictureThatWasDrawnIsReadBack()
    {
        QFETCH(QString, suffix);
        const QTemporaryDir folder;
        const QString scene = folder.filePath(u"large.json"_s);
        const QString drawn = folder.filePath(u"large."_s + suffix);
        // As PPM it has 300 MiB, more than a scene may.
        QVERIFY(!writeFile(scene, sceneOfSize(10'240, 10'240)));
        QCOMPARE(run({"render", scene, "-o", drawn}).exitCode, 0);

        const ProgramRun compared = run({"diff", drawn, drawn});

        QVERIFY2(compared.exitCode == 0, compared.messages.constData());
        QCOMPARE(compared.messages, QByteArray());
    }
};

PIXELPLUMB_TEST(TestHostilePictures)

} // namespace tst_hostilepictures

#include "tst_hostilepictures.moc"
