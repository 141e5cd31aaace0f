package robotran.legofirmware.instructions

/**
 * What an operand of an instruction is.
 *
 * @property size in bytes.
 * @property jump how an address is held; null if the operand is none.
 */
enum class OperandKind(val size: Int, val jump: JumpForm? = null) {
    /** A source and a 16-bit argument, low byte first: [Operand.Value]. */
    VALUE(3),

    /** A source and an 8-bit argument: [Operand.Value]. */
    BYTE_VALUE(2),

    /** A source and a number that `set` writes to: [Operand.Value]. */
    PLACE(2),

    /** Two values and how to compare them: [Operand.Test]. The argument of the second value has 8 bits. */
    TEST(5),

    /** The number of a variable: [Operand.Number]. */
    VARIABLE(1),

    /** A mask of motors, 1 A, 2 B, 4 C: [Operand.Number]. */
    MOTORS(1),

    /** Like [MOTORS], with 80 hex for on and 40 for off: [Operand.Number]. */
    OUTPUT(1),

    /** Like [MOTORS], with 80 hex for forwards and 40 for the other direction: [Operand.Number]. */
    DIRECTION(1),

    /** A sensor, 0..2: [Operand.Number]. */
    SENSOR(1),

    /** A sensor's type, 0..4: [Operand.Number]. */
    SENSOR_TYPE(1),

    /** A sensor's mode in bits 5..7, its slope in bits 0..4: [Operand.Number]. */
    SENSOR_MODE(1),

    /** 0..255: [Operand.Number]. */
    BYTE(1),

    /** 0..65535, low byte first: [Operand.Number]. */
    WORD(2),

    /** A byte that is 0 and that no listing shows; an instruction has no operand for it. */
    ZERO(1),

    /** [Operand.Address] in each of these. */
    SHORT_JUMP(1, JumpForm.SHORT_JUMP),
    LONG_JUMP(2, JumpForm.LONG_JUMP),
    SHORT_BRANCH(1, JumpForm.SHORT_BRANCH),
    LONG_BRANCH(2, JumpForm.LONG_BRANCH),
    LONG_LOOP(2, JumpForm.LONG_LOOP),
}
