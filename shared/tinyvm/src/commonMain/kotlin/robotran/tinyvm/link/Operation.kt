package robotran.tinyvm.link

/**
 * The operations of the interpreter, each followed by its operands. Each costs one bytecode, except [STATEMENT] and
 * [INITIALIZE], which are free. On an RCX, a long or a double takes two stack words: its value and an unused word above.
 */
internal object Operation {
    /** Operand: the line. Occurs only in a program's own classes, before the first bytecode of each line. */
    const val STATEMENT = 0
    const val NOTHING = 1

    /** Operand: the value. */
    const val PUSH = 2
    const val PUSH_WIDE = 3

    /** Operand: the number of the string constant. */
    const val PUSH_TEXT = 4

    /** Operand: the local. */
    const val LOAD = 5
    const val STORE = 6
    const val LOAD_WIDE = 7
    const val STORE_WIDE = 8

    /** Operands: the local and the increment. */
    const val INCREMENT = 9
    const val ELEMENT = 10
    const val ELEMENT_WIDE = 11
    const val SET_ELEMENT = 12
    const val SET_BYTE = 13
    const val SET_CHARACTER = 14
    const val SET_SHORT = 15
    const val SET_REFERENCE = 16
    const val SET_WIDE = 17
    const val POP = 18
    const val POP_2 = 19
    const val DUPLICATE = 20
    const val DUPLICATE_BELOW_1 = 21
    const val DUPLICATE_BELOW_2 = 22
    const val DUPLICATE_2 = 23
    const val DUPLICATE_2_BELOW_1 = 24
    const val DUPLICATE_2_BELOW_2 = 25
    const val SWAP = 26
    const val ADD = 27
    const val SUBTRACT = 28
    const val MULTIPLY = 29
    const val DIVIDE = 30
    const val REMAINDER = 31
    const val NEGATE = 32
    const val SHIFT_LEFT = 33
    const val SHIFT_RIGHT = 34
    const val SHIFT_RIGHT_UNSIGNED = 35
    const val AND = 36
    const val OR = 37
    const val XOR = 38
    const val ADD_FLOAT = 39
    const val SUBTRACT_FLOAT = 40
    const val MULTIPLY_FLOAT = 41
    const val DIVIDE_FLOAT = 42
    const val NEGATE_FLOAT = 43
    const val ADD_DOUBLE = 44
    const val SUBTRACT_DOUBLE = 45
    const val MULTIPLY_DOUBLE = 46
    const val DIVIDE_DOUBLE = 47
    const val NEGATE_DOUBLE = 48
    const val COMPARE_FLOAT_LOW = 49
    const val COMPARE_FLOAT_HIGH = 50
    const val COMPARE_DOUBLE_LOW = 51
    const val COMPARE_DOUBLE_HIGH = 52
    const val WIDEN = 53
    const val NARROW = 54
    const val INT_TO_FLOAT = 55
    const val INT_TO_DOUBLE = 56
    const val LONG_TO_FLOAT = 57
    const val LONG_TO_DOUBLE = 58
    const val FLOAT_TO_INT = 59
    const val FLOAT_TO_LONG = 60
    const val DOUBLE_TO_INT = 61
    const val DOUBLE_TO_LONG = 62
    const val TO_BYTE = 63
    const val TO_CHARACTER = 64
    const val TO_SHORT = 65

    /** Operand of this and the next twelve: the branch target. */
    const val IF_ZERO = 66
    const val IF_NOT_ZERO = 67
    const val IF_NEGATIVE = 68
    const val IF_NOT_NEGATIVE = 69
    const val IF_POSITIVE = 70
    const val IF_NOT_POSITIVE = 71
    const val IF_EQUAL = 72
    const val IF_NOT_EQUAL = 73
    const val IF_LESS = 74
    const val IF_NOT_LESS = 75
    const val IF_GREATER = 76
    const val IF_NOT_GREATER = 77
    const val JUMP = 78

    /** Operand: the start of the subroutine. */
    const val SUBROUTINE = 79

    /** Operand: the local that holds the return position. */
    const val END_SUBROUTINE = 80

    /** Operand: the slot. */
    const val STATIC = 81
    const val STATIC_WIDE = 82
    const val SET_STATIC = 83
    const val SET_STATIC_WIDE = 84

    /** Operand: the number of the class to initialize before the next operation. */
    const val INITIALIZE = 85

    /** Operand: the index of the word in the object. */
    const val FIELD = 86
    const val FIELD_WIDE = 87
    const val SET_FIELD = 88
    const val SET_FIELD_WIDE = 89

    /** Operand: the number of the method. */
    const val CALL_STATIC = 90
    const val CALL_EXACTLY = 91

    /** Operands: the index of the virtual method or the number of the interface method, and the argument words. */
    const val CALL_VIRTUAL = 92
    const val CALL_INTERFACE = 93
    const val RETURN = 94
    const val RETURN_VALUE = 95
    const val RETURN_WIDE = 96

    /** Operand: the type. */
    const val NEW = 97
    const val NEW_ARRAY = 98

    /** Operands: the type and the number of dimensions to create. */
    const val NEW_ARRAYS = 99
    const val LENGTH = 100
    const val THROW = 101

    /** Operand: the type. */
    const val CAST = 102
    const val IS_INSTANCE = 103
    const val ENTER_MONITOR = 104
    const val EXIT_MONITOR = 105

    /** Set a field of type char. Operand: the index of the word in the object, or the slot of a static field. */
    const val SET_FIELD_CHARACTER = 106
    const val SET_STATIC_CHARACTER = 107

    /**
     * The operations from here on are those of an exact machine, in which a long or a double has its lower word in the first
     * stack word and its upper word in the second.
     */
    const val FIRST_EXACT = 108

    /** Operands: the lower and the upper word. */
    const val PUSH_LONG = 108

    /** Operand: the first local. */
    const val LOAD_LONG = 109
    const val STORE_LONG = 110

    /** Operand: the first slot. */
    const val STATIC_LONG = 111
    const val SET_STATIC_LONG = 112

    /** Operand: the index of the first word in the object. */
    const val FIELD_LONG = 113
    const val SET_FIELD_LONG = 114
    const val ELEMENT_LONG = 115
    const val SET_ELEMENT_LONG = 116

    /** This and the next eleven calculate with long. */
    const val ADD_LONG = 117
    const val SUBTRACT_LONG = 118
    const val MULTIPLY_LONG = 119
    const val DIVIDE_LONG = 120
    const val REMAINDER_LONG = 121
    const val NEGATE_LONG = 122
    const val SHIFT_LEFT_LONG = 123
    const val SHIFT_RIGHT_LONG = 124
    const val SHIFT_RIGHT_UNSIGNED_LONG = 125
    const val AND_LONG = 126
    const val OR_LONG = 127
    const val XOR_LONG = 128

    /** This and the next six calculate with decimals. */
    const val REMAINDER_FLOAT = 129
    const val ADD_DOUBLE_64 = 130
    const val SUBTRACT_DOUBLE_64 = 131
    const val MULTIPLY_DOUBLE_64 = 132
    const val DIVIDE_DOUBLE_64 = 133
    const val REMAINDER_DOUBLE_64 = 134
    const val NEGATE_DOUBLE_64 = 135

    /** This and the next nine convert. */
    const val INT_TO_LONG = 136
    const val INT_TO_DOUBLE_64 = 137
    const val LONG_TO_INT = 138
    const val LONG_64_TO_FLOAT = 139
    const val LONG_64_TO_DOUBLE = 140
    const val FLOAT_TO_LONG_64 = 141
    const val FLOAT_TO_DOUBLE_64 = 142
    const val DOUBLE_64_TO_INT = 143
    const val DOUBLE_64_TO_LONG = 144
    const val DOUBLE_64_TO_FLOAT = 145
    const val COMPARE_LONG = 146
    const val COMPARE_DOUBLE_64_LOW = 147
    const val COMPARE_DOUBLE_64_HIGH = 148

    /** Operand: the index in [MethodBody.switches]. */
    const val SWITCH = 149

    /** Operand: the type. */
    const val PUSH_CLASS = 150
}
