package robotran.nqc.edit

import robotran.brick.kind.BrickKind
import robotran.languagesupport.BlockEffect
import robotran.languagesupport.CodeSyntax
import robotran.languagesupport.CodeToken
import robotran.languagesupport.CodeTokenKind
import robotran.languagesupport.CompletionList
import robotran.languagesupport.CompletionRequest
import robotran.languagesupport.LineTokens

/** What editors ask about NQC. */
internal object NqcSyntax : CodeSyntax {
    override val indent = "    "
    override val blockEnds = setOf("}")
    override val hasLongComments = true
    override val keys =
        listOf("(", ")", "{", "}", ";", "_", "=", "<", ">", "+", "-", "*", "/", "#", "[", "]", "&", "|", "!")

    override fun blockEffect(line: String): BlockEffect {
        val braces = nqcTokens(line, startsInComment = false).tokens
            .filter { it.kind == NqcTokenKind.SIGN && it.end == it.start + 1 && line[it.start] in "{}" }
            .map { line[it.start] }
        return BlockEffect(
            closes = line.trimStart().startsWith('}'),
            opens = braces.lastIndexOf('{') > braces.lastIndexOf('}'),
        )
    }

    override fun tokens(line: String, startsInComment: Boolean, brick: BrickKind): LineTokens {
        val found = nqcTokens(line, startsInComment)
        return LineTokens(found.tokens.map { CodeToken(kindOf(it.kind), it.start, it.end) }, found.endsInComment)
    }

    override fun complete(request: CompletionRequest): CompletionList? = completeNqc(request)

    override fun format(source: String): String = formatNqc(source)
}

private fun kindOf(kind: NqcTokenKind): CodeTokenKind = when (kind) {
    NqcTokenKind.KEYWORD, NqcTokenKind.DIRECTIVE -> CodeTokenKind.KEYWORD
    NqcTokenKind.BUILT_IN -> CodeTokenKind.BUILT_IN
    NqcTokenKind.NAME -> CodeTokenKind.NAME
    NqcTokenKind.NUMBER -> CodeTokenKind.NUMBER
    NqcTokenKind.TEXT -> CodeTokenKind.TEXT
    NqcTokenKind.SIGN -> CodeTokenKind.SIGN
    NqcTokenKind.COMMENT -> CodeTokenKind.COMMENT
}
