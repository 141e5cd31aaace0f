package robotran.ui.poster

import robotran.simulation.state.SessionState
import robotran.ui.sheet.drawnBox
import robotran.world.World

/**
 * The part of the paper that a poster shows, in centimetres from the paper's upper left corner: what was drawn, with a
 * margin, and the robots near it. It has the ratio [aspect] of width to height, as far as the paper reaches. Without a
 * drawing it is the whole paper.
 */
internal fun cropOf(world: World, session: SessionState, aspect: Double): PosterArea {
    val paper = world.paper
    val drawn = drawnBox(session) ?: return PosterArea(0.0, 0.0, paper.width, paper.height)
    val margin = maxOf(LEAST_MARGIN, maxOf(drawn.width, drawn.height) * MARGIN_PART)
    val box = drawn.grown(margin)
    val wide = maxOf(box.width, LEAST_SIDE)
    val high = maxOf(box.height, LEAST_SIDE)
    val width = minOf(maxOf(wide, high * aspect), paper.width)
    val height = minOf(maxOf(high, wide / aspect), paper.height)
    val left = (box.left + box.right - width) / 2
    val bottom = (box.bottom + box.top - height) / 2
    return PosterArea(
        left.coerceIn(0.0, paper.width - width),
        (paper.height - bottom - height).coerceIn(0.0, paper.height - height),
        width,
        height,
    )
}

/** The part of the drawing's longer side that is free around it. */
private const val MARGIN_PART = 0.08

/** Centimetres: around the drawing, and across the whole. */
private const val LEAST_MARGIN = 2.0
private const val LEAST_SIDE = 20.0
