@file:OptIn(ExperimentalWasmJsInterop::class)

package robotran.web.window

import androidx.compose.ui.platform.ClipboardManager
import androidx.compose.ui.text.AnnotatedString

/**
 * The browser's clipboard. What a key copies goes the way of the browser's own events, which need no permission;
 * buttons ask the browser, which may ask the person.
 *
 * @param paste writes what a button has asked for, once the browser gives it.
 */
internal class PageClipboard(private val paste: (String) -> Unit) : ClipboardManager {
    private var isListening = false
    private var heard: String? = null

    override fun setText(annotatedString: AnnotatedString) {
        if (isListening) heard = annotatedString.text else copy(annotatedString.text)
    }

    /** Nothing at once: it comes later, through [paste]. */
    override fun getText(): AnnotatedString? {
        read(paste)
        return null
    }

    override fun hasText(): Boolean = true

    /** What [act] copies, null if nothing, and what it says. */
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

private fun read(take: (String) -> Unit): Unit =
    js("{ if (navigator.clipboard) navigator.clipboard.readText().then((text) => take(text)).catch(() => undefined); }")
