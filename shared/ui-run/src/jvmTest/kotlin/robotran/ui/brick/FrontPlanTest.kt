package robotran.ui.brick

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.geometry.Size
import robotran.brick.kind.BrickKind
import robotran.ui.brick.front.FrontPart
import robotran.ui.brick.front.FrontPlan
import robotran.ui.brick.nxt.NxtPlan
import robotran.ui.brick.rcx.RcxPlan
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/** The plan of every kind of brick. */
class FrontPlanTest {
    private val pictured = mapOf(
        BrickKind.RCX to listOf(RcxPlan.INFRARED_WINDOW),
        BrickKind.NXT to NxtPlan.SPEAKER,
    )

    @Test
    fun `no two things on a front lie over each other, and none beside it`() {
        for (kind in BrickKind.entries) {
            val places = kind.face.plan.parts.map { it.place } + pictured[kind].orEmpty()
            val all = Rect(Offset.Zero, Size(FrontPlan.WIDTH, FrontPlan.HEIGHT))
            for ((number, place) in places.withIndex()) {
                assertEquals(emptyList(), places.drop(number + 1).filter { place.overlaps(it) }, "$kind: over $place")
                assertEquals(place, place.intersect(all), "$kind")
            }
        }
    }

    @Test
    fun `each brick has its buttons and ports, large enough for a finger, and one display`() {
        for (kind in BrickKind.entries) {
            val parts = kind.face.plan.parts
            val buttons = parts.filterIsInstance<FrontPart.Button>()
            assertEquals(kind.buttons.toSet(), buttons.map { it.button }.toSet())
            for (button in buttons) {
                assertTrue(
                    button.place.minDimension * FrontPlan.MIN_UNIT >= 48f,
                    "${button.button}",
                )
            }
            assertEquals(
                (0..<kind.inputPorts).toList(),
                parts.filterIsInstance<FrontPart.Input>().map {
                    it.index
                }.sorted(),
            )
            val outputs = parts.filterIsInstance<FrontPart.Output>().map { it.index }
            assertEquals(outputs.indices.toList(), outputs)
            assertEquals(1, parts.count { it is FrontPart.Display })
        }
    }
}
