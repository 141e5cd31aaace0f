package robotran.nqc.edit

import robotran.language.Language
import robotran.languagesupport.Completion
import robotran.languagesupport.CompletionHelp
import robotran.languagesupport.CompletionKind
import robotran.languagesupport.CompletionList
import robotran.languagesupport.CompletionRequest

/** The completions at the caret of a program in NQC; null if there are none. */
internal fun completeNqc(request: CompletionRequest): CompletionList? {
    val found = completeNqc(request.lines.text, request.caret, Language.ENGLISH) ?: return null
    if (found.typed.isEmpty() && !request.isExplicit) return null
    return request.completions(found.start, found.items.map { completionOf(it, request.help) })
}

/** The help is in the pupil's language. */
private fun completionOf(found: NqcCompletion, help: CompletionHelp) = Completion(
    found.label,
    kindOf(found.kind),
    found.inserted,
    found.caret,
    help.of(found.label.substringBefore('(').substringBefore(' ')),
)

private fun kindOf(kind: NqcCompletionKind): CompletionKind = when (kind) {
    NqcCompletionKind.WORD -> CompletionKind.WORD
    NqcCompletionKind.BLOCK -> CompletionKind.BLOCK
    NqcCompletionKind.NAME -> CompletionKind.NAME
    NqcCompletionKind.FUNCTION -> CompletionKind.FUNCTION
    NqcCompletionKind.VALUE, NqcCompletionKind.CONSTANT -> CompletionKind.FIELD
}
