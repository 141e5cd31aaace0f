package robotran.qrcode

import kotlin.math.abs

/** The modules of a code during its construction: first the function patterns, then the data, then the mask. */
internal class QrModules private constructor(
    private val version: QrVersion,
    private val dark: BooleanArray,
    private val isFrame: BooleanArray,
) {
    private val size = version.size

    constructor(version: QrVersion) : this(
        version,
        BooleanArray(version.size * version.size),
        BooleanArray(version.size * version.size),
    ) {
        drawFrame()
    }

    fun copy() = QrModules(version, dark.copyOf(), isFrame)

    fun darkModules(): BooleanArray = dark

    /** Places [codewords] outside the function patterns: up and down in pairs of columns, from the right. */
    fun fill(codewords: List<Int>) {
        var bit = 0
        var upwards = true
        for (right in size - 1 downTo 1 step 2) {
            // Skips the column of the timing pattern.
            val column = if (right <= TIMING) right - 1 else right
            for (step in 0..<size) {
                val row = if (upwards) size - 1 - step else step
                for (beside in 0..1) {
                    val place = row * size + column - beside
                    if (isFrame[place] || bit >= codewords.size * 8) continue
                    dark[place] = codewords[bit / 8] shr (7 - bit % 8) and 1 == 1
                    bit++
                }
            }
            upwards = !upwards
        }
    }

    /** Applies [mask] to the data, and writes the mask number. */
    fun mask(mask: QrMask) {
        for (row in 0..<size) {
            for (column in 0..<size) {
                val place = row * size + column
                if (!isFrame[place] && mask.turns(column, row)) dark[place] = !dark[place]
            }
        }
        drawFormat(mask.number)
    }

    /** The penalty score of the mask; lower is easier to read. */
    fun penalty(): Int {
        val lines = (0..<size).flatMap { line ->
            listOf(BooleanArray(size) { dark[line * size + it] }, BooleanArray(size) { dark[it * size + line] })
        }
        val squares = (0..<size - 1).sumOf { row ->
            (0..<size - 1).count { column ->
                val first = isDark(column, row)
                first == isDark(column + 1, row) && first == isDark(column, row + 1) &&
                    first == isDark(column + 1, row + 1)
            }
        }
        val balance = abs(dark.count { it } * 20 - dark.size * 10) / dark.size
        return lines.sumOf(::penaltyOf) + squares * SQUARE + balance * UNBALANCED
    }

    private fun penaltyOf(line: BooleanArray): Int {
        var sum = 0
        var run = 0
        for (place in line.indices) {
            run = if (place > 0 && line[place] == line[place - 1]) run + 1 else 1
            if (run == LONG_RUN) sum += LONG_RUN_PENALTY
            if (run > LONG_RUN) sum++
        }
        val text = line.joinToString("") { if (it) "1" else "0" }
        return sum +
            FINDERS.sumOf { finder -> (0..text.length - finder.length).count { text.startsWith(finder, it) } } *
            FINDER_PENALTY
    }

    private fun isDark(column: Int, row: Int) = dark[row * size + column]

    private fun drawFrame() {
        for (place in 0..<size) {
            frame(TIMING, place, place % 2 == 0)
            frame(place, TIMING, place % 2 == 0)
        }
        for ((column, row) in listOf(3 to 3, size - 4 to 3, 3 to size - 4)) drawFinder(column, row)
        val places = version.alignments
        for (column in places) {
            for (row in places) {
                val isAtFinder = (column == TIMING && row == TIMING) || (column == TIMING && row == places.last()) ||
                    (column == places.last() && row == TIMING)
                if (!isAtFinder) drawRings(column, row, 2) { it != 1 }
            }
        }
        drawFormat(0)
        if (version.number >= QrVersion.FIRST_WITH_NUMBER) drawVersion()
    }

    private fun drawFinder(column: Int, row: Int) = drawRings(column, row, 4) { it != 2 && it != 4 }

    /** Draws square rings around a centre, out to radius [max], dark where [isRingDark]; clips them at the edge. */
    private fun drawRings(column: Int, row: Int, max: Int, isRingDark: (Int) -> Boolean) {
        for (down in -max..max) {
            for (across in -max..max) {
                if (column + across !in 0..<size || row + down !in 0..<size) continue
                frame(column + across, row + down, isRingDark(maxOf(abs(across), abs(down))))
            }
        }
    }

    /** Writes the error correction level and the mask number, twice. */
    private fun drawFormat(mask: Int) {
        val data = LEVEL_L shl 3 or mask
        val bits = (data shl 10 or remainder(data, 10, FORMAT_GENERATOR)) xor FORMAT_MASK
        val around = (0..5).map { 8 to it } + listOf(8 to 7, 8 to 8, 7 to 8) + (5 downTo 0).map { it to 8 }
        val apart = (1..8).map { size - it to 8 } + (7 downTo 1).map { 8 to size - it }
        for (bit in 0..14) {
            val isDark = bits shr bit and 1 == 1
            for ((column, row) in listOf(around[bit], apart[bit])) frame(column, row, isDark)
        }
        frame(8, size - 8, true)
    }

    private fun drawVersion() {
        val bits = version.number shl 12 or remainder(version.number, 12, VERSION_GENERATOR)
        for (bit in 0..17) {
            val isDark = bits shr bit and 1 == 1
            frame(size - 11 + bit % 3, bit / 3, isDark)
            frame(bit / 3, size - 11 + bit % 3, isDark)
        }
    }

    private fun remainder(data: Int, bits: Int, generator: Int): Int {
        var rest = data
        repeat(bits) { rest = rest shl 1 xor (rest ushr (bits - 1)) * generator }
        return rest
    }

    private fun frame(column: Int, row: Int, isDark: Boolean) {
        dark[row * size + column] = isDark
        isFrame[row * size + column] = true
    }

    private companion object {
        /** The row and the column of the timing pattern. */
        const val TIMING = 6
        const val LEVEL_L = 1
        const val FORMAT_GENERATOR = 0x537
        const val FORMAT_MASK = 0x5412
        const val VERSION_GENERATOR = 0x1F25
        const val LONG_RUN = 5
        const val LONG_RUN_PENALTY = 3
        const val SQUARE = 3
        const val FINDER_PENALTY = 40
        const val UNBALANCED = 10
        val FINDERS = listOf("10111010000", "00001011101")
    }
}
