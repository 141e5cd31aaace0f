package robotran.robolang.run

import robotran.robolang.syntax.Statement

/** What a run is in the middle of; the innermost is on top of the stack. */
internal sealed interface Frame {
    /** The line to be executed next in this frame. */
    val sourceLine: Int

    /** Statements one after the other; never the top of a settled stack once all are done. */
    class Sequence(private val statements: List<Statement>) : Frame {
        private var next = 0

        val isDone: Boolean get() = next == statements.size

        override val sourceLine: Int get() = statements[next].range.line

        fun take(): Statement = statements[next++]
    }

    /** A `repeat` that has [remaining] rounds to go. */
    class Repetition(val statement: Statement.Repeat, var remaining: Int) : Frame {
        override val sourceLine: Int get() = statement.range.line
    }

    /** A statement that lasts until the brick's clock has reached [untilMilliseconds]. */
    class Lasting(override val sourceLine: Int, val untilMilliseconds: Long, val ending: Ending) : Frame
}

/** What a lasting statement does when its time is over. */
internal enum class Ending { NOTHING, STOP_DRIVING, STOP_PEN }
