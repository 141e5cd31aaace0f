package robotran.tower.line

/** The result of sending a message once. */
internal sealed interface Attempt {
    /** @property payload the answer's bytes behind the complement of the opcode. */
    class Answered(val payload: ByteArray) : Attempt

    /**
     * No undamaged answer.
     *
     * @property echoHeard whether any byte came back; always true for a tower without echo.
     * @property brickHeard whether bytes came that are not the echo.
     * @property rest these bytes.
     */
    class Unanswered(val echoHeard: Boolean, val brickHeard: Boolean, val rest: ByteArray) : Attempt

    /** The tower is gone. */
    data object Gone : Attempt
}
