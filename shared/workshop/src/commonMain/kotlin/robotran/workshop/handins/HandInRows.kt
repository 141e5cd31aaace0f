package robotran.workshop.handins

import robotran.assignments.collecting.Submission
import robotran.assignments.grading.GradedHandIn
import robotran.assignments.reporting.linesOfCode
import robotran.workshop.state.HandInOrder
import robotran.workshop.state.HandInRow
import robotran.workshop.state.HandInsState

/** The rows for [submissions]; a hand-in that has not changed keeps what [known] says about it. */
internal fun rowsFor(
    submissions: Map<String, Submission>,
    known: List<HandInRow>,
    comments: Map<String, String>,
): List<HandInRow> {
    val before = known.associateBy { it.id }
    return withNamesakes(
        submissions.map { (id, submission) ->
            before[id]?.takeIf { it.submission == submission }
                ?: HandInRow(
                    id,
                    submission,
                    (submission as? Submission.Unusable)?.let(GradedHandIn::Unusable),
                    submission.linesOfCode,
                    comment = before[id]?.comment ?: comments[id].orEmpty(),
                )
        },
    )
}

/** [rows] that know whether others have the same name. */
internal fun withNamesakes(rows: List<HandInRow>): List<HandInRow> {
    val counts = rows.groupingBy { keyOf(it.name) }.eachCount()
    return rows.map { it.copy(hasNamesake = counts.getValue(keyOf(it.name)) > 1) }
}

/** In the chosen order. */
internal fun HandInsState.sorted(): HandInsState {
    val byName = rows.sortedWith(compareBy<HandInRow> { it.name.lowercase() }.thenBy { it.id })
    return copy(rows = if (order == HandInOrder.NAME) byName else byName.sortedWith(BY_NEED))
}

/** Who needs most help first, and among those with the same verdict who has met fewer goals. */
private val BY_NEED = compareBy<HandInRow> { it.verdict }.thenBy { it.results?.met ?: 0 }
