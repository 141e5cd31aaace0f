package robotran.uikit

/** The icons of run controls, which are heavier than others. */
object RunIcons {
    val PLAY = icon(shapes = listOf("M6 3L21 12L6 21"))
    val PAUSE = icon(shapes = listOf("M5 4L10 4L10 20L5 20", "M14 4L19 4L19 20L14 20"))
    val STOP = icon(shapes = listOf("M4 4L20 4L20 20L4 20"))
    val STEP = icon(shapes = listOf("M4 4L14 12L4 20", "M16 4L20 4L20 20L16 20"))
    val PREVIOUS = icon(shapes = listOf("M19 5L9 12L19 19", "M5 5L8 5L8 19L5 19"))
    val NEXT = icon(shapes = listOf("M5 5L15 12L5 19", "M16 5L19 5L19 19L16 19"))
    val DOWN = icon(listOf("M6 9L12 15L18 9"))
    val UP = icon(listOf("M6 15L12 9L18 15"))
    val CLOSE = icon(listOf("M6 6L18 18", "M18 6L6 18"))
    val DONE = icon(listOf("M4 13L10 19L20 6"))
    val OPEN = icon(listOf("M12 4L18 6L20 12L18 18L12 20L6 18L4 12L6 6L12 4"))
    val MORE = icon(listOf("M12 5L12 19", "M5 12L19 12"))
    val LESS = icon(listOf("M5 12L19 12"))

    /** Two panes side by side. */
    val TWO = icon(listOf("M3 5L21 5L21 19L3 19L3 5", "M12 5L12 19"))

    /** Two sliders. */
    val SETTINGS = icon(listOf("M3 7L21 7", "M3 17L21 17"), listOf("M13 4L18 4L18 10L13 10", "M6 14L11 14L11 20L6 20"))

    private fun icon(lines: List<String> = emptyList(), shapes: List<String> = emptyList()) =
        Icon.of(lines, shapes, width = 2.6f)
}
