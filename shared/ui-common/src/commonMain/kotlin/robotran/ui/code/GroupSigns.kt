package robotran.ui.code

import robotran.robolang.words.BlockGroup
import robotran.uikit.*

/** The sign of each group, so that groups differ by more than colour. */
object GroupSigns {
    fun of(group: BlockGroup): Icon = when (group) {
        BlockGroup.DRIVE -> DRIVE
        BlockGroup.PEN -> PEN
        BlockGroup.SENSE -> SENSE
        BlockGroup.CONTROL -> CONTROL
        BlockGroup.NUMBERS -> NUMBERS
        BlockGroup.LISTS -> LISTS
        BlockGroup.OWN_COMMANDS -> OWN_COMMANDS
        BlockGroup.SHOW_AND_SOUND -> SHOW_AND_SOUND
    }

    /** An arrow forward. */
    private val DRIVE = Icon.strokes("M12 20V5", "M6 11L12 5L18 11")

    /** A pencil. */
    private val PEN = Icon.strokes("M5 19L7 14L17 4L20 7L10 17L5 19", "M14 7L17 10")

    /** An eye. */
    private val SENSE = Icon.strokes("M3 12L8 7H16L21 12L16 17H8L3 12", "M11 11H13V13H11V11")

    /** A loop. */
    private val CONTROL = Icon.strokes("M6 9H16L20 13L16 17H8L4 13V11", "M9 6L6 9L9 12")

    /** Plus and minus. */
    private val NUMBERS = Icon.strokes("M8 4V12", "M4 8H12", "M13 17H20")

    /** Lines one below the other. */
    private val LISTS = Icon.strokes("M9 6H20", "M9 12H20", "M9 18H20", "M4 6H5", "M4 12H5", "M4 18H5")

    /** A flag: a command of the pupil's own. */
    private val OWN_COMMANDS = Icon.strokes("M6 21V4", "M6 5H18L15 9L18 13H6")

    /** A sheet of paper with a folded corner. */
    val NOTE = Icon.strokes("M5 4H19V14L14 20H5V4", "M19 14H14V20", "M9 9H15")

    /** An exclamation mark in a triangle. */
    val MISTAKE = Icon.strokes("M12 4L22 20H2L12 4", "M12 10V14", "M12 17V17.2")

    /** A display with two digits. */
    private val SHOW_AND_SOUND = Icon.strokes("M3 6H21V18H3V6", "M8 9V15", "M13 9H16V12H13V15H16")
}
