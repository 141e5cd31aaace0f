package robotran.textediting.complete

import robotran.brick.kind.BrickKind
import robotran.languagesupport.CodeSyntax
import robotran.languagesupport.Completion
import robotran.languagesupport.CompletionHelp
import robotran.languagesupport.CompletionList
import robotran.languagesupport.CompletionRequest
import robotran.textediting.text.TextDocument
import robotran.textediting.text.TextSelection

/**
 * The completions at the caret of [draft]: words of the language, names in the program and members of the brick's
 * library. Null if there are none, as in a comment. [CompletionRequest] explains the other parameters.
 */
fun completionsAt(
    draft: TextDocument,
    syntax: CodeSyntax,
    help: CompletionHelp,
    isExplicit: Boolean,
    brick: BrickKind,
): CompletionList? {
    if (!draft.selection.isEmpty) return null
    return syntax.complete(CompletionRequest(draft.lines, draft.selection.caret, help, isExplicit, brick))
}

/** This text with the completion [chosen] from [list] inserted. */
fun TextDocument.completed(list: CompletionList, chosen: Completion): TextDocument {
    val line = lines.lineOf(list.start)
    val indent = lines.line(line).takeWhile { it == ' ' }
    val inserted = chosen.inserted.replace("\n", "\n" + indent)
    val caret = chosen.inserted.take(chosen.caret).replace("\n", "\n" + indent).length
    val position = list.start + caret
    return replaced(
        list.start,
        selection.caret,
        inserted,
    ).copy(selection = TextSelection(position - chosen.selected, position))
}
