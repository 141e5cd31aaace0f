package robotran.learning

/**
 * Where a lesson's program is tried. A program that knows the way by heart reaches the goals in one place only, so in a
 * lesson with two places the task is done once the same program has reached them in both.
 */
enum class LessonPlace { FIRST, AGAIN }
