package robotran.assignments.messages

/** The columns of the table of a class, in their order. */
enum class ReportColumn {
    NAME,
    VERDICT,

    /** In the best run. */
    GOALS_MET,
    GOALS,
    SEEDS_MET,
    SEEDS,
    SECONDS,
    LINES,
    TRIES,
    REMARKS,
    GOALS_MET_IN_ALL_RUNS,

    /** Hand-ins with nearly the same program. */
    SIMILAR,
    COMMENT,
}

/**
 * The headings of the table of a class.
 *
 * @param worlds how often each seed counts.
 */
fun ReportMessages.columns(worlds: Int): List<String> = ReportColumn.entries.map { heading(it, worlds) }
