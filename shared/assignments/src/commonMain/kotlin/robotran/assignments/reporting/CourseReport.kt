package robotran.assignments.reporting

import robotran.assignments.collecting.sortKey
import robotran.language.Language

/**
 * What a teacher takes away from grading a course.
 *
 * @property tasks the results for each assignment, in the order of the course; then, under no title, what is for none.
 */
class CourseReport(val title: String, val tasks: List<ClassReport>) {
    /** All results as report and index, by the names of pupils, and for each in the order of the course. */
    internal fun rows(language: Language): List<Pair<ClassReport, Int>> =
        tasks.flatMap { task -> task.results.indices.map { task to it } }
            .sortedBy { (task, index) -> sortKey(task.results[index].submission.name, language) }
}
