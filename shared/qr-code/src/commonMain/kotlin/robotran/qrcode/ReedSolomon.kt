package robotran.qrcode

/** Error correction with [checks] bytes per block, over the field of 256 elements with the polynomial of QR codes. */
internal class ReedSolomon(private val checks: Int) {
    /** The coefficients of the generator polynomial, highest power first, without the leading 1. */
    private val generator = IntArray(checks).also { factors ->
        factors[checks - 1] = 1
        var root = 1
        repeat(checks) {
            for (place in factors.indices) {
                factors[place] = multiply(factors[place], root) xor (factors.getOrNull(place + 1) ?: 0)
            }
            root = multiply(root, 2)
        }
    }

    /** The error correction bytes for [data]: the remainder of its division by the generator. */
    fun checksOf(data: List<Int>): List<Int> {
        val rest = ArrayDeque(List(checks) { 0 })
        for (byte in data) {
            val factor = byte xor rest.removeFirst()
            rest.addLast(0)
            for (place in generator.indices) rest[place] = rest[place] xor multiply(generator[place], factor)
        }
        return rest.toList()
    }

    private fun multiply(first: Int, second: Int): Int {
        var product = 0
        for (place in 7 downTo 0) {
            product = product shl 1 xor (product ushr 7) * FIELD
            product = product xor (second ushr place and 1) * first
        }
        return product
    }

    private companion object {
        /** x^8 + x^4 + x^3 + x^2 + 1. */
        const val FIELD = 0x11D
    }
}
