package robotran.lejoslinker.image

import robotran.lejoslinker.config.ByteOrder

/** Collects the bytes of an image. */
internal class ByteSink(size: Int, private val order: ByteOrder) {
    val bytes = ByteArray(size)
    var position = 0
        private set

    fun byte(value: Int) {
        bytes[position++] = value.toByte()
    }

    fun short(value: Int) {
        val high = value shr BYTE_BITS
        byte(if (order == ByteOrder.BIG_ENDIAN) high else value)
        byte(if (order == ByteOrder.BIG_ENDIAN) value else high)
    }

    fun all(added: ByteArray) {
        added.copyInto(bytes, position)
        position += added.size
    }

    private companion object {
        const val BYTE_BITS = 8
    }
}
