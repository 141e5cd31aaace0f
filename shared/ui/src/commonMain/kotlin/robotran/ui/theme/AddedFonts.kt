package robotran.ui.theme

import androidx.compose.runtime.Composable
import androidx.compose.runtime.CompositionLocalProvider
import androidx.compose.runtime.staticCompositionLocalOf
import androidx.compose.ui.platform.LocalFontFamilyResolver
import androidx.compose.ui.text.font.FontFamily
import androidx.compose.ui.window.Dialog

/** What finds the fonts of all texts where a platform has added some to those of the window; null where it has not. */
val LocalAddedFonts = staticCompositionLocalOf<FontFamily.Resolver?> { null }

/**
 * [content] with the fonts of [LocalAddedFonts]. Compose gives every window, and every dialog and menu, which are
 * windows to it, fonts of its own: each that shows what somebody has written has to be told of the added ones.
 */
@Composable
fun WithAddedFonts(content: @Composable () -> Unit) {
    val fonts = LocalAddedFonts.current ?: LocalFontFamilyResolver.current
    CompositionLocalProvider(LocalFontFamilyResolver provides fonts, content = content)
}

/** A dialog that can show what somebody has written, in the fonts of [WithAddedFonts]. */
@Composable
internal fun AppDialog(onDismissRequest: () -> Unit, content: @Composable () -> Unit) =
    Dialog(onDismissRequest = onDismissRequest) { WithAddedFonts(content) }
