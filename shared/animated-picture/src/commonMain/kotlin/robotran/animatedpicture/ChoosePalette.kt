package robotran.animatedpicture

/**
 * The palette for [colours], the most frequent first: the frequent ones as they are, so that paper and ink keep their
 * exact colours, and the rest, such as smoothed edges and light, by median cut (Heckbert 1982).
 */
internal fun paletteFor(colours: List<CountedColour>): Palette {
    if (colours.size <= Palette.MAX_COLOURS) return Palette(colours.map { it.colour }.toIntArray())
    val exact = colours.take(MAX_EXACT)
    val boxes = mutableListOf(ColourBox(colours.drop(MAX_EXACT)))
    while (exact.size + boxes.size < Palette.MAX_COLOURS) {
        val widest = boxes.filter { it.colours.size > 1 }.maxByOrNull { it.weight } ?: break
        boxes -= widest
        boxes += widest.split()
    }
    return Palette((exact.map { it.colour } + boxes.map { it.mean() }).distinct().toIntArray())
}

/** Colours that become one colour of the palette. */
private class ColourBox(val colours: List<CountedColour>) {
    private val longest: (Int) -> Int = CHANNELS.maxBy { channel -> spread(channel) }

    /** How much is gained by splitting: many pixels, or colours that differ much. */
    val weight: Double = colours.sumOf { it.count.toDouble() } * spread(longest) * spread(longest)

    /** Two boxes with about half of the pixels each. */
    fun split(): List<ColourBox> {
        val sorted = colours.sortedWith(compareBy<CountedColour> { longest(it.colour) }.thenBy { it.colour })
        val half = sorted.sumOf { it.count.toLong() } / 2
        var passed = 0L
        var cut = 0
        while (cut < sorted.size - 1 && (cut == 0 || passed + sorted[cut].count <= half)) passed += sorted[cut++].count
        return listOf(ColourBox(sorted.take(cut)), ColourBox(sorted.drop(cut)))
    }

    fun mean(): Int {
        val pixels = colours.sumOf { it.count.toLong() }

        fun mean(channel: (Int) -> Int) =
            ((colours.sumOf { channel(it.colour).toLong() * it.count } + pixels / 2) / pixels).toInt()
        return (mean(::red) shl RED_SHIFT) or (mean(::green) shl GREEN_SHIFT) or mean(::blue)
    }

    private fun spread(channel: (Int) -> Int) =
        colours.maxOf { channel(it.colour) } - colours.minOf { channel(it.colour) }
}

private val CHANNELS = listOf(::green, ::red, ::blue)

/** The colours of a sheet's paper, ink, walls, robots and blocks are fewer. */
private const val MAX_EXACT = 64
