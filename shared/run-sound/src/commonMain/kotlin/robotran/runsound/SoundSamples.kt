package robotran.runsound

/** What a pupil can listen to, to learn what the sounds of a run mean. */
enum class SoundSample {
    /** Straight on, then a curve to the left: the right wheel ticks faster. */
    WHEELS,

    /** A wall comes nearer, while the robot drives from left to right. */
    WALL_AHEAD,

    /** Paper, then a line. */
    LINE,

    /** Paper, then ink. */
    INK,
    BUMP,
    GOAL,
    GOAL_LOST,
    END,
    ;

    /** Its tones, from time 0. */
    val tones: List<RunTone>
        get() = when (this) {
            WHEELS -> wheels()
            WALL_AHEAD -> SoundValues.PITCHES.reversed().mapIndexed { number, hertz -> wall(number, hertz) }
            LINE -> onto(Timbre.SAWTOOTH)
            INK -> onto(Timbre.SQUARE)
            BUMP -> RunSign.BUMP.from(0, 0.0)
            GOAL -> RunSign.GOAL.from(0, 0.0)
            GOAL_LOST -> RunSign.GOAL_LOST.from(0, 0.0)
            END -> RunSign.END.from(0, 0.0)
        }

    private fun wheels(): List<RunTone> = List(STRAIGHT) { tick(it * TICK_EVERY, SoundValues.TICK_BOTH, 0.0) } +
        List(STRAIGHT) { number ->
            val isLeft = number % CURVE == 0
            val hertz = if (isLeft) SoundValues.TICK_LEFT else SoundValues.TICK_RIGHT
            tick((STRAIGHT + number) * TICK_EVERY, hertz, if (isLeft) -1.0 else 1.0)
        }

    private fun tick(start: Long, hertz: Double, pan: Double) = RunTone(
        start,
        RunSign.WHEEL,
        hertz,
        SoundValues.TICK_LENGTH,
        pan,
        Timbre.SQUARE,
        SoundValues.TICK_LOUDNESS,
    )

    private fun wall(number: Int, hertz: Double) =
        ahead(number * WALL_EVERY, hertz, Timbre.SINE, 2.0 * number / SoundValues.PITCHES.lastIndex - 1)

    private fun onto(timbre: Timbre) = List(ONTO) {
        ahead(it * SoundValues.TELLING, ONTO_HERTZ, if (it < ONTO / 2) Timbre.SINE else timbre, 0.0)
    }

    private fun ahead(start: Long, hertz: Double, timbre: Timbre, pan: Double) =
        RunTone(start, RunSign.AHEAD, hertz, SoundValues.TELLING_LENGTH, pan, timbre, timbre.loudness)

    private companion object {
        /** Ticks straight on, and then in the curve. */
        const val STRAIGHT = 8
        const val TICK_EVERY = 125L

        /** Of so many ticks in the curve one is the left wheel's. */
        const val CURVE = 3
        const val WALL_EVERY = 120L

        /** Tones before and on the line together. */
        const val ONTO = 6
        const val ONTO_HERTZ = 523.25
    }
}
