package robotran.ui.program

import androidx.compose.runtime.Composable
import androidx.compose.runtime.remember
import robotran.brick.kind.BrickKind
import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.languagesupport.CompletionHelp
import robotran.learning.WordHelp
import robotran.uikit.*

/** Help on the words of a program in [language] for a [brick], in the app language; a new program has [words]. */
@Composable
internal fun rememberWordHelp(language: ProgramLanguage, brick: BrickKind, words: Language): CompletionHelp {
    val reader = LocalLanguage.current
    return remember(reader, language, brick, words) { WordSentences(reader, language, brick, words) }
}

private class WordSentences(
    private val reader: Language,
    private val language: ProgramLanguage,
    private val brick: BrickKind,
    override val words: Language,
) : CompletionHelp {
    override fun of(word: String): String? = WordHelp.of(reader, language, word, brick)?.sentence
}
