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

    /** What teachers can make, give out and look at. */
    TEACHERS(coversAll = true),
    WORLDS(coversAll = true),
    EXAMPLES(coversAll = true),
    HELP(coversAll = false),
}
