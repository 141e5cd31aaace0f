package robotran.uikit

import androidx.compose.ui.geometry.Offset

/** Button icons, as strokes in a unit square. */
object StrokeIcons {
    val UNDO: StrokeIcon = arrow(mirrored = false)
    val REDO: StrokeIcon = arrow(mirrored = true)

    /** A magnifying glass. */
    val FIND: StrokeIcon = ring(Offset(0.42f, 0.42f), 0.36f) + (Offset(0.68f, 0.68f) to Offset(1f, 1f))

    /** Three vertical dots. */
    val MORE: StrokeIcon = listOf(0.12f, 0.5f, 0.88f).map { Offset(0.5f, it) to Offset(0.5f, it + 0.01f) }

    /** An arrow down into a brick. */
    val SEND: StrokeIcon = listOf(
        Offset(0.5f, 0f) to Offset(0.5f, 0.58f),
        Offset(0.5f, 0.58f) to Offset(0.27f, 0.36f),
        Offset(0.5f, 0.58f) to Offset(0.73f, 0.36f),
        Offset(0.22f, 0.62f) to Offset(0.04f, 0.62f),
        Offset(0.04f, 0.62f) to Offset(0.04f, 1f),
        Offset(0.04f, 1f) to Offset(0.96f, 1f),
        Offset(0.96f, 1f) to Offset(0.96f, 0.62f),
        Offset(0.96f, 0.62f) to Offset(0.78f, 0.62f),
    )

    val UP: StrokeIcon = listOf(Offset(0.1f, 0.7f) to Offset(0.5f, 0.3f), Offset(0.5f, 0.3f) to Offset(0.9f, 0.7f))
    val DOWN: StrokeIcon = listOf(Offset(0.1f, 0.3f) to Offset(0.5f, 0.7f), Offset(0.5f, 0.7f) to Offset(0.9f, 0.3f))

    val CHECK: StrokeIcon =
        listOf(Offset(0.06f, 0.55f) to Offset(0.36f, 0.85f), Offset(0.36f, 0.85f) to Offset(0.94f, 0.2f))

    /** A key that points to the left, with a cross in it. */
    val ERASE: StrokeIcon = listOf(
        Offset(0f, 0.5f) to Offset(0.3f, 0.16f),
        Offset(0.3f, 0.16f) to Offset(1f, 0.16f),
        Offset(1f, 0.16f) to Offset(1f, 0.84f),
        Offset(1f, 0.84f) to Offset(0.3f, 0.84f),
        Offset(0.3f, 0.84f) to Offset(0f, 0.5f),
        Offset(0.5f, 0.36f) to Offset(0.78f, 0.64f),
        Offset(0.5f, 0.64f) to Offset(0.78f, 0.36f),
    )

    /** A curved arrow back to the left. */
    private fun arrow(mirrored: Boolean): StrokeIcon {
        val points = listOf(
            Offset(0.02f, 0.36f),
            Offset(0.6f, 0.36f),
            Offset(0.79f, 0.42f),
            Offset(0.93f, 0.55f),
            Offset(0.96f, 0.72f),
            Offset(0.88f, 0.88f),
        )
        val bow = points.zipWithNext()
        val head = listOf(Offset(0.02f, 0.36f) to Offset(0.3f, 0.1f), Offset(0.02f, 0.36f) to Offset(0.3f, 0.62f))
        return (bow + head).map { (from, to) -> if (mirrored) from.mirrored() to to.mirrored() else from to to }
    }

    private fun Offset.mirrored() = Offset(1 - x, y)

    private fun ring(middle: Offset, radius: Float): StrokeIcon {
        val half = radius * DIAGONAL
        val points = listOf(
            Offset(radius, 0f),
            Offset(half, half),
            Offset(0f, radius),
            Offset(-half, half),
            Offset(-radius, 0f),
            Offset(-half, -half),
            Offset(0f, -radius),
            Offset(half, -half),
            Offset(radius, 0f),
        ).map { it + middle }
        return points.zipWithNext()
    }

    private const val DIAGONAL = 0.7071f
}
