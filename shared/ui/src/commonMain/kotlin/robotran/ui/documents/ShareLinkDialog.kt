package robotran.ui.documents

import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.material3.OutlinedTextField
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.LiveRegionMode
import androidx.compose.ui.semantics.liveRegion
import androidx.compose.ui.semantics.semantics
import org.jetbrains.compose.resources.stringResource
import robotran.projects.localSite
import robotran.ui.parts.fieldColours
import robotran.ui.resources.*
import robotran.ui.theme.LocalRobotranColours
import robotran.ui.theme.TextSizes
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
    DialogFrame(
        stringResource(Res.string.documents_share_title),
        close,
        buttons = {
            OtherButton(stringResource(Res.string.documents_close), "document-cancel", close)
            if (link != null && hasShareSheet) {
                OtherButton(stringResource(Res.string.documents_share_elsewhere), "link-share") {
                    onEvent(DocumentEvent.LinkShared)
                }
            }
            if (link != null) {
                val words = if (dialog.copied) Res.string.documents_copied else Res.string.documents_copy
                MainButton(stringResource(words), "link-copy") { onEvent(DocumentEvent.LinkCopied) }
            }
        },
    ) {
        when {
            tooLong != null -> Explanation(tooLong, Modifier.testTag("document-trouble"), bad = true)
            link == null -> Explanation(stringResource(Res.string.documents_share_making))
            else -> LinkItself(link)
        }
    }
}

/** Offers to share the file if links have no base URL, and opens the setting for it. */
@Composable
internal fun ShareFileDialog(onEvent: (DocumentEvent) -> Unit) {
    val close = { onEvent(DocumentEvent.DialogClosed) }
    DialogFrame(
        stringResource(Res.string.documents_share_file_title),
        close,
        buttons = {
            OtherButton(stringResource(Res.string.documents_close), "document-cancel", close)
            OtherButton(stringResource(Res.string.documents_share_site), "share-site") {
                onEvent(DocumentEvent.SiteRequested)
            }
            MainButton(stringResource(Res.string.documents_save_as), "share-save-as") {
                onEvent(DocumentEvent.SaveAsRequested)
            }
        },
    ) { Explanation(stringResource(Res.string.documents_share_no_site)) }
}

@Composable
private fun LinkItself(link: String) {
    val colours = LocalRobotranColours.current
    Explanation(stringResource(Res.string.documents_share_help))
    LocalLinkNote(link)
    OutlinedTextField(
        link,
        onValueChange = {},
        Modifier.fillMaxWidth().testTag("link-text"),
        readOnly = true,
        label = { Text(stringResource(Res.string.documents_link_label)) },
        maxLines = MAX_LINES,
        colors = fieldColours(),
    )
    val length = stringResource(Res.string.documents_share_length, link.length)
    Text(
        length,
        Modifier.testTag("link-length").semantics {
            liveRegion = LiveRegionMode.Polite
        },
        color = colours.quiet,
        fontSize = TextSizes.SMALL,
    )
    if (link.length > LONG) Explanation(stringResource(Res.string.documents_share_long))
    LinkAsQrCode(link)
}

/** Says that nobody else can follow [link], a link or a text with one, if that is so. */
@Composable
internal fun LocalLinkNote(link: String) {
    val site = localSite(link) ?: return
    Explanation(stringResource(Res.string.documents_share_local, site), Modifier.testTag("link-local"), bad = true)
}

private const val MAX_LINES = 3

/** Some mail programs and messengers break longer links. */
private const val LONG = 2_000
