// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/inspect/coordinatedelegate.h"

#include "core/scene/coordinatetext.h"
#include "widgets/model/scenedocument.h"

#include <QLineEdit>
#include <QValidator>

namespace pixelplumb {

namespace {

/// Accepts input that is no coordinate yet, since it may become one; on Enter the error is
/// reported.
class CoordinateValidator final : public QValidator {
public:
    CoordinateValidator(SceneDocument *document, QObject *parent)
        : QValidator(parent)
        , m_document(document)
    {
    }

    State validate(QString &text, int &) const override
    {
        return parseCoordinate(text) ? Acceptable : Intermediate;
    }

    void fixup(QString &text) const override
    {
        if (const auto number = parseCoordinate(text); !number)
            emit m_document->refused(number.error().message());
    }

private:
    SceneDocument *m_document;
};

} // namespace

CoordinateDelegate::CoordinateDelegate(SceneDocument *document, QObject *parent)
    : QStyledItemDelegate(parent)
    , m_document(document)
{
}

QWidget *CoordinateDelegate::createEditor(QWidget *parent, const QStyleOptionViewItem &,
                                          const QModelIndex &index) const
{
    auto *field = new QLineEdit(parent);
    field->setObjectName(QStringLiteral("coordinateField"));
    field->setAccessibleName(index.model()->headerData(index.column(), Qt::Horizontal).toString());
    field->setValidator(new CoordinateValidator(m_document, field));
    field->setFrame(false);
    return field;
}

} // namespace pixelplumb
