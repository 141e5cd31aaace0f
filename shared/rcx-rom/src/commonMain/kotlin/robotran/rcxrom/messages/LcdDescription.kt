package robotran.rcxrom.messages

import robotran.rcxrom.display.LcdGlass

/**
 * Everything there is to see on the display, for somebody who cannot see it: its [LcdGlass.text] and the names of the
 * [LcdGlass.iconsBesideText], such as `9.0 0, standing man`; empty on a clear display.
 */
fun LcdGlass.describe(messages: BrickMessages = EnglishBrickMessages): String =
    (listOf(text) + iconsBesideText.map(messages::icon)).filter { it.isNotEmpty() }.joinToString()
