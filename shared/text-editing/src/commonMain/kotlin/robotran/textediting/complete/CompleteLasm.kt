package robotran.textediting.complete

import robotran.legofirmware.assembly.CommandHelp
import robotran.textediting.text.Draft

/** The commands at the caret of LEGO's assembly text, which begin a line; null if there are none. */
internal fun completeLasm(draft: Draft, help: WordHelp, isExplicit: Boolean): CompletionList? {
    val caret = draft.selection.caret
    val typed = draft.text.substring(draft.lines.start(draft.lines.lineOf(caret)), caret).trimStart()
    if (typed.any { !it.isLetter() } || (typed.isEmpty() && !isExplicit)) return null
    val candidates = FRAMES.map { Completion(it, CompletionKind.BLOCK) } +
        CommandHelp.mnemonics.map { Completion(it, CompletionKind.FUNCTION, help = help.of(it)) }
    if (!isExplicit && candidates.any { it.isWritten(typed) }) return null
    val items = matching(typed, candidates).filter { it.inserted != typed }
    return if (items.isEmpty()) null else CompletionList(caret - typed.length, items)
}

/** The lines around the commands of a task or subroutine. */
private val FRAMES = listOf("task", "endt", "sub", "ends")
