package robotran.workshop.blocks

import robotran.blockediting.palette.introductions
import robotran.learning.Lessons
import robotran.programs.support

/**
 * The ids of the palette's blocks that the programs of the tutorial have used up to the step with the index [step].
 */
fun blocksIntroducedBy(step: Int): Set<String> = INTRODUCTIONS.filterValues { it <= step }.keys

/** The step that uses each block first, also in its solution. */
private val INTRODUCTIONS: Map<String, Int> by lazy {
    introductions(
        Lessons.all.map { step ->
            if (step.programLanguage.support.hasBlocks) listOf(step.program.text, step.solution.text) else emptyList()
        },
    )
}
