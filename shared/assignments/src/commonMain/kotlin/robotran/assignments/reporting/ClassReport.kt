package robotran.assignments.reporting

import robotran.assignments.comparing.SimilarPair
import robotran.assignments.grading.GradedHandIn
import robotran.assignments.grading.GradingPlan
import robotran.projects.Project

/**
 * What a teacher takes away from grading.
 *
 * @property pairs between [results], by their indices.
 * @property comments for pupils, by the index in [results].
 */
class ClassReport(
    val assignment: Project,
    val plan: GradingPlan,
    val results: List<GradedHandIn>,
    val pairs: List<SimilarPair> = emptyList(),
    val comments: Map<Int, String> = emptyMap(),
)
