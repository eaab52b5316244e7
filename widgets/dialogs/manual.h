// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QtWidgets>

namespace pixelplumb {

/// A page of the manual: a document of the program's own, or a text made from the window.
struct ManualPage {
    QString title;
    QString document; ///< in the resources, such as "glossary.md"; empty: the text counts
    QString html;
};

/// The manual, read without a network: a list of its pages beside the chosen one.
class Manual : public QDialog {
    Q_OBJECT

public:
    explicit Manual(const QList<ManualPage> &pages, QWidget *parent = nullptr);

    /// Turns to the page of a document, such as "glossary.md"; stays where there is none.
    void follow(const QUrl &link);

private:
    void showPage(int page);

    QList<ManualPage> m_pages;
    QListWidget *m_list;
    QTextBrowser *m_text;
};

/// The pages that are documents; `first`: those that come after the first one.
QList<ManualPage> manualPages(const QList<ManualPage> &first);

/// Every key of the window, read from its menus, so that the sheet never disagrees with the keys.
class KeySheet : public QDialog {
    Q_OBJECT

public:
    explicit KeySheet(const QList<QMenu *> &menus, QWidget *parent = nullptr);
};

/// A table per menu, a row per action that has a key.
QString keySheetHtml(const QList<QMenu *> &menus);

} // namespace pixelplumb
