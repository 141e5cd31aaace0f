package robotran.workshop.handins

import robotran.assignments.collecting.Submission
import robotran.assignments.collecting.keyOf
import robotran.assignments.collecting.sortKey
import robotran.assignments.grading.GradedHandIn
import robotran.assignments.reporting.linesOfCode
import robotran.language.Language
import robotran.workshop.state.HandInOrder
import robotran.workshop.state.HandInRow
import robotran.workshop.state.HandInsState

/** The rows for [submissions]; a hand-in that has not changed keeps what [known] says about it. */
internal fun rowsFor(
    submissions: List<PlacedSubmission>,
    known: List<HandInRow>,
    comments: Map<String, String>,
): List<HandInRow> {
    val before = known.associateBy { it.id }
    return withNamesakes(
        submissions.map { placed ->
            val submission = placed.submission
            val old = before[placed.id]
            old?.takeIf { it.collected == submission } ?: HandInRow(
                placed.id,
                submission,
                (submission as? Submission.Unusable)?.let(GradedHandIn::Unusable),
                submission.linesOfCode,
                comment = old?.comment ?: comments[placed.id].orEmpty(),
                task = placed.task,
            )
        },
    )
}

/** [rows] that know whether others have the same name. */
internal fun withNamesakes(rows: List<HandInRow>): List<HandInRow> {
    val key = { row: HandInRow -> row.task to keyOf(row.name) }
    val counts = rows.groupingBy(key).eachCount()
    return rows.map { it.copy(hasNamesake = counts.getValue(key(it)) > 1) }
}

/** In the chosen order, as people in [language] sort names. */
internal fun HandInsState.sorted(language: Language): HandInsState {
    val byName = rows.sortedWith(
        compareBy<HandInRow> {
            sortKey(it.name, language)
        }.thenBy { it.task }.thenBy { it.id },
    )
    return copy(rows = if (order == HandInOrder.NAME) byName else byName.sortedWith(BY_NEED))
}

/** Who needs most help first, and among those with the same verdict who has met fewer goals. */
private val BY_NEED = compareBy<HandInRow> { it.verdict }.thenBy { it.results?.met ?: 0 }
