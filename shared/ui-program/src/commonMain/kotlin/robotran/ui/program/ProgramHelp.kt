package robotran.ui.program

import androidx.compose.runtime.Composable
import androidx.compose.runtime.remember
import robotran.brick.kind.BrickKind
import robotran.language.ProgramLanguage
import robotran.languagesupport.CompletionHelp
import robotran.uikit.*

/** Help on the words of a program in [language] for a [brick], in the app language. */
@Composable
internal fun rememberWordHelp(language: ProgramLanguage, brick: BrickKind): CompletionHelp {
    val reader = LocalLanguage.current
    return remember(reader, language, brick) {
        CompletionHelp { word ->
            robotran.learning.WordHelp.of(reader, language, word, brick)?.sentence
        }
    }
}
