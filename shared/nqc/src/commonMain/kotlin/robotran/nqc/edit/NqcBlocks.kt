package robotran.nqc.edit

/**
 * What a line does to the indentation of the lines below.
 *
 * @property closes whether it begins with the end of a block.
 * @property opens whether a block begins in it that does not end there.
 */
data class NqcBlockEffect(val closes: Boolean, val opens: Boolean)

/** What [line], which begins outside of any comment, does to the indentation. */
fun nqcBlockEffect(line: String): NqcBlockEffect {
    val braces = nqcTokens(line, startsInComment = false).tokens
        .filter { it.kind == NqcTokenKind.SIGN && it.end == it.start + 1 && line[it.start] in "{}" }
        .map { line[it.start] }
    return NqcBlockEffect(
        closes = line.trimStart().startsWith('}'),
        opens = braces.lastIndexOf('{') > braces.lastIndexOf('}'),
    )
}
