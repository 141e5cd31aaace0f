package robotran.legofirmware.edit

import robotran.languagesupport.Completion
import robotran.languagesupport.CompletionKind
import robotran.languagesupport.CompletionList
import robotran.languagesupport.CompletionRequest
import robotran.legofirmware.assembly.CommandHelp

/** The commands at the caret of LEGO's assembly text, which begin a line; null if there are none. */
internal fun completeLasm(request: CompletionRequest): CompletionList? {
    val lines = request.lines
    val typed = lines.text.substring(lines.start(lines.lineOf(request.caret)), request.caret).trimStart()
    if (typed.any { !it.isLetter() } || (typed.isEmpty() && !request.isExplicit)) return null
    val candidates = FRAMES.map { Completion(it, CompletionKind.BLOCK) } +
        CommandHelp.mnemonics.map { Completion(it, CompletionKind.FUNCTION, help = request.help.of(it)) }
    return request.completions(request.caret - typed.length, candidates)
}

/** The lines around the commands of a task or subroutine. */
private val FRAMES = listOf("task", "endt", "sub", "ends")
