package robotran.uikit

import androidx.compose.runtime.Composable
import androidx.compose.runtime.CompositionLocalProvider
import androidx.compose.runtime.staticCompositionLocalOf
import androidx.compose.ui.platform.LocalFontFamilyResolver
import androidx.compose.ui.text.font.FontFamily

/** The font resolver with fonts added by the platform; null if it has none. */
val LocalAddedFonts = staticCompositionLocalOf<FontFamily.Resolver?> { null }

/**
 * [content] with the fonts of [LocalAddedFonts]. In Compose each window, dialog and menu has its own fonts, so each one
 * that shows user text needs this.
 */
@Composable
fun WithAddedFonts(content: @Composable () -> Unit) {
    val fonts = LocalAddedFonts.current ?: LocalFontFamilyResolver.current
    CompositionLocalProvider(LocalFontFamilyResolver provides fonts, content = content)
}
