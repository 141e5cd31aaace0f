package robotran.legofirmware.instructions

/**
 * How an instruction holds the address that it may continue at. A distance counts from the address of the first byte of
 * the distance itself.
 *
 * @property size in bytes.
 * @property reach the distances that fit, negative ones backwards.
 */
enum class JumpForm(val size: Int, val reach: IntRange) {
    /** Bit 7 means backwards, bits 0..6 are the distance. */
    SHORT_JUMP(1, -0x7F..0x7F),

    /** Like [SHORT_JUMP], with bits 7..14 of the distance in a second byte. */
    LONG_JUMP(2, -0x7FFF..0x7FFF),

    /** One byte, forwards only. */
    SHORT_BRANCH(1, 0..0xFF),

    /** 16 bits with a sign, low byte first. */
    LONG_BRANCH(2, -0x8000..0x7FFF),

    /** 16 bits without a sign, low byte first. */
    LONG_LOOP(2, 0..0xFFFF),
    ;

    /** Whether a jump whose distance is at [base] can continue at [target]. */
    fun reaches(base: Int, target: Int): Boolean = target - base in reach

    /**
     * The bytes of the distance as one number, low byte first.
     *
     * @param target within [reach] of [base].
     */
    fun encode(base: Int, target: Int): Int {
        val distance = target - base
        require(distance in reach) { "Distance $distance does not fit $this." }
        return when (this) {
            SHORT_JUMP -> signAndDistance(distance)
            LONG_JUMP -> signAndDistance(distance) or (magnitude(distance) shr LOW_BITS shl Byte.SIZE_BITS)
            SHORT_BRANCH, LONG_BRANCH, LONG_LOOP -> distance and WORD_MASK
        }
    }

    /** The target of a jump whose distance is at [base] and has the bytes [encoded], low byte first. */
    fun decode(base: Int, encoded: Int): Int = base + when (this) {
        SHORT_JUMP -> signed(encoded, encoded and LOW_MASK)
        LONG_JUMP -> signed(encoded, (encoded and LOW_MASK) or (encoded shr Byte.SIZE_BITS shl LOW_BITS))
        SHORT_BRANCH, LONG_LOOP -> encoded
        LONG_BRANCH -> encoded.toShort().toInt()
    }

    private fun signAndDistance(distance: Int): Int =
        (magnitude(distance) and LOW_MASK) or (if (distance < 0) BACKWARDS else 0)

    private fun magnitude(distance: Int): Int = if (distance < 0) -distance else distance

    private fun signed(encoded: Int, distance: Int): Int = if (encoded and BACKWARDS != 0) -distance else distance

    private companion object {
        const val BACKWARDS = 0x80
        const val LOW_MASK = 0x7F
        const val LOW_BITS = 7
        const val WORD_MASK = 0xFFFF
    }
}
