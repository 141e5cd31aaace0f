package robotran.tinyvm.debug

/** A natural number of any size that can be changed, for exact decimals. */
internal class NaturalNumber(value: Long) : Comparable<NaturalNumber> {
    /** Nine decimal digits each, the lowest ones first. */
    private var parts = IntArray(INITIAL_PARTS)
    private var size = 0

    init {
        var rest = value
        while (rest > 0) {
            append((rest % PART).toInt())
            rest /= PART
        }
    }

    private fun append(part: Int) {
        if (size == parts.size) parts = parts.copyOf(size * 2)
        parts[size++] = part
    }

    fun copy(): NaturalNumber = NaturalNumber(0).also {
        it.parts = parts.copyOf()
        it.size = size
    }

    /** Multiplies it by [factor], below a thousand million. */
    fun multiply(factor: Int) {
        var carry = 0L
        for (index in 0 until size) {
            val product = parts[index].toLong() * factor + carry
            parts[index] = (product % PART).toInt()
            carry = product / PART
        }
        if (carry > 0) append(carry.toInt())
    }

    /** Doubles it [times] times. */
    fun double(times: Int) {
        var rest = times
        while (rest > 0) {
            val step = minOf(rest, DOUBLINGS)
            multiply(1 shl step)
            rest -= step
        }
    }

    fun add(other: NaturalNumber) {
        var carry = 0
        var index = 0
        while (index < maxOf(size, other.size) || carry > 0) {
            if (index == size) append(0)
            val sum = parts[index] + carry + (if (index < other.size) other.parts[index] else 0)
            parts[index++] = sum % PART.toInt()
            carry = sum / PART.toInt()
        }
    }

    /** Subtracts [other], which is not larger. */
    fun subtract(other: NaturalNumber) {
        var borrow = 0
        for (index in 0 until size) {
            val difference = parts[index] - borrow - (if (index < other.size) other.parts[index] else 0)
            borrow = if (difference < 0) 1 else 0
            parts[index] = if (difference < 0) difference + PART.toInt() else difference
        }
        while (size > 0 && parts[size - 1] == 0) size--
    }

    override fun compareTo(other: NaturalNumber): Int {
        if (size != other.size) return size.compareTo(other.size)
        for (index in size - 1 downTo 0) {
            if (parts[index] != other.parts[index]) return parts[index].compareTo(other.parts[index])
        }
        return 0
    }

    private companion object {
        const val PART = 1_000_000_000L
        const val DOUBLINGS = 29
        const val INITIAL_PARTS = 8
    }
}
