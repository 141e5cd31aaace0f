package robotran.javacompiler.ecj

/**
 * The kinds of problems that have messages of their own. Negative numbers are those of `BrickProblem`, and from -101 on
 * our own; positive ones are those of ECJ's `IProblem` without their category.
 */
internal object ProblemId {
    const val SWITCH = -1
    const val LONG_ARITHMETIC = -2
    const val FLOAT_REMAINDER = -3
    const val ARRAY_TYPE_TEST = -4
    const val CLASS_LITERAL = -5
    const val TEXT_JOINED_IN_LOOP = -6
    const val DIVISOR_TOO_LARGE = -7
    const val ARRAY_TOO_LONG = -8
    const val SOURCE_TOO_LONG = -9
    const val NESTED_TOO_DEEPLY = -10
    const val UNLOCKED_METHOD = -11
    const val UNLOCKED_SUPER_CALL = -12
    const val TEXT_AND_NUMBER = -13
    const val LIBRARY_GAP = -14
    const val TOO_MUCH_WORK = -15
    const val FINALLY_COPIED_TOO_OFTEN = -16
    const val TOO_MANY_IMPORTS = -17
    const val TOO_MANY_CLASSES = -18
    const val LARGE_STEP = -19

    // What StructureMistakes finds.
    const val OUTSIDE_CLASS = -101
    const val OUTSIDE_METHOD = -102
    const val METHOD_IN_METHOD = -103
    const val WORD_IN_OTHER_CASE = -104
    const val NAME_OF_SEVERAL_WORDS = -105
    const val CONDITION_WITHOUT_BRACKETS = -106
    const val RESERVED_NAME = -107

    const val UNDEFINED_TYPE = 2
    const val AMBIGUOUS_TYPE = 4
    const val TYPE_MISMATCH = 17
    const val UNDEFINED_NAME = 50
    const val UNINITIALIZED_LOCAL_VARIABLE = 51
    const val REDEFINED_LOCAL = 55
    const val REDEFINED_ARGUMENT = 56
    const val FINAL_LOCAL_ASSIGNED = 58
    const val METHOD_TOO_LONG = 63
    const val STATIC_INITIALIZER_TOO_LONG = 64
    const val CONSTRUCTOR_TOO_LONG = 69
    const val UNDEFINED_FIELD = 70
    const val FIELD_NOT_VISIBLE = 71
    const val NON_STATIC_FIELD = 74
    const val FINAL_FIELD_ASSIGNED = 80
    const val UNRESOLVED_VARIABLE = 83
    const val UNDEFINED_METHOD = 100
    const val METHOD_NOT_VISIBLE = 101
    const val VOID_METHOD_RETURNS_VALUE = 105
    const val SHOULD_RETURN_VALUE = 108
    const val MISSING_RETURN_TYPE = 111
    const val NO_MESSAGE_SEND_ON_BASE_TYPE = 114
    const val PARAMETER_MISMATCH = 115
    const val NO_MESSAGE_SEND_ON_ARRAY = 116
    const val UNDEFINED_CONSTRUCTOR = 130
    const val CONSTRUCTOR_NOT_VISIBLE = 131
    const val ARRAY_NEEDED = 150
    const val NUMERIC_VALUE_OUT_OF_RANGE = 154
    const val CLASS_IS_ABSTRACT = 157
    const val INVALID_OPERATOR = 160
    const val CODE_CANNOT_BE_REACHED = 161
    const val EXCEPTION_NEVER_THROWN = 167
    const val UNHANDLED_EXCEPTION = 168
    const val ASSIGNMENT_HAS_NO_EFFECT = 178
    const val POSSIBLE_ACCIDENTAL_BOOLEAN_ASSIGNMENT = 179
    const val UNREACHABLE_CATCH = 187
    const val EMPTY_STATEMENT = 188
    const val THIS_IN_STATIC = 200
    const val NON_STATIC_METHOD = 201
    const val PARSING_ERROR = 204
    const val ARRAY_CONSTANT_OUTSIDE_INITIALIZER = 208
    const val UNMATCHED_BRACKET = 220
    const val PARSING_ERROR_INSERT_BEFORE = 230
    const val PARSING_ERROR_INSERT_AFTER = 231
    const val PARSING_ERROR_DELETE = 232
    const val PARSING_ERROR_DELETE_SEVERAL = 233
    const val INVALID_TOKEN = 235
    const val PARSING_ERROR_INSERT_TO_COMPLETE = 240
    const val INVALID_CHARACTER_CONSTANT = 253
    const val UNTERMINATED_STRING = 259
    const val UNTERMINATED_COMMENT = 260
    const val BINARY_NUMBER = 267
    const val UNDERSCORES_IN_NUMBER = 269
    const val DUPLICATE_TYPE = 323
    const val PUBLIC_CLASS_MUST_MATCH_FILE_NAME = 325
    const val CLASS_MUST_BE_ABSTRACT = 333
    const val DUPLICATE_FIELD = 340
    const val DUPLICATE_METHOD = 355
    const val ABSTRACT_METHOD = 363
    const val IMPORT_NOT_FOUND = 390
    const val METHOD_NOT_WRITTEN = 400
    const val THROWS_MORE_THAN_OVERRIDDEN = 402
    const val REDUCED_VISIBILITY = 409
    const val TYPE_PARAMETERS = 590
    const val STATIC_IMPORT = 591
    const val FOR_EACH = 592
    const val TYPE_ARGUMENTS = 593
    const val ENUM = 594
    const val VARARGS = 595
    const val ANNOTATION = 596
    const val DEFAULT_METHOD = 644
    const val LAMBDA = 645
    const val METHOD_REFERENCE = 646
    const val RESOURCE_TOO_OLD = 874
    const val MULTI_CATCH = 875
    const val TEXT_IN_SWITCH = 881
    const val DIAMOND = 883
    const val STATIC_INTERFACE_METHOD = 896
    const val PREVIEW_FEATURE = 1107
    const val ARROW_IN_CASE = 1720
    const val SWITCH_EXPRESSION = 1721
}
