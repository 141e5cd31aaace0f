package robotran.ui.language

import androidx.compose.runtime.Composable
import androidx.compose.runtime.CompositionLocalProvider
import androidx.compose.runtime.key
import androidx.compose.runtime.remember
import androidx.compose.runtime.staticCompositionLocalOf
import org.jetbrains.compose.resources.StringResource
import org.jetbrains.compose.resources.stringResource
import robotran.language.Language
import robotran.workshop.platform.appLanguage

/**
 * Sets the language of [content] to [language], or to the system language if null.
 *
 * Compose resources only support the language of the process, so there is only one at a time.
 */
@Composable
internal fun InLanguage(language: Language?, content: @Composable () -> Unit) {
    remember(language) { speak(language?.tag) }
    CompositionLocalProvider(LocalLanguage provides appLanguage(language)) { key(language) { content() } }
}

/** [words] in [language], for texts outside of the composition, such as a window title. */
@Composable
internal fun textIn(language: Language?, words: StringResource): String {
    remember(language) { speak(language?.tag) }
    return key(language) { stringResource(words) }
}

/** The language of texts that are not resources. */
val LocalLanguage = staticCompositionLocalOf { Language.ENGLISH }

/** Sets the language of the process to [tag], such as `de`, or to its initial language if null. */
internal expect fun speak(tag: String?)
