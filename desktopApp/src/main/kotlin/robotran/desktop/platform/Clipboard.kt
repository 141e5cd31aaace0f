package robotran.desktop.platform

import robotran.workshop.platform.Sharing
import java.awt.Toolkit
import java.awt.datatransfer.StringSelection

/** The system clipboard. */
internal object Clipboard : Sharing {
    override suspend fun share(text: String): Boolean = try {
        Toolkit.getDefaultToolkit().systemClipboard.setContents(StringSelection(text), null)
        true
    } catch (_: IllegalStateException) {
        false // another app is using it
    }
}
