package robotran.blockediting.palette

import robotran.language.Language
import robotran.robolang.messages.RobolangMessages
import robotran.robolang.outline.PhrasePart
import robotran.robolang.outline.outlineRobolang

/**
 * The step of a course that first uses each block.
 *
 * @param steps the Robolang programs of each step, such as the one to try and its solution.
 * @return the index of the step by the id of the block. A block that no program has is missing.
 */
fun introductions(steps: List<List<String>>): Map<String, Int> {
    val found = mutableMapOf<String, Int>()
    steps.forEachIndexed { step, programs ->
        for (program in programs) for (id in blocksIn(program)) found.getOrPut(id) { step }
    }
    return found
}

private fun blocksIn(program: String): Set<String> {
    val outline = outlineRobolang(program, messages = RobolangMessages.of(Language.ENGLISH))
    val lines = outline.lines.mapNotNull { it.form }.map(::idOf)
    val values = partsOf(outline).filterIsInstance<PhrasePart.Value>().map { idOf(it, program) }
    return (lines + values).toSet()
}
