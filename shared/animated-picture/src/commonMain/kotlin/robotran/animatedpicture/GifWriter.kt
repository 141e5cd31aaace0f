package robotran.animatedpicture

/**
 * Writes an animated GIF (GIF89a) that repeats for ever. Of each frame it stores the rectangle that differs from the
 * frame before, and in it only what differs. A frame that does not differ makes the one before last longer.
 */
internal class GifWriter(private val width: Int, private val height: Int, private val palette: Palette) {
    private val sink = ByteSink()
    private val encoder = LzwEncoder(sink)
    private val tableBits = bitsFor(palette.colours.size + 1)

    /** The index that leaves a pixel as before. */
    private val same = palette.colours.size
    private val before = IntArray(width * height)
    private val indices = ByteArray(width * height)
    private var waiting: ChangedArea? = null
    private var waitingDelay = 0
    private var isFirst = true

    init {
        sink.text("GIF89a")
        sink.short(width)
        sink.short(height)
        sink.byte(GLOBAL_TABLE or FULL_RESOLUTION or (tableBits - 1))
        sink.byte(0)
        sink.byte(0)
        for (index in 0..<(1 shl tableBits)) {
            val colour = palette.colours.getOrElse(index) { 0 }
            sink.byte(red(colour))
            sink.byte(green(colour))
            sink.byte(blue(colour))
        }
        sink.block(REPEAT, REPEAT.size)
    }

    /** Bytes so far, without the frame that waits for its delay. */
    val size: Int get() = sink.size

    /** Adds the frame [pixels], shown for [delay] hundredths of a second. */
    fun add(pixels: IntArray, delay: Int) {
        val area = if (isFirst) ChangedArea(0, 0, width, height) else changedArea(before, pixels, width)
        if (area == null) {
            waitingDelay += delay
            return
        }
        writeWaiting()
        keep(pixels, area)
        isFirst = false
        waiting = area
        waitingDelay = delay
    }

    /** The file. Nothing may be added afterwards. */
    fun finish(): ByteArray {
        writeWaiting()
        sink.byte(TRAILER)
        return sink.toByteArray()
    }

    /** Stores the indices of [area] until its delay is known. */
    private fun keep(pixels: IntArray, area: ChangedArea) {
        var count = 0
        for (row in area.top..<area.bottom) {
            for (place in row * width + area.left..<row * width + area.right) {
                val pixel = pixels[place]
                indices[count++] = (if (!isFirst && pixel == before[place]) same else palette.indexOf(pixel)).toByte()
                before[place] = pixel
            }
        }
    }

    private fun writeWaiting() {
        val area = waiting ?: return
        // The longest delay that fits into the two bytes of the format.
        control(waitingDelay.coerceAtMost(MAX_DELAY))
        sink.byte(IMAGE)
        sink.short(area.left)
        sink.short(area.top)
        sink.short(area.width)
        sink.short(area.height)
        sink.byte(0)
        encoder.encode(indices, area.width * area.height, tableBits.coerceAtLeast(MIN_INDEX_BITS))
        waiting = null
    }

    private fun control(delay: Int) {
        sink.byte(EXTENSION)
        sink.byte(GRAPHIC_CONTROL)
        sink.byte(CONTROL_SIZE)
        sink.byte(LEAVE_IN_PLACE or WITH_TRANSPARENCY)
        sink.short(delay)
        sink.byte(same)
        sink.byte(0)
    }

    /** The parts of the format, by their names in GIF89a. */
    private companion object {
        const val GLOBAL_TABLE = 0x80
        const val FULL_RESOLUTION = 0x70
        const val EXTENSION = 0x21
        const val GRAPHIC_CONTROL = 0xF9
        const val CONTROL_SIZE = 4
        const val LEAVE_IN_PLACE = 1 shl 2
        const val WITH_TRANSPARENCY = 1
        const val IMAGE = 0x2C
        const val TRAILER = 0x3B
        const val MAX_DELAY = 0xFFFF
        const val MIN_INDEX_BITS = 2

        /** Netscape's extension that repeats an animation; 0 times means for ever. */
        val REPEAT = byteArrayOf(0x21, 0xFF.toByte(), 11) + "NETSCAPE2.0".encodeToByteArray() +
            byteArrayOf(3, 1, 0, 0, 0)

        /** The bits that an index below [count] needs, at least 1. */
        fun bitsFor(count: Int): Int = (1..BITS_PER_BYTE).first { 1 shl it >= count }
    }
}
