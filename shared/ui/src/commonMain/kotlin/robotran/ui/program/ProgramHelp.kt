package robotran.ui.program

import androidx.compose.runtime.Composable
import androidx.compose.runtime.remember
import robotran.language.ProgramLanguage
import robotran.textediting.complete.WordHelp
import robotran.ui.language.LocalLanguage

/** What the words of a program in [language] are for, in the reader's language. */
@Composable
internal fun rememberWordHelp(language: ProgramLanguage): WordHelp {
    val reader = LocalLanguage.current
    return remember(reader, language) {
        WordHelp { word ->
            robotran.learning.WordHelp.of(reader, language, word)?.sentence
        }
    }
}
