package robotran.ui.screen

import androidx.compose.ui.unit.dp
import robotran.learning.WorldGallery
import robotran.ui.world.SheetRoom
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

class StagePlanTest {
    @Test
    fun `beside the messages the paper of each world stays nearly as large as alone`() {
        for (entry in WorldGallery.worlds) {
            val world = entry.plainWorld
            for ((width, height) in AREAS) {
                val alone = SheetRoom.of(world, width.dp, height.dp).scale
                for (volume in MessageVolume.entries) {
                    val plan = StagePlan.of(world, width.dp, height.dp, 1f, volume)
                    val room = when (plan.side) {
                        MessageSide.BELOW -> SheetRoom.of(world, width.dp, height.dp - plan.extent)
                        MessageSide.BESIDE -> SheetRoom.of(world, width.dp - plan.extent, height.dp)
                    }
                    val described = "${entry.name} on $width x $height with $volume: $plan, ${room.scale / alone}"
                    assertTrue(room.scale / alone >= LEAST.getValue(volume), described)
                }
            }
        }
    }

    @Test
    fun `the messages never get more than half of an area, whatever the size of the text`() {
        for (entry in WorldGallery.worlds) {
            for ((width, height) in AREAS) {
                for (scale in listOf(0.85f, 1f, 1.5f, 2f)) {
                    val plan = StagePlan.of(entry.plainWorld, width.dp, height.dp, scale, MessageVolume.ASSIGNMENT)
                    val side = if (plan.side == MessageSide.BELOW) height else width
                    assertTrue(plan.extent <= side.dp / 2, "${entry.name} on $width x $height at $scale: $plan")
                }
            }
        }
    }

    @Test
    fun `on an upright phone they are below the sheet, on one held across beside it`() {
        val world = WorldGallery.worlds.first { it.name == "maze" }.plainWorld
        val sides = listOf(412 to 660, 891 to 260).map { (width, height) ->
            StagePlan.of(world, width.dp, height.dp, 1f, MessageVolume.TASK).side
        }
        assertEquals(listOf(MessageSide.BELOW, MessageSide.BESIDE), sides)
    }

    private companion object {
        /** Areas beside the program on a phone both ways, a tablet both ways and a laptop. */
        val AREAS = listOf(412 to 660, 891 to 260, 724 to 590, 820 to 460, 888 to 590)

        /** The size of the paper, as a part of what it would have alone. */
        val LEAST = mapOf(MessageVolume.NOTICES to 0.7f, MessageVolume.TASK to 0.7f, MessageVolume.ASSIGNMENT to 0.6f)
    }
}
