package robotran.tinyvm.link

/**
 * The operations of [RegisterCode]. Their operands are the locals and operand stack slots of a frame, called registers
 * and numbered from its first local. An instruction is one word, with the operation in the lowest byte and the operands
 * A, B and C in the others; for some operations, B and C together are a signed number, here D. Further words follow
 * where noted. C is signed where it is a constant.
 */
internal object RegisterOperation {
    /** Next word: the block to continue with. */
    const val JUMP = 0

    /** A = B. */
    const val MOVE = 1

    /** A = B, and the register after A = C. */
    const val MOVE_2 = 2

    /** A = D. */
    const val CONSTANT = 3

    /** A = the next word. */
    const val WIDE_CONSTANT = 4

    /** This and the next 14: A = B operation C. */
    const val ADD = 5
    const val SUBTRACT = 6
    const val MULTIPLY = 7
    const val DIVIDE = 8
    const val REMAINDER = 9
    const val SHIFT_LEFT = 10
    const val SHIFT_RIGHT = 11
    const val SHIFT_RIGHT_UNSIGNED = 12
    const val AND = 13
    const val OR = 14
    const val XOR = 15
    const val ADD_FLOAT = 16
    const val SUBTRACT_FLOAT = 17
    const val MULTIPLY_FLOAT = 18
    const val DIVIDE_FLOAT = 19

    /** This and the next seven: A = B operation C, a constant, positive for the divisions. */
    const val ADD_CONSTANT = 20
    const val MULTIPLY_CONSTANT = 21
    const val DIVIDE_CONSTANT = 22
    const val REMAINDER_CONSTANT = 23
    const val SHIFT_LEFT_CONSTANT = 24
    const val SHIFT_RIGHT_CONSTANT = 25
    const val SHIFT_RIGHT_UNSIGNED_CONSTANT = 26
    const val AND_CONSTANT = 27

    /** A = A + D. */
    const val INCREMENT = 28

    /** This and the next six: A = operation B. */
    const val NEGATE = 29
    const val NEGATE_FLOAT = 30
    const val TO_BYTE = 31
    const val TO_CHARACTER = 32
    const val TO_SHORT = 33
    const val INT_TO_FLOAT = 34
    const val FLOAT_TO_INT = 35

    /** A = -1, 0 or 1 as B is less than, equal to or greater than C. */
    const val COMPARE_FLOAT = 36

    /** A = field C of B. */
    const val FIELD = 37

    /** Field B of A = C. */
    const val SET_FIELD = 38

    /** A = static field B. */
    const val STATIC = 39

    /** Static field A = B. */
    const val SET_STATIC = 40

    /** A = B[C]. */
    const val ELEMENT = 41

    /** This and the next three: A[B] = C. */
    const val SET_ELEMENT = 42
    const val SET_BYTE = 43
    const val SET_CHARACTER = 44
    const val SET_SHORT = 45

    /** A = length of B. */
    const val LENGTH = 46

    /** Next words of this and the next three: the blocks to continue with if A and B satisfy the condition and if not. */
    const val IF_EQUAL = 47
    const val IF_NOT_EQUAL = 48
    const val IF_LESS = 49
    const val IF_NOT_LESS = 50

    /** The same for A and the constant D. */
    const val IF_EQUAL_CONSTANT = 51
    const val IF_NOT_EQUAL_CONSTANT = 52
    const val IF_LESS_CONSTANT = 53
    const val IF_NOT_LESS_CONSTANT = 54

    /** Ensures that class A is initialized. */
    const val INITIALIZE = 55

    /** Calls method B with the arguments from register A on. Next word: the position in the stack code after the call. */
    const val CALL_STATIC = 56

    /** The same for method B of the object in C, which it puts in A as the first argument. */
    const val CALL_EXACTLY = 57

    /** The same for virtual method B of the object in C. */
    const val CALL_VIRTUAL = 58
    const val RETURN = 59

    /** Returns A, and for [RETURN_WIDE] an unused word. */
    const val RETURN_VALUE = 60
    const val RETURN_WIDE = 61

    /** Executes an operation of [Operation]. A: the end of the operands. Next word: its position in the stack code. */
    const val PLAIN = 62

    /** This and the next replace several others; see [InstructionFusion]. A = field of B [C]. Next word: the field. */
    const val FIELD_ELEMENT = 63

    /** A = B * C, a constant, + the register in the next word. */
    const val MULTIPLY_CONSTANT_ADD = 64

    /** Field of A = B + C. Next word: the field. */
    const val SET_FIELD_SUM = 65

    /** Field B of A increases by C, a constant. */
    const val INCREMENT_FIELD = 66

    /** Static field A increases by C, a constant. */
    const val INCREMENT_STATIC = 67

    /** A increases by C, a constant. Next words: a constant; the blocks if A is less than that, and if not. */
    const val INCREMENT_IF_LESS_CONSTANT = 68

    /** A increases by C, a constant. Next words: the blocks if A is less than B, and if not. */
    const val INCREMENT_IF_LESS = 69

    /** Next words: the blocks if A and C, a constant, have no common bit, and if they have. */
    const val IF_NO_BIT = 70

    /** Next words: the blocks if field B of A is equal to C, a constant, and if not. */
    const val IF_FIELD_EQUAL_CONSTANT = 71

    /** Next words: the blocks if field B of A is less than C, a constant, and if not. */
    const val IF_FIELD_LESS_CONSTANT = 72

    /**
     * The instructions from here on are those that a program for an RCX has seldom or never. The interpreter's loop leaves
     * them to [robotran.tinyvm.run.FarCalls] and [robotran.tinyvm.run.WideOperations]. Of a long or a double, an operand is
     * its first register.
     */
    const val FIRST_FAR_CALL = 73

    /** [CALL_STATIC] and [CALL_EXACTLY] of the method in the word behind the next. */
    const val CALL_STATIC_FAR = 73
    const val CALL_EXACTLY_FAR = 74

    /** [CALL_VIRTUAL] of interface method B. */
    const val CALL_INTERFACE = 75

    /** The first one that [robotran.tinyvm.run.WideOperations] executes. */
    const val FIRST_WIDE = 76

    /** A = the static field in the next word. */
    const val STATIC_FAR = 76

    /** The static field in the next word = A. */
    const val SET_STATIC_FAR = 77

    /**
     * Continues with one of the instructions behind the next word, which are a [JUMP] for each target of a `switch`, for the
     * number in A. The next word is the index of its table.
     */
    const val SWITCH = 78

    /** This and the next 31 calculate, compare or convert B and C, or B alone, in the order of [Operation]. */
    const val ADD_LONG = 79
    const val SUBTRACT_LONG = 80
    const val MULTIPLY_LONG = 81
    const val DIVIDE_LONG = 82
    const val REMAINDER_LONG = 83
    const val NEGATE_LONG = 84
    const val SHIFT_LEFT_LONG = 85
    const val SHIFT_RIGHT_LONG = 86
    const val SHIFT_RIGHT_UNSIGNED_LONG = 87
    const val AND_LONG = 88
    const val OR_LONG = 89
    const val XOR_LONG = 90
    const val REMAINDER_FLOAT = 91
    const val ADD_DOUBLE = 92
    const val SUBTRACT_DOUBLE = 93
    const val MULTIPLY_DOUBLE = 94
    const val DIVIDE_DOUBLE = 95
    const val REMAINDER_DOUBLE = 96
    const val NEGATE_DOUBLE = 97
    const val INT_TO_LONG = 98
    const val INT_TO_DOUBLE = 99
    const val LONG_TO_INT = 100
    const val LONG_TO_FLOAT = 101
    const val LONG_TO_DOUBLE = 102
    const val FLOAT_TO_LONG = 103
    const val FLOAT_TO_DOUBLE = 104
    const val DOUBLE_TO_INT = 105
    const val DOUBLE_TO_LONG = 106
    const val DOUBLE_TO_FLOAT = 107
    const val COMPARE_LONG = 108
    const val COMPARE_DOUBLE_LOW = 109
    const val COMPARE_DOUBLE_HIGH = 110

    /** A = field C of B. */
    const val FIELD_LONG = 111

    /** Field B of A = C. */
    const val SET_FIELD_LONG = 112

    /** A = B[C]. */
    const val ELEMENT_LONG = 113

    /** A[B] = C. */
    const val SET_ELEMENT_LONG = 114

    /** A = the static field in the next word. */
    const val STATIC_LONG = 115

    /** The static field in the next word = A. */
    const val SET_STATIC_LONG = 116

    /** Ensures that A is null or of the type in the next word. */
    const val CAST = 117

    /** A = whether B is of the type in the next word. */
    const val IS_INSTANCE = 118

    /** A[B] = C, a reference. */
    const val SET_REFERENCE = 119

    /** The operations whose result is in A and the next register. */
    val WITH_WIDE_RESULT: Set<Int> =
        (ADD_LONG..DOUBLE_TO_FLOAT).toSet() + setOf(FIELD_LONG, ELEMENT_LONG, STATIC_LONG) -
            setOf(REMAINDER_FLOAT, INT_TO_LONG, LONG_TO_INT, LONG_TO_FLOAT, DOUBLE_TO_INT, DOUBLE_TO_FLOAT)

    /** The operations whose result is in A. */
    val WITH_RESULT: Set<Int> = setOf(MOVE, CONSTANT, WIDE_CONSTANT, FIELD, STATIC, ELEMENT, LENGTH, STATIC_FAR) +
        (ADD..AND_CONSTANT) + (NEGATE..COMPARE_FLOAT)
}
