package robotran.workshop.state

/**
 * A page of learning material.
 *
 * @property coversAll whether it covers the whole screen.
 */
enum class LearningPage(val coversAll: Boolean) {
    FIRST_RUN(coversAll = true),
    TUTORIAL(coversAll = false),

    /** The strands with their lessons. */
    MAP(coversAll = true),
    WORLDS(coversAll = true),
    EXAMPLES(coversAll = true),
    HELP(coversAll = false),
}
