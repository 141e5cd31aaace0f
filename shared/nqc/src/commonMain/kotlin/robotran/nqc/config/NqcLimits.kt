package robotran.nqc.config

/** The limits of a program, so that no source can exhaust the stack, the memory or the time. All are ours. */
object NqcLimits {
    /** Max length of a file in UTF-16 characters: many times what fits into a brick. */
    const val SOURCE_CHARACTERS = 500_000

    /** Max depth of files that include each other, as in NQC. */
    const val INCLUDE_DEPTH = 16

    /** Max files of a program, as in NQC. */
    const val INCLUDED_FILES = 255

    /** Max tokens of a program after all macros are replaced. */
    const val TOKENS = 300_000

    /** Max tokens that macros put in, with those that later macros replace. */
    const val REPLACED_TOKENS = 600_000

    /** Max parameters of a macro. */
    const val MACRO_PARAMETERS = 32

    /** Max macros within a macro. */
    const val MACRO_DEPTH = 100

    /** Max nesting of blocks and statements; later phases walk the tree recursively. */
    const val NESTED_STATEMENTS = 100

    /** Max height of the tree of an expression, for the same reason. */
    const val EXPRESSION_HEIGHT = 100

    /** Max height after the arguments of functions are put in. */
    const val EXPANDED_HEIGHT = 200

    /** Max functions within a function. */
    const val CALL_DEPTH = 60

    /** Max bytes of a task or subroutine; a brick has about 6000 for everything. */
    const val CODE_BYTES = 30_000

    /** Max nodes that code generation visits: expressions are evaluated again and again where functions repeat them. */
    const val GENERATOR_STEPS = 2_000_000

    /** Max letters of a name in an image. */
    const val NAME_CHARACTERS = 200

    /** Longer words get no suggestion, which bounds the cost of comparing them. */
    const val SUGGESTION_CHARACTERS = 32

    /** Max length of a quotation of the source in a message. */
    const val QUOTED_CHARACTERS = 40
}
