package robotran.robolang.syntax

import robotran.brick.kind.BrickKind
import robotran.robolang.words.KINDS
import robotran.robolang.words.Keyword
import robotran.robolang.words.lowercaseKeyword

/**
 * A word that the program declares as a name is a name on all its lines, if [Keyword.yields]. So programs that are
 * older than the word mean what they always meant.
 */
internal fun withDeclaredNames(lines: List<ScannedLine>): List<ScannedLine> {
    val declared = lines.flatMapTo(mutableSetOf()) { declaredWords(it.tokens) }
    if (declared.isEmpty()) return lines
    return lines.map { line ->
        if (line.tokens.none { it.keyword in declared }) return@map line
        line.copy(tokens = line.tokens.map { if (it.keyword in declared) it.copy(keyword = null) else it })
    }
}

private fun declaredWords(tokens: List<Token>): List<Keyword> {
    val names = when (tokens.firstOrNull()?.keyword) {
        Keyword.VAR, Keyword.CONST -> tokens.drop(1).take(1)
        Keyword.FOR -> tokens.drop(if (tokens.getOrNull(1)?.keyword == Keyword.EACH) 2 else 1).take(1)
        Keyword.PROCEDURE, Keyword.FUNCTION -> tokens.drop(1)
        else -> if (tokens.getOrNull(1)?.kind in ASSIGNING) tokens.take(1) else emptyList()
    }
    return names.mapNotNull { it.keyword }.filter { it.yields }
}

/** What follows a name at the start of a line: it is assigned or called. */
private val ASSIGNING = setOf(TokenKind.ASSIGN, TokenKind.OPEN_LIST, TokenKind.OPEN_BRACKET)

/** The brick that a header in [lines] names; null if none does. */
internal fun brickIn(lines: List<ScannedLine>): BrickKind? {
    if (lines.none { it.tokens.firstOrNull()?.keyword == Keyword.ROBOT }) return null
    return lines.firstNotNullOfOrNull { line ->
        val second = line.tokens.getOrNull(1)?.keyword
        if (line.tokens.firstOrNull()?.keyword == Keyword.BRICK) KINDS[second] else null
    }
}

/** The names that a line of [tokens] declares, in lower case. Names that are written as several words are joined. */
internal fun declaredNames(tokens: List<Token>): List<String> {
    val first = tokens.firstOrNull()?.keyword
    val names = when (first) {
        Keyword.VAR, Keyword.CONST -> listOf(tokens.drop(1).takeWhile { it.kind != TokenKind.ASSIGN })
        Keyword.FOR -> listOf(tokens.drop(1).takeWhile { it.keyword !in BEHIND_COUNTERS })
        Keyword.PROCEDURE, Keyword.FUNCTION -> runsOf(tokens.drop(1))
        else -> return emptyList()
    }
    return names.map { it.filter { token -> token.keyword != Keyword.EACH } }.filter { it.isNotEmpty() }.map(::joined)
}

/** The runs of words between signs. */
private fun runsOf(tokens: List<Token>): List<List<Token>> {
    val runs = mutableListOf(mutableListOf<Token>())
    for (token in tokens) {
        if (token.kind == TokenKind.WORD) runs.last() += token else runs += mutableListOf<Token>()
    }
    return runs
}

private fun joined(words: List<Token>): String = words.joinToString("_") { lowercaseKeyword(it.text) }

private val BEHIND_COUNTERS = setOf(Keyword.FROM, Keyword.IN, Keyword.TO)
