package robotran.ui.program

import androidx.compose.runtime.Composable
import androidx.compose.runtime.remember
import robotran.textediting.complete.WordHelp
import robotran.ui.language.LocalLanguage
import robotran.workshop.state.ProgramLanguage
import robotran.projects.ProgramLanguage as ProjectLanguage

/** What the words of a program in [language] are for, in the reader's language. */
@Composable
internal fun rememberWordHelp(language: ProgramLanguage): WordHelp {
    val reader = LocalLanguage.current
    val code = when (language) {
        ProgramLanguage.ROBOLANG -> ProjectLanguage.ROBOLANG
        ProgramLanguage.JAVA -> ProjectLanguage.JAVA
    }
    return remember(reader, code) { WordHelp { word -> robotran.learning.WordHelp.of(reader, code, word)?.sentence } }
}
