package robotran.rcxrom.display

import robotran.rcxrom.memory.RcxMemory

/** Writes text to the LCD like josx `TextLCD`: directly into the LCD's memory. The next refresh makes it visible. */
object TextLcd {
    /** Number of characters on the display. */
    const val CHARACTERS = 5

    /** Writes the first five characters of [text] from the left and clears the remaining digits. */
    fun print(text: String, memory: RcxMemory) {
        repeat(CHARACTERS) { place ->
            val mask = text.getOrNull(place)?.let(LcdGlyphs::maskOf) ?: 0
            LcdLayout.digitSegments[CHARACTERS - 1 - place].forEachIndexed { bit, segment ->
                segment.set(
                    memory,
                    mask shr bit and 1 == 1,
                )
            }
        }
    }
}
