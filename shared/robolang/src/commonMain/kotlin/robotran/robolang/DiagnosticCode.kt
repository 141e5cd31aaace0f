package robotran.robolang

/**
 * Every kind of mistake there is.
 *
 * @property id the name that tools, reports and translations know it by; it never changes.
 */
enum class DiagnosticCode(val id: String) {
    /** A line begins with a word that is no command. */
    UNKNOWN_COMMAND("unknown-command"),

    /** A line begins with something that is not even a word. */
    MISSING_COMMAND("missing-command"),

    /** A word and a number are written as one. */
    MISSING_SPACE("missing-space"),

    /** A command lacks its number. */
    MISSING_NUMBER("missing-number"),

    /** `turn` without `left` or `right`. */
    MISSING_TURN_DIRECTION("missing-turn-direction"),

    /** `pen` without `down` or `up`. */
    MISSING_PEN_POSITION("missing-pen-position"),

    /** `repeat` and its number without `times`. */
    MISSING_TIMES("missing-times"),

    /** `wait` and its number without a unit of time. */
    MISSING_TIME_UNIT("missing-time-unit"),

    /** A unit that the command does not measure in. */
    WRONG_UNIT("wrong-unit"),

    /** A second command on the same line. */
    SEVERAL_COMMANDS("several-commands"),

    /** Something is left over behind a complete command. */
    EXTRA_WORDS("extra-words"),

    /** A block is never closed. */
    MISSING_END("missing-end"),

    /** An `end` has no block to close. */
    EXTRA_END("extra-end"),

    /** A character that Robolang has no use for. */
    UNKNOWN_CHARACTER("unknown-character"),

    /** A number with its point in the wrong place, or with several. */
    MALFORMED_NUMBER("malformed-number"),

    /** A number with a decimal comma. */
    DECIMAL_COMMA("decimal-comma"),

    /** A number beyond what 32 bits hold. */
    NUMBER_TOO_LARGE("number-too-large"),

    /** A block can be repeated only a whole number of times. */
    COUNT_NOT_WHOLE("count-not-whole"),

    /** A block cannot be repeated less than 0 times. */
    COUNT_NEGATIVE("count-negative"),

    /** Nobody can wait for less than no time. */
    WAIT_NEGATIVE("wait-negative"),

    /** One command would take longer than [RobolangLimits.LONGEST_COMMAND_MILLISECONDS]. */
    DURATION_TOO_LONG("duration-too-long"),

    /** More blocks inside each other than [RobolangLimits.NESTED_BLOCKS]. */
    NESTED_TOO_DEEPLY("nested-too-deeply"),

    /** The source is longer than [RobolangLimits.SOURCE_CHARACTERS]; nothing of it was read. */
    SOURCE_TOO_LONG("source-too-long"),
}
