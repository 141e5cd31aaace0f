package robotran.languagesupport

/** What editors ask about a language with braces and the comments of C. */
abstract class BraceSyntax : CodeSyntax {
    override val indent: String = "    "
    override val blockEnds: Set<String> = setOf("}")
    override val hasLongComments: Boolean = true

    /** How [format] lays a program out. */
    protected abstract val layout: BraceLayout

    /** The tokens of one [line], where it does not matter which names are built in. */
    protected abstract fun structure(line: String, startsInComment: Boolean): LineTokens

    override fun blockEffect(line: String): BlockEffect {
        val braces = structure(line, startsInComment = false).tokens
            .filter { it.kind == CodeTokenKind.SIGN && it.end == it.start + 1 && line[it.start] in "{}" }
            .map { line[it.start] }
        return BlockEffect(
            closes = line.trimStart().startsWith('}'),
            opens = braces.lastIndexOf('{') > braces.lastIndexOf('}'),
        )
    }

    override fun format(source: String): String = formatBraces(source, layout, ::structure)
}
