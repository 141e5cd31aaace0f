package robotran.workshop.state

/**
 * What there is to learn from.
 *
 * @property coversAll whether nothing else is to be seen while it is open.
 */
enum class LearningPage(val coversAll: Boolean) {
    FIRST_RUN(coversAll = true),
    TUTORIAL(coversAll = false),
    WORLDS(coversAll = true),
    EXAMPLES(coversAll = true),
    HELP(coversAll = false),
}
