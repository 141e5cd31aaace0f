package robotran.rcxrom.messages

import robotran.rcxrom.display.LcdGlass

/**
 * The display's content for screen readers: its [LcdGlass.text] and the names of the [LcdGlass.iconsBesideText], such
 * as `9.0 0, standing man`; empty on a clear display.
 */
fun LcdGlass.describe(messages: BrickMessages): String =
    (listOf(text) + iconsBesideText.map(messages::icon)).filter { it.isNotEmpty() }.joinToString()
