package robotran.runcontrol

/**
 * Something that has happened in a run, to be found again on its timeline.
 *
 * @property robot whose it is, its number in the world; 0 if it is nobody's.
 * @property text what there is to say of it that a screen cannot know, such as why a program has failed; otherwise
 * empty.
 */
data class TimelineMark(val milliseconds: Long, val kind: MarkKind, val robot: Int = 0, val text: String = "")

/** What can happen. */
enum class MarkKind {
    /** A program has begun. */
    START,

    /** A program is over. */
    END,

    /** A program could not go on; the text says why. */
    FAILURE,

    /** A goal is reached; the text is its sentence. */
    GOAL,

    /** A goal cannot be reached any more; the text is its sentence. */
    GOAL_LOST,

    /** Something about Java or the brick that a pupil should know; the text says it. */
    REMARK,

    /** A bumper has touched something. */
    BUMP,

    /** The brick has begun to sound. */
    BEEP,

    /** The brick has begun to send an infrared message. */
    MESSAGE,
    ;

    /** Whether there are few of it and each counts. */
    val isRare: Boolean get() = this < BUMP
}
