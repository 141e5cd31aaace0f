package robotran.robolang.diagnostic

import robotran.language.source.ProblemCode

/** All kinds of diagnostics. */
enum class DiagnosticCode(override val id: String) : ProblemCode {
    /** A line begins with a word that is not a command. */
    UNKNOWN_COMMAND("unknown-command"),

    /** A line does not begin with a word. */
    MISSING_COMMAND("missing-command"),

    /** A word and a number are written as one. */
    MISSING_SPACE("missing-space"),

    /** A command without its number. */
    MISSING_NUMBER("missing-number"),

    /** `turn` without `left` or `right`. */
    MISSING_TURN_DIRECTION("missing-turn-direction"),

    /** `pen` without `down` or `up`. */
    MISSING_PEN_POSITION("missing-pen-position"),

    /** `repeat` and its number without `times`. */
    MISSING_TIMES("missing-times"),

    /** `wait` and its number without a unit of time. */
    MISSING_TIME_UNIT("missing-time-unit"),

    /** A unit that the command does not accept. */
    WRONG_UNIT("wrong-unit"),

    /** A second command on the same line. */
    SEVERAL_COMMANDS("several-commands"),

    /** Extra text after a complete command. */
    EXTRA_WORDS("extra-words"),

    /** A block is never closed. */
    MISSING_END("missing-end"),

    /** An `end` has no block to close. */
    EXTRA_END("extra-end"),

    /** A character that is not part of the language. */
    UNKNOWN_CHARACTER("unknown-character"),

    /** A number with its point in the wrong place, or with several. */
    MALFORMED_NUMBER("malformed-number"),

    /** A number with a decimal comma. */
    DECIMAL_COMMA("decimal-comma"),

    /** A number that does not fit 32 bits. */
    NUMBER_TOO_LARGE("number-too-large"),

    /** A `repeat` count that is not a whole number. */
    COUNT_NOT_WHOLE("count-not-whole"),

    /** A negative `repeat` count. */
    COUNT_NEGATIVE("count-negative"),

    /** A negative waiting time. */
    WAIT_NEGATIVE("wait-negative"),

    /** A command that takes longer than [RobolangLimits.LONGEST_COMMAND_MILLISECONDS]. */
    DURATION_TOO_LONG("duration-too-long"),

    /** Blocks nested deeper than [RobolangLimits.NESTED_BLOCKS]. */
    NESTED_TOO_DEEPLY("nested-too-deeply"),

    /** The source is longer than [RobolangLimits.SOURCE_CHARACTERS], so it was not parsed. */
    SOURCE_TOO_LONG("source-too-long"),

    /** A text without its closing quotation mark. */
    UNCLOSED_TEXT("unclosed-text"),

    /** `=` where two values are compared. */
    ASSIGNMENT_IN_EXPRESSION("assignment-in-expression"),

    /** `==` where a variable gets a value. */
    COMPARISON_AS_COMMAND("comparison-as-command"),

    /** `+=` and similar operators. */
    COMBINED_ASSIGNMENT("combined-assignment"),

    /** A command without its condition. */
    MISSING_CONDITION("missing-condition"),

    /** A value is missing. */
    MISSING_VALUE("missing-value"),

    /** A name is missing. */
    MISSING_NAME("missing-name"),

    /** A keyword used as a name. */
    RESERVED_WORD("reserved-word"),

    /** A name with an invalid character, or that does not begin with a letter. */
    MALFORMED_NAME("malformed-name"),

    /** Two values without a comma between them. */
    MISSING_COMMA("missing-comma"),

    /** A bracket is never closed. */
    MISSING_BRACKET("missing-bracket"),

    /** A routine without its brackets. */
    MISSING_BRACKETS("missing-brackets"),

    /** A word that belongs to a command is missing. */
    MISSING_WORD("missing-word"),

    /** `button` without `run`, `view` or `prgm`. */
    MISSING_BUTTON("missing-button"),

    /** `start` without a direction. */
    MISSING_MOVE("missing-move"),

    /** `motor` without `A`, `B` or `C`. */
    MISSING_MOTOR("missing-motor"),

    /** `motor A` without its command. */
    MISSING_MOTOR_COMMAND("missing-motor-command"),

    /** `facing` without `down` or `forward`. */
    MISSING_FACING("missing-facing"),

    /** `brick` without `rcx` or `nxt`. */
    MISSING_BRICK("missing-brick"),

    /** A sensor port that the brick does not have. */
    PORT_OUT_OF_RANGE("port-out-of-range"),

    /** A move with both a length and a time. */
    LENGTH_AND_TIME("length-and-time"),

    /** An `else` without an `if`. */
    EXTRA_ELSE("extra-else"),

    /** A routine, behaviour or header inside a block. */
    NOT_OUTERMOST("not-outermost"),

    /** A second header. */
    SECOND_ROBOT("second-robot"),

    /** An unknown line in the header. */
    UNKNOWN_SETTING("unknown-setting"),

    /** A header line outside the header. */
    SETTING_OUTSIDE_ROBOT("setting-outside-robot"),

    /** An expression nested deeper than [RobolangLimits.NESTED_EXPRESSIONS]. */
    EXPRESSION_TOO_DEEP("expression-too-deep"),

    /** An unknown variable. */
    UNKNOWN_VARIABLE("unknown-variable"),

    /** An unknown procedure or function. */
    UNKNOWN_ROUTINE("unknown-routine"),

    /** A variable that is, or may be, used before its declaration. */
    USED_BEFORE_DECLARATION("used-before-declaration"),

    /** A name that is declared already. */
    DECLARED_TWICE("declared-twice"),

    /** An assignment to a constant or the variable of a `for`. */
    ASSIGNED_CONSTANT("assigned-constant"),

    /** A condition or a list where a number is required. */
    NUMBER_NEEDED("number-needed"),

    /** A decimal number where a whole one is required. */
    WHOLE_NUMBER_NEEDED("whole-number-needed"),

    /** A number or a list where a condition is required. */
    CONDITION_NEEDED("condition-needed"),

    /** A number or a condition where a list is required. */
    LIST_NEEDED("list-needed"),

    /** A text anywhere except after `show`. */
    TEXT_AS_VALUE("text-as-value"),

    /** A procedure where a value is required. */
    VALUE_NEEDED("value-needed"),

    /** An assignment of a value of another type than the variable has. */
    TYPE_CHANGED("type-changed"),

    /** A comparison of different types, or of lists. */
    NOT_COMPARABLE("not-comparable"),

    /** A list that holds something other than numbers. */
    MIXED_LIST("mixed-list"),

    /** A list without elements. */
    EMPTY_LIST("empty-list"),

    /** A list with more elements than [RobolangLimits.LIST_ELEMENTS]. */
    LIST_TOO_LONG("list-too-long"),

    /** A list index out of range. */
    INDEX_OUT_OF_RANGE("index-out-of-range"),

    /** A call with too many or too few arguments. */
    WRONG_ARGUMENT_COUNT("wrong-argument-count"),

    /** A function whose value is not used. */
    FUNCTION_AS_COMMAND("function-as-command"),

    /** `break` or `continue` outside a loop. */
    OUTSIDE_LOOP("outside-loop"),

    /** `return` outside a routine. */
    OUTSIDE_ROUTINE("outside-routine"),

    /** A `return` with a value in a procedure. */
    RETURN_WITH_VALUE("return-with-value"),

    /** A `return` without a value in a function. */
    RETURN_WITHOUT_VALUE("return-without-value"),

    /** A function that may end without a `return`. */
    MISSING_RETURN("missing-return"),

    /** A negative duration of a move, a turn or a tone. */
    DURATION_NEGATIVE("duration-negative"),

    /** A motor power outside [RobolangLimits.POWERS]. */
    POWER_OUT_OF_RANGE("power-out-of-range"),

    /** A text with more characters than the brick shows. */
    TEXT_TOO_LONG("text-too-long"),

    /** A text with a character that the LCD cannot show. */
    TEXT_NOT_SHOWN("text-not-shown"),

    /** A division by 0. */
    DIVISION_BY_ZERO("division-by-zero"),

    /** A `for` with a step of 0. */
    STEP_ZERO("step-zero"),

    /** More variables than [RobolangLimits.VARIABLES]. */
    TOO_MANY_VARIABLES("too-many-variables"),

    /** More parameters than [RobolangLimits.PARAMETERS]. */
    TOO_MANY_PARAMETERS("too-many-parameters"),

    /** More numbers and texts than [RobolangLimits.CONSTANTS]. */
    TOO_MANY_CONSTANTS("too-many-constants"),

    /** More routines than [RobolangLimits.ROUTINES]. */
    TOO_MANY_ROUTINES("too-many-routines"),

    /** A header that names another brick than the robot has. */
    WRONG_BRICK("wrong-brick"),

    /** Something that the brick cannot do. */
    BRICK_LACKS("brick-lacks"),

    /** Two sensors on one port. */
    PORT_SHARED("port-shared"),

    /** A number, a condition or a list where a colour is expected. */
    COLOUR_NEEDED("colour-needed"),

    /** A variable that is never used. */
    UNUSED_VARIABLE("unused-variable"),

    /** A line that is never executed. */
    NEVER_REACHED("never-reached"),

    /** A `repeat forever` that neither moves, waits nor senses. */
    BUSY_LOOP("busy-loop"),

    /** A division of whole numbers that loses its fraction. */
    FRACTION_LOST("fraction-lost"),

    /** A constant divisor that does not fit the 16 bits that the brick uses. */
    DIVISOR_TOO_LARGE("divisor-too-large"),

    /** A list that is created repeatedly. */
    LIST_IN_LOOP("list-in-loop"),

    /** A routine that always calls itself. */
    ENDLESS_RECURSION("endless-recursion"),
}
