package robotran.legofirmware.edit

import robotran.brick.kind.BrickKind
import robotran.languagesupport.BlockEffect
import robotran.languagesupport.CodeSyntax
import robotran.languagesupport.CompletionList
import robotran.languagesupport.CompletionRequest
import robotran.languagesupport.LineTokens

/** What editors ask about assembly text. */
internal object LasmSyntax : CodeSyntax {
    override val indent = "\t"
    override val commentMark = ";"
    override val blockEnds = emptySet<String>()
    override val keys = listOf(",", ":", ";", "-")
    override val hasFormat = false

    override fun blockEffect(line: String) = BlockEffect(closes = false, opens = false)

    override fun tokens(line: String, startsInComment: Boolean, brick: BrickKind): LineTokens =
        LineTokens(tokenizeLasmLine(line), endsInComment = false)

    override fun complete(request: CompletionRequest): CompletionList? = completeLasm(request)

    override fun format(source: String): String? = null
}
