package robotran.uikit

import androidx.compose.runtime.Composable
import androidx.compose.runtime.staticCompositionLocalOf
import androidx.compose.ui.platform.LocalClipboardManager

/** Reads the text that was copied last, and passes it on, perhaps later. */
fun interface ClipboardReader {
    /** @param take is not called if there is no text, or if the user does not let the app read it. */
    fun read(take: (String) -> Unit)
}

/** The reader of a platform whose clipboard answers later, such as a browser; null if it answers at once. */
val LocalClipboardReader = staticCompositionLocalOf<ClipboardReader?> { null }

@Composable
fun clipboardReader(): ClipboardReader {
    val clipboard = LocalClipboardManager.current
    return LocalClipboardReader.current ?: ClipboardReader { take -> clipboard.getText()?.text?.let(take) }
}
