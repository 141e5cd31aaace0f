package robotran.nqc.parse

import robotran.language.source.SourceFix
import robotran.language.source.SourceRange
import robotran.nqc.syntax.Keyword
import robotran.nqc.syntax.KeywordGroup
import robotran.nqc.syntax.Token
import robotran.nqc.syntax.TokenKind

/** The tasks, subroutines and functions that [tokens] declare, also those with mistakes. */
internal class DeclaredUnits(tokens: List<Token>) {
    private val words: Map<String, Keyword?> = tokens.windowed(DECLARING)
        .filter { (word, name, sign) -> name.kind == TokenKind.NAME && declares(word, sign) }
        .associate { (word, name) -> name.text to word.keyword }

    /** The first word of each file that begins a task, a subroutine or a function. */
    private val first: Map<String, SourceRange> = tokens
        .filter { it.keyword?.group == KeywordGroup.UNIT && it.macro == null }
        .asReversed().associate { it.range.file to it.range }

    /** Whether [word] begins a unit: also the type of a function, as other languages write it. */
    private fun declares(word: Token, sign: Token) =
        word.keyword?.group == KeywordGroup.UNIT || (word.keyword == Keyword.INT && sign.isSign("("))

    val names: Set<String> get() = words.keys

    /** A fix that declares the variable [name] for the whole program, in the file of [range]; null if it cannot. */
    fun declaration(name: String, range: SourceRange): SourceFix? = first[range.file]
        ?.let { SourceFix(it.copy(endColumn = it.column), "${Keyword.INT.text} $name;\n\n") }

    fun isTask(name: String): Boolean = words[name] == Keyword.TASK

    fun isFunction(name: String): Boolean = words[name] == Keyword.VOID

    fun isSub(name: String): Boolean = words[name] == Keyword.SUB

    private companion object {
        /** A word, a name and a bracket. */
        const val DECLARING = 3
    }
}
