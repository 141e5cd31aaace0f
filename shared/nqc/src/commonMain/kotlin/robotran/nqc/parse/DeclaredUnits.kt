package robotran.nqc.parse

import robotran.nqc.syntax.Keyword
import robotran.nqc.syntax.KeywordGroup
import robotran.nqc.syntax.Token
import robotran.nqc.syntax.TokenKind

/** The tasks, subroutines and functions that [tokens] declare, also those with mistakes. */
internal class DeclaredUnits(tokens: List<Token>) {
    private val words: Map<String, Keyword?> = tokens.zipWithNext()
        .filter { (word, name) -> word.keyword?.group == KeywordGroup.UNIT && name.kind == TokenKind.NAME }
        .associate { (word, name) -> name.text to word.keyword }

    val names: Set<String> get() = words.keys

    fun isTask(name: String): Boolean = words[name] == Keyword.TASK

    fun isSub(name: String): Boolean = words[name] == Keyword.SUB
}
