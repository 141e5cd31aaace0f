@file:OptIn(ExperimentalWasmJsInterop::class)

package robotran.web.window

import androidx.compose.ui.platform.ClipboardManager
import androidx.compose.ui.text.AnnotatedString
import robotran.uikit.*

/**
 * The browser's clipboard. Keys use the browser's clipboard events, which need no permission. Buttons use the clipboard
 * API, which may ask the user.
 *
 * @param paste receives the clipboard text requested by a button.
 */
internal class PageClipboard(private val paste: (String) -> Unit) :
    ClipboardManager,
    ClipboardReader {
    private var isListening = false
    private var heard: String? = null
    private var offered: String? = null

    override fun setText(annotatedString: AnnotatedString) {
        if (isListening) heard = annotatedString.text else copy(annotatedString.text)
    }

    /** Returns what is [offer]ed, otherwise nothing; then the text arrives later through [paste]. */
    override fun getText(): AnnotatedString? {
        offered?.let { return AnnotatedString(it) }
        readText(paste)
        return null
    }

    override fun read(take: (String) -> Unit) = readText(take)

    /** Lets [act] read [text]. */
    fun offer(text: String, act: () -> Unit) {
        offered = text
        act()
        offered = null
    }

    override fun hasText(): Boolean = true

    /** The text that [act] copies, null if none, and the result of [act]. */
    fun listen(act: () -> Boolean): Pair<String?, Boolean> {
        isListening = true
        heard = null
        val result = act()
        isListening = false
        return heard to result
    }
}

private fun copy(text: String): Unit =
    js("{ if (navigator.clipboard) navigator.clipboard.writeText(text).catch(() => undefined); }")

private fun readText(take: (String) -> Unit): Unit =
    js("{ if (navigator.clipboard) navigator.clipboard.readText().then((text) => take(text)).catch(() => undefined); }")
