package robotran.lejoslinker.image

import robotran.lejoslinker.image.FieldType.FLOAT
import robotran.lejoslinker.image.FieldType.INT
import robotran.lejoslinker.image.FieldType.LONG
import robotran.lejoslinker.image.FieldType.REFERENCE

/**
 * The value of a constant; equal ones share a number. Source of types and bytes: leJOS `ConstantRecord` and
 * `ConstantValue`.
 */
sealed interface ConstantValue {
    /** The type in the image. */
    val type: FieldType

    /** Its bytes in the image; big-endian for a brick and for the emulator. */
    val bytes: ByteArray

    /** The firmware makes one char of each byte, so all characters must be below 256. */
    data class Text(val text: String) : ConstantValue {
        override val type get() = REFERENCE
        override val bytes get() = ByteArray(text.length) { text[it].code.toByte() }
    }

    data class Whole(val value: Int) : ConstantValue {
        override val type get() = INT
        override val bytes get() = bytesOf(value)
    }

    /** @property bits as `Float.toBits`, so that all NaN are equal and 0 and -0 are not. */
    data class Decimal(val bits: Int) : ConstantValue {
        override val type get() = FLOAT
        override val bytes get() = bytesOf(bits)
    }

    /** The firmware knows only the low 32 bits of a long. */
    data class LongWhole(val value: Long) : ConstantValue {
        override val type get() = LONG
        override val bytes get() = bytesOf(0) + bytesOf(value.toInt())
    }

    /**
     * The firmware calculates with floats, and leJOS's linker gives a double the type of a long.
     *
     * @property bits as `Double.toBits`.
     */
    data class LongDecimal(val bits: Long) : ConstantValue {
        override val type get() = LONG
        override val bytes get() = bytesOf(0) + bytesOf(Double.fromBits(bits).toFloat().toBits())
    }
}

private const val WORD_BYTES = 4
private const val BYTE_BITS = 8

private fun bytesOf(word: Int) = ByteArray(WORD_BYTES) { (word shr (WORD_BYTES - 1 - it) * BYTE_BITS).toByte() }
