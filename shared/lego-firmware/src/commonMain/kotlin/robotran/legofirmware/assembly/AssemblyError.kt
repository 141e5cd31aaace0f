package robotran.legofirmware.assembly

import robotran.language.source.ProblemCode

/** The kinds of problems of an assembly text. */
enum class AssemblyError(override val id: String) : ProblemCode {
    SOURCE_TOO_LONG("source-too-long"),
    UNKNOWN_CHARACTER("unknown-character"),
    UNKNOWN_COMMAND("unknown-command"),

    /** A line that begins with a number or a comma. */
    MISSING_COMMAND("missing-command"),

    /** Too few or too many numbers after a command. */
    WRONG_NUMBER_COUNT("wrong-number-count"),
    MISSING_COMMA("missing-comma"),
    NUMBER_NEEDED("number-needed"),
    NUMBER_OUT_OF_RANGE("number-out-of-range"),
    LABEL_NEEDED("label-needed"),
    UNKNOWN_LABEL("unknown-label"),

    /** A label of another task or subroutine. */
    LABEL_ELSEWHERE("label-elsewhere"),
    LABEL_TWICE("label-twice"),

    /** A target that the command does not reach. */
    TOO_FAR("too-far"),

    /** A command or label outside a task or subroutine. */
    OUTSIDE_CHUNK("outside-chunk"),
    NOT_CLOSED("not-closed"),
    WRONG_END("wrong-end"),
    CHUNK_TWICE("chunk-twice"),
    CODE_TOO_LONG("code-too-long"),

    /** A command, source or variable that firmware 1.0 does not have. */
    NEWER_FIRMWARE("newer-firmware"),

    /** A warning: a source that firmware 1.0 does not take here. */
    RESTRICTED_SOURCE("restricted-source"),

    /** A warning: a source that an RCX does not have. */
    UNKNOWN_SOURCE("unknown-source"),

    /** A warning: a command that does nothing in a program. */
    REQUEST_ONLY("request-only"),

    /** A warning: more code than fits into a real brick. */
    LARGE_PROGRAM("large-program"),

    /** A warning: no task 0. */
    NO_MAIN_TASK("no-main-task"),
}
