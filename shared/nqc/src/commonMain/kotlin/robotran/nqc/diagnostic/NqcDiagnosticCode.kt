package robotran.nqc.diagnostic

import robotran.language.source.ProblemCode
import robotran.language.source.Severity

/**
 * The kinds of problems.
 *
 * @property original what the original compiler says, with `%s` for a word of the program; null if it says nothing.
 */
enum class NqcDiagnosticCode(val original: String?, val severity: Severity = Severity.ERROR) : ProblemCode {
    FILE_NOT_FOUND("could not open file %s"),
    INCLUDE_NEEDS_NAME("#include requires a filename"),

    /** Files that include each other, or too many of them. */
    TOO_MANY_INCLUDES(null),
    DIRECTIVE_NEEDS_NAME("%s required a symbol name"),
    MACRO_REDEFINED("redefinition of '%s'"),
    MACRO_PARAMETERS("illegal define arguments"),

    /** `#define TIME 100;` and `#define TIME = 100`. */
    MACRO_SIGN(SYNTAX),
    MACRO_CIRCULAR("circular definition in '%s'"),
    MACRO_ARGUMENTS("wrong number of arguments to '%s'"),

    /** Macros that would make the program endless. */
    MACROS_TOO_LONG(null),
    UNTERMINATED_IF("unterminated #if/#ifdef/#ifndef"),
    ELSE_WITHOUT_IF("%s without preceding #if/#ifdef/#ifndef"),
    UNKNOWN_DIRECTIVE("illegal preprocessor directive"),
    CONDITION_SYNTAX("syntax error in expression"),
    CONDITION_INCOMPLETE("unexpected end of line"),
    CONDITION_BRACKETS("unbalanced parentheses"),
    UNTERMINATED_COMMENT("unterminated comment"),
    ERROR_DIRECTIVE("preprocessor #error directive"),
    WARNING_DIRECTIVE("preprocessor #warning directive", Severity.WARNING),
    UNKNOWN_PRAGMA("illegal #pragma", Severity.WARNING),
    NOT_RESERVED("could not reserve variables"),

    UNEXPECTED_TOKEN(SYNTAX),
    UNKNOWN_CHARACTER(SYNTAX),

    /** `Task main()`. */
    MISSPELLED_WORD(SYNTAX),

    /** `float x;` */
    OTHER_TYPE(SYNTAX),
    TEXT_AS_VALUE(SYNTAX),
    MISSING_SEMICOLON(SYNTAX),
    MISSING_BRACKET(SYNTAX),
    MISSING_BRACE(SYNTAX),
    MISSING_VALUE(SYNTAX),
    MISSING_NAME(SYNTAX),
    MISSING_BLOCK(SYNTAX),
    MISSING_COLON(SYNTAX),

    /** `x = f();`: a function has no value. */
    CALL_AS_VALUE(SYNTAX),

    /** `if (a = 1)`. */
    ASSIGNMENT_AS_VALUE(SYNTAX),

    /** `a ? b : c ? d : e`. */
    SECOND_CHOICE(SYNTAX),

    /** `return 5;` */
    RETURN_WITH_VALUE(SYNTAX),

    /** `int f() { }` */
    FUNCTION_WITH_TYPE(SYNTAX),

    /** `inline void f() { }` */
    INLINE_WRITTEN(SYNTAX),
    CATCH_ALONE(SYNTAX),
    ELSE_ALONE(SYNTAX),
    DECLARATION_IN_FOR(SYNTAX),

    /** A task, subroutine or function in another one. */
    NESTED_UNIT(SYNTAX),

    /** A statement outside of any task. */
    OUTSIDE_TASK(SYNTAX),
    RESOURCE_WRITTEN(null),
    SOURCE_TOO_LONG(null),
    NESTED_TOO_DEEPLY(null),
    NUMBER_TOO_LARGE(null),

    MAIN_MISSING("task 'main' not defined"),
    REDECLARED("'%s' cannot be redeclared"),
    UNDEFINED_VARIABLE("undefined variable '%s'"),
    UNDEFINED_FUNCTION("undefined function '%s'"),
    UNDEFINED_TASK("undefined task '%s'"),
    UNDEFINED_LABEL("undefined label '%s'"),
    LABEL_REDEFINED("label '%s' redefined"),
    NO_STORAGE("could not allocate storage for variable"),
    NO_TEMPORARIES("Ran out of temporary variables"),
    CONSTANT_NEEDED("constant expression required"),
    NUMBER_OUT_OF_RANGE("number out of range"),
    CASE_OUT_OF_RANGE("case value must be between -32768 and 32767"),
    NOT_ASSIGNABLE("expression is not a legal target for assignment"),
    WRONG_SOURCE("Expression is not a valid argument type"),
    ARGUMENT_NOT_CONSTANT("argument must be a constant"),
    ARGUMENT_NOT_VARIABLE("argument must be a variable"),
    ARGUMENT_NOT_SENSOR("argument must be a sensor"),
    ARGUMENT_NOT_POINTER("argument must be a pointer"),
    ARGUMENT_COUNT("wrong number of parameters"),
    NESTED_SUB("nested subroutine calls are not allowed"),
    RECURSION("recursive function call: '%s'"),
    NESTED_ACQUIRE("nested resource acquisition is not allowed"),
    NESTED_MONITOR("nested event monitoring is not allowed"),
    CONTINUE_OUTSIDE_LOOP("'continue' is only valid within a loop"),
    BREAK_OUTSIDE_LOOP("'break' is only valid in a switch or loop"),
    CASE_OUTSIDE_SWITCH("case/default only valid in a switch"),
    DUPLICATE_CASE("duplicate case or default label in switch"),
    TOO_MANY_TASKS("maximum of 10 tasks exceeded"),
    TOO_MANY_SUBS("maximum of 8 subroutines exceeded"),
    ACQUIRE_UNSUPPORTED("RCX does not support resource acquisition"),
    MONITOR_UNSUPPORTED("RCX does not support event monitoring"),
    ARRAY_UNSUPPORTED("RCX does not support arrays"),
    POINTER_UNSUPPORTED("RCX does not support indirect variables"),
    SUB_PARAMETERS("%s does not support subroutine parameters"),
    WRONG_EVENT_SOURCE("illegal event source"),
    IS_ARRAY("%s is an array"),
    IS_NOT_ARRAY("%s is not an array"),
    IS_NOT_POINTER("%s is not a pointer"),
    INIT_UNDEFINED("initialization function '%s' is not defined"),
    TASK_NUMBER_UNKNOWN("sub called by multiple tasks - __taskid cannot be determined"),
    ADDRESS_NOT_CONSTANT("cannot take the address of an array with a non-constant index"),

    /** A constant divided by 0: the original crashes. */
    CONSTANT_DIVIDED_BY_ZERO(null),
    WRONG_ARRAY_SIZE(null),
    PROGRAM_TOO_LONG(null),

    DIVIDED_BY_ZERO(null, Severity.WARNING),
    NUMBER_CUT(null, Severity.WARNING),
    ARGUMENT_RANGE(null, Severity.WARNING),
    INDEX_OUTSIDE(null, Severity.WARNING),
    NO_EFFECT(null, Severity.WARNING),
    MEMORY_FULL(null, Severity.WARNING),

    TASK_NEVER_STARTED(null, Severity.WARNING),

    /** `if (x);` */
    EMPTY_BODY(null, Severity.WARNING),

    /** Two lines below an `if` without braces. */
    MISLEADING_INDENT(null, Severity.WARNING),

    /** A sensor is compared, but nothing says what is connected. */
    SENSOR_NOT_SET(null, Severity.WARNING),
    ;

    override val id: String = name.lowercase().replace('_', '-')
}

private const val SYNTAX = "syntax error"
