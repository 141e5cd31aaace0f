package robotran.ui.program

import androidx.compose.runtime.Composable
import androidx.compose.runtime.remember
import robotran.brick.kind.BrickKind
import robotran.language.ProgramLanguage
import robotran.textediting.complete.WordHelp
import robotran.ui.language.LocalLanguage

/** Help on the words of a program in [language] for a [brick], in the app language. */
@Composable
internal fun rememberWordHelp(language: ProgramLanguage, brick: BrickKind): WordHelp {
    val reader = LocalLanguage.current
    return remember(reader, language, brick) {
        WordHelp { word ->
            robotran.learning.WordHelp.of(reader, language, word, brick)?.sentence
        }
    }
}
