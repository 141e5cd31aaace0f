package robotran.textediting.complete

import robotran.language.Language
import robotran.nqc.edit.NqcCompletion
import robotran.nqc.edit.NqcCompletionKind
import robotran.nqc.edit.completeNqc
import robotran.textediting.text.Draft

/** The completions at the caret of a program in NQC; null if there are none. */
internal fun completeNqc(draft: Draft, help: WordHelp, isExplicit: Boolean): CompletionList? {
    val found = completeNqc(draft.text, draft.selection.caret, Language.ENGLISH) ?: return null
    if (found.typed.isEmpty() && !isExplicit) return null
    val candidates = found.items.map { completionOf(it, help) }
    if (!isExplicit && candidates.any { it.isWritten(found.typed) }) return null
    val items = matching(found.typed, candidates).filter { it.inserted != found.typed }
    return if (items.isEmpty()) null else CompletionList(found.start, items)
}

/** The help is in the pupil's language. */
private fun completionOf(found: NqcCompletion, help: WordHelp) = Completion(
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
