package robotran.ui.language

import androidx.compose.runtime.Composable
import androidx.compose.runtime.CompositionLocalProvider
import androidx.compose.runtime.key
import androidx.compose.runtime.remember
import androidx.compose.runtime.staticCompositionLocalOf
import org.jetbrains.compose.resources.StringResource
import org.jetbrains.compose.resources.stringResource
import robotran.language.Language
import robotran.workshop.platform.spokenLanguage

/**
 * Everything inside is in [language], or in the machine's if that is null.
 *
 * The resources of Compose have no other way of being told a language than that of the whole process, which is why
 * there is one only.
 */
@Composable
internal fun InLanguage(language: Language?, content: @Composable () -> Unit) {
    remember(language) { speak(language?.tag) }
    CompositionLocalProvider(LocalLanguage provides spokenLanguage(language)) { key(language) { content() } }
}

/** [words] in [language], where there is nothing around to be said in it too, as over a window. */
@Composable
internal fun textIn(language: Language?, words: StringResource): String {
    remember(language) { speak(language?.tag) }
    return key(language) { stringResource(words) }
}

/** What is spoken here, for sentences that are no resources. */
val LocalLanguage = staticCompositionLocalOf { Language.ENGLISH }

/** Makes [tag], such as `de`, the language of the process, or again the one that it began with if that is null. */
internal expect fun speak(tag: String?)
