package robotran.animatedpicture

/** Counts how often each colour occurs: a hash table of plain integers, since frames have millions of pixels. */
internal class ColourCounts {
    private var keys = IntArray(INITIAL) { NONE }
    private var counts = IntArray(INITIAL)
    private var size = 0

    /** Adds the colours of [pixels]; once there are [MAX], further ones count as the nearest coarser colour. */
    fun add(pixels: IntArray) {
        for (pixel in pixels) {
            val colour = pixel and RGB
            val place = placeOf(colour)
            when {
                keys[place] == colour -> counts[place]++
                size < MAX -> insert(place, colour)
                else -> addCoarse(colour and COARSE)
            }
        }
    }

    /** All colours with their counts, the most frequent first; equally frequent ones by their value. */
    fun sorted(): List<CountedColour> = keys.indices.filter { keys[it] != NONE }
        .map { CountedColour(keys[it], counts[it]) }
        .sortedWith(compareByDescending(CountedColour::count).thenBy(CountedColour::colour))

    private fun addCoarse(colour: Int) {
        val place = placeOf(colour)
        if (keys[place] == colour) counts[place]++ else insert(place, colour)
    }

    private fun insert(index: Int, colour: Int) {
        keys[index] = colour
        counts[index] = 1
        size++
        if (size * 2 > keys.size) grow()
    }

    private fun grow() {
        val oldKeys = keys
        val oldCounts = counts
        keys = IntArray(oldKeys.size * 2) { NONE }
        counts = IntArray(keys.size)
        for (index in oldKeys.indices) {
            if (oldKeys[index] == NONE) continue
            val place = placeOf(oldKeys[index])
            keys[place] = oldKeys[index]
            counts[place] = oldCounts[index]
        }
    }

    /** Where [colour] is or would be inserted. */
    private fun placeOf(colour: Int): Int {
        var place = (colour * HASH_FACTOR ushr HASH_SHIFT) and (keys.size - 1)
        while (keys[place] != NONE && keys[place] != colour) place = (place + 1) and (keys.size - 1)
        return place
    }

    private companion object {
        const val INITIAL = 1_024

        /** More than a drawn sheet has. */
        const val MAX = 32_768
        const val NONE = -1

        /** Four bits per channel. */
        const val COARSE = 0xF0F0F0

        /** Fibonacci hashing (Knuth, The Art of Computer Programming 3, 6.4). */
        const val HASH_FACTOR = -1640531527
        const val HASH_SHIFT = 8
    }
}

/** @property colour `0xRRGGBB`. */
internal data class CountedColour(val colour: Int, val count: Int)

/** The channels of a colour without the highest byte. */
internal const val RGB = 0xFFFFFF
