package robotran.nqc.edit

import robotran.brick.kind.BrickKind
import robotran.language.Language
import robotran.languagesupport.BraceLayout
import robotran.languagesupport.BraceSyntax
import robotran.languagesupport.CompletionList
import robotran.languagesupport.CompletionRequest
import robotran.languagesupport.LineTokens

/** What editors ask about NQC. */
internal object NqcSyntax : BraceSyntax() {
    override val keys =
        listOf("(", ")", "{", "}", ";", "_", "=", "<", ">", "+", "-", "*", "/", "#", "[", "]", "&", "|", "!")

    override val layout = BraceLayout(
        "if else while for repeat until switch monitor acquire catch task sub void".split(' ').toSet(),
        openEnds = setOf("else", "do", "catch"),
        hasDirectives = true,
    )

    override fun structure(line: String, startsInComment: Boolean): LineTokens = nqcTokens(line, startsInComment)

    override fun tokens(line: String, startsInComment: Boolean, brick: BrickKind): LineTokens =
        nqcTokens(line, startsInComment)

    override fun complete(request: CompletionRequest): CompletionList? {
        val found = completeNqc(request.lines.text, request.caret, Language.ENGLISH) ?: return null
        if (found.typed.isEmpty() && !request.isExplicit) return null
        // The help is in the pupil's language.
        val items = found.items.map {
            it.copy(help = request.help.of(it.label.substringBefore('(').substringBefore(' ')))
        }
        return request.completions(found.start, items)
    }
}
