package robotran.rcxrom.display

import robotran.rcxrom.memory.RcxMemory

/**
 * Text on the LCD, as josx `TextLCD` writes it: straight into the LCD's memory. It becomes visible at the next refresh.
 */
object TextLcd {
    /** How many characters there is room for. */
    const val CHARACTERS = 5

    /** Writes the first five characters of [text], from the left; places that are left over go dark. */
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
