package robotran.ui.documents

import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import robotran.projects.localSite
import robotran.ui.school.tags.DocumentTags
import robotran.ui.school.texts.DocumentTexts
import robotran.ui.texts.CommonTexts
import robotran.uikit.*
import robotran.workshop.event.DocumentEvent
import robotran.workshop.state.DocumentDialog

@Composable
internal fun ShareLinkDialog(
    dialog: DocumentDialog.SharingLink,
    hasShareSheet: Boolean,
    onEvent: (DocumentEvent) -> Unit,
) {
    val close = { onEvent(DocumentEvent.DialogClosed) }
    val link = dialog.link
    val tooLong = dialog.tooLong
    Dialog(
        DocumentTexts.shareTitle(spoken),
        close,
        buttons = {
            Button(DocumentTexts.close(spoken), DocumentTags.DOCUMENT_CANCEL, ButtonKind.DIALOG_OTHER, onClick = close)
            if (link != null && hasShareSheet) {
                Button(DocumentTexts.shareElsewhere(spoken), DocumentTags.LINK_SHARE, ButtonKind.DIALOG_OTHER) {
                    onEvent(DocumentEvent.LinkShared)
                }
            }
            if (link != null) {
                val words = if (dialog.copied) DocumentTexts::copied else DocumentTexts::copy
                Button(words(spoken), DocumentTags.LINK_COPY, ButtonKind.DIALOG_MAIN) {
                    onEvent(DocumentEvent.LinkCopied)
                }
            }
        },
    ) {
        when {
            tooLong != null -> Explanation(tooLong, Modifier.testTag(DocumentTags.DOCUMENT_TROUBLE), bad = true)
            link == null -> Explanation(DocumentTexts.shareMaking(spoken))
            else -> LinkItself(link)
        }
    }
}

/** Offers to share the file if links have no base URL, and opens the setting for it. */
@Composable
internal fun ShareFileDialog(onEvent: (DocumentEvent) -> Unit) {
    val close = { onEvent(DocumentEvent.DialogClosed) }
    Dialog(
        DocumentTexts.shareFileTitle(spoken),
        close,
        buttons = {
            Button(DocumentTexts.close(spoken), DocumentTags.DOCUMENT_CANCEL, ButtonKind.DIALOG_OTHER, onClick = close)
            Button(DocumentTexts.shareSite(spoken), DocumentTags.SHARE_SITE, ButtonKind.DIALOG_OTHER) {
                onEvent(DocumentEvent.SiteRequested)
            }
            Button(CommonTexts.saveAs(spoken), DocumentTags.SHARE_SAVE_AS, ButtonKind.DIALOG_MAIN) {
                onEvent(DocumentEvent.SaveAsRequested)
            }
        },
    ) { Explanation(DocumentTexts.shareNoSite(spoken)) }
}

@Composable
private fun LinkItself(link: String) {
    val colours = LocalRobotranColours.current
    Explanation(DocumentTexts.shareHelp(spoken))
    LocalLinkNote(link)
    TextField(
        link,
        { },
        Modifier.fillMaxWidth().testTag(DocumentTags.LINK_TEXT),
        DocumentTexts.linkLabel(spoken),
        1..MAX_LINES,
        extras = FieldExtras(isReadOnly = true),
    )
    val length = DocumentTexts.shareLength(spoken, link.length)
    Text(
        length,
        Modifier.testTag(DocumentTags.LINK_LENGTH).announced(),
        TextStyles.small,
        color = colours.quiet,
    )
    if (link.length > LONG) Explanation(DocumentTexts.shareLong(spoken))
    LinkAsQrCode(link)
}

/** Says that nobody else can follow [link], a link or a text with one, if that is so. */
@Composable
internal fun LocalLinkNote(link: String) {
    val site = localSite(link) ?: return
    Explanation(DocumentTexts.shareLocal(spoken, site), Modifier.testTag(DocumentTags.LINK_LOCAL), bad = true)
}

private const val MAX_LINES = 3

/** Some mail programs and messengers break longer links. */
private const val LONG = 2_000
