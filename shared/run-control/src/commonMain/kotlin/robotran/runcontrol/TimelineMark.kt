package robotran.runcontrol

/**
 * An event of a run, shown on its timeline.
 *
 * @property robot index of its robot in the world; 0 if it belongs to none.
 * @property text details that the UI cannot know, such as why a program failed; may be empty.
 */
data class TimelineMark(val milliseconds: Long, val kind: MarkKind, val robot: Int = 0, val text: String = "")

enum class MarkKind {
    /** A program has started. */
    START,

    /** A program has ended. */
    END,

    /** A program has failed; the text says why. */
    FAILURE,

    /** A goal is met; the text is its sentence. */
    GOAL,

    /** A goal can no longer be met; the text is its sentence. */
    GOAL_LOST,

    /** A warning for the pupil about Java or the brick; the text contains it. */
    WARNING,

    /** A bumper has touched something. */
    BUMP,

    /** The brick has started a sound. */
    BEEP,

    /** The brick has started to send an infrared message. */
    MESSAGE,
    ;

    /** Whether there are few such events and each counts. */
    val isRare: Boolean get() = this < BUMP
}
