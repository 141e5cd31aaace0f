package robotran.assignments.reporting

import robotran.assignments.collecting.keyOf
import robotran.assignments.comparing.SimilarPair
import robotran.assignments.grading.GradedHandIn
import robotran.assignments.grading.GradingPlan
import robotran.projects.Project

/**
 * What a teacher takes away from grading.
 *
 * @property pairs between [results], by their indices.
 * @property comments for pupils, by the index in [results].
 * @property notes on files that were no hand-ins.
 */
class ClassReport(
    val assignment: Project,
    val plan: GradingPlan,
    val results: List<GradedHandIn>,
    val pairs: List<SimilarPair> = emptyList(),
    val comments: Map<Int, String> = emptyMap(),
    val notes: List<String> = emptyList(),
) {
    private val counts = results.groupingBy { keyOf(it.submission.name) }.eachCount()

    /** How many of [results] have this name, apart from case and blanks. */
    fun countOfName(name: String): Int = counts[keyOf(name)] ?: 0
}
