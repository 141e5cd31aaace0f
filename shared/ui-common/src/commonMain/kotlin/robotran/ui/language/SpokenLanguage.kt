package robotran.ui.language

import androidx.compose.runtime.Composable
import androidx.compose.runtime.CompositionLocalProvider
import androidx.compose.runtime.remember
import androidx.compose.ui.platform.LocalLayoutDirection
import androidx.compose.ui.unit.LayoutDirection
import robotran.language.Language
import robotran.uikit.*
import robotran.workshop.platform.appLanguage

/**
 * Sets the language of [content] to [language], or to the system language if null, and the direction in which it is read.
 */
@Composable
fun InLanguage(
    language: Language?,
    isRightToLeft: Boolean = appLanguage(language).isRightToLeft,
    content: @Composable () -> Unit,
) {
    remember(language) { speak(language?.tag) }
    CompositionLocalProvider(
        LocalLanguage provides appLanguage(language),
        LocalLayoutDirection provides if (isRightToLeft) LayoutDirection.Rtl else LayoutDirection.Ltr,
        content = content,
    )
}

/** Tells the platform's own dialogs and screen readers the language [tag], such as `de`, or the initial one if null. */
internal expect fun speak(tag: String?)
