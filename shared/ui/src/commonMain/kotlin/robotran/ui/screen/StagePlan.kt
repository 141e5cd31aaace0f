package robotran.ui.screen

import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp
import robotran.ui.parts.ScreenLayout
import robotran.ui.sheet.marginOf
import robotran.ui.world.SheetRoom
import robotran.world.World

/** Where the messages about a world stand. They never cover its sheet. */
internal enum class MessageSide { BELOW, BESIDE }

/** How much there may be to say about a world. */
internal enum class MessageVolume {
    /** Notices, and what the brick cannot show. */
    NOTICES,

    /** Also a task, or what came of it. */
    TASK,

    /** Also the text, the goals and the tries of an assignment. */
    ASSIGNMENT,
}

/**
 * How the sheet and its messages share an area: so that the paper is as large as it can be. It depends on nothing that
 * changes during a run, so nothing moves.
 *
 * @property extent the height of the messages below the sheet, or their width beside it.
 */
internal data class StagePlan(val side: MessageSide, val extent: Dp) {
    companion object {
        /** The plan for an area of [width] by [height] with the font scale [textScale]. */
        fun of(world: World, width: Dp, height: Dp, textScale: Float, volume: MessageVolume): StagePlan {
            val scale = textScale.coerceAtLeast(1f)
            // With larger text more of a message scrolls, so that the sheet keeps its room.
            val least = minOf(leastHeight(volume) * ScreenLayout.widthScale(scale), height * MOST)
            val narrow = LEAST_WIDTH * scale
            val below = SheetRoom.of(world, width, height - least)
            val beside = SheetRoom.of(world, width - narrow, height)
            return if (narrow > width * MOST_BESIDE || below.scale >= beside.scale * NEARLY) {
                val sheet = if (below.isUpright) height else below.scale * high(world) + below.aside.bottom
                StagePlan(MessageSide.BELOW, (height - sheet).coerceIn(least, maxOf(least, height * MOST)))
            } else {
                val sheet = if (beside.isUpright) beside.scale * wide(world) + beside.aside.left else width
                StagePlan(
                    MessageSide.BESIDE,
                    (width - sheet).coerceIn(
                        narrow,
                        maxOf(
                            narrow,
                            minOf(
                                MAX_WIDTH * scale,
                                width * MOST,
                            ),
                        ),
                    ),
                )
            }
        }

        private fun leastHeight(volume: MessageVolume): Dp = when (volume) {
            MessageVolume.NOTICES -> NOTICES
            MessageVolume.TASK -> TASK
            MessageVolume.ASSIGNMENT -> ASSIGNMENT
        }

        private fun high(world: World): Float = (world.paper.height + 2 * marginOf(world.paper)).toFloat()

        private fun wide(world: World): Float = (world.paper.width + 2 * marginOf(world.paper)).toFloat()

        /** The messages get at most this part, so that the sheet has at least as much as they. */
        private const val MOST = 0.45f
        private const val MOST_BESIDE = 0.5f

        /** Below the sheet there is more room for sentences, so that it may be a little smaller for it. */
        private const val NEARLY = 0.95f

        /** At the default font size: a notice of two lines; a task or an outcome with its button. */
        private val NOTICES = 80.dp
        private val TASK = 164.dp
        private val ASSIGNMENT = 200.dp

        /** For words of ten letters, and for lines that are still read with ease. */
        private val LEAST_WIDTH = 206.dp
        private val MAX_WIDTH = 400.dp
    }
}
