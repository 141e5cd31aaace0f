package robotran.assignments.doing

import robotran.learning.Hint
import robotran.learning.HintStage
import robotran.learning.hint.Attempt
import robotran.learning.hint.HintCondition
import robotran.projects.Assignment
import robotran.simulation.state.SessionState
import robotran.world.World

/**
 * The hints that the teacher of [assignment] gives.
 *
 * @param world of the assignment.
 */
class HintsOfAssignment(private val assignment: Assignment, private val world: World) {
    /**
     * The hints after a failed try: the first one that fits what went wrong, or else those that only wait for a number of
     * tries, in their order.
     *
     * @param program the main text of the program that ran.
     * @param given the text that it began with.
     * @param run the end of the run.
     * @param tries the number of tries so far, with this one.
     */
    fun after(program: String, given: String, run: SessionState, tries: Int): List<Hint> {
        val due = assignment.hints.filter { it.afterTries <= tries }
        val fitting = due.firstNotNullOfOrNull { hint ->
            val condition = hint.condition?.let(HintCondition::of)
            val solution = LIKELY_SOLUTIONS[hint.condition] ?: program
            condition?.match(Attempt(program, given, solution, world, run))?.let { match ->
                val text = hint.text.replace(WORD, match.word.orEmpty())
                Hint(HintStage.NUDGE, text, condition = condition, line = match.line)
            }
        }
        if (fitting != null) return listOf(fitting)
        return due.filter { it.condition == null }.map { Hint(HintStage.NUDGE, it.text) }
    }

    companion object {
        /** Stands for the missing word in the text of a hint. */
        private const val WORD = "{word}"

        /**
         * The pupil's copy has no solution. Compared with itself, a program differs in nothing, so that those conditions
         * match that look at the run and at words. These ask what a solution does.
         */
        private val LIKELY_SOLUTIONS = mapOf("never moved" to "forward 1", "pen never down" to "pen down")

        /** The conditions that can match without a solution to compare with, in the order for a menu. */
        val conditions: List<String> = listOf(
            "nothing changed",
            "program failed",
            "never moved",
            "pen never down",
            "wrong port",
            "too short",
            "too far",
            "touched something",
            "hit a wall",
            "left the paper",
            "left its place",
            "went where it must not",
            "left the line",
            "wrong text",
            "no sound",
            "never stops",
            "too slow",
            "ended too early",
        )

        /** Conditions that take words of the program after a colon, such as `word missing: repeat`. */
        val wordConditions: List<String> = listOf("word missing", "word used")
    }
}
