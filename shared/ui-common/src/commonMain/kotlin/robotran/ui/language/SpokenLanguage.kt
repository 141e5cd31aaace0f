package robotran.ui.language

import androidx.compose.runtime.Composable
import androidx.compose.runtime.CompositionLocalProvider
import androidx.compose.runtime.remember
import robotran.language.Language
import robotran.uikit.*
import robotran.workshop.platform.appLanguage

/** Sets the language of [content] to [language], or to the system language if null. */
@Composable
fun InLanguage(language: Language?, content: @Composable () -> Unit) {
    remember(language) { speak(language?.tag) }
    CompositionLocalProvider(LocalLanguage provides appLanguage(language), content)
}

/** Tells the platform's own dialogs and screen readers the language [tag], such as `de`, or the initial one if null. */
internal expect fun speak(tag: String?)
