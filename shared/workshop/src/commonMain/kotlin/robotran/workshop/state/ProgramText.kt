package robotran.workshop.state

import robotran.programs.Program
import robotran.projects.ProjectLimits
import robotran.textediting.text.TextDocument

/** Whether the file with the index [index] may become [written]; an edit may always shorten it. */
fun Program.hasRoomFor(index: Int, written: TextDocument): Boolean {
    val now = files[index].text.length
    if (written.text.length <= now) return true
    val isShort = characters - now + written.text.length <= ProjectLimits.MAXIMUM_PROGRAM_CHARACTERS
    return isShort && written.lines.count <= ProjectLimits.MAXIMUM_LINES
}

fun Program.withPlainLineEnds(): Program = copy(files = files.map { it.copy(text = it.text.withPlainLineEnds()) })
