package robotran.learning.drawing

import io.kotest.core.spec.style.StringSpec
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.ints.shouldBeLessThanOrEqual
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.bind
import io.kotest.property.arbitrary.choice
import io.kotest.property.arbitrary.constant
import io.kotest.property.arbitrary.element
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.list
import io.kotest.property.arbitrary.map
import io.kotest.property.arbitrary.string
import io.kotest.property.checkAll
import robotran.simulation.state.InkStroke
import robotran.world.geometry.Point
import robotran.world.geometry.Pose

class RunDrawingProperties :
    StringSpec({
        "whatever a run leaves is kept in little room, and read as it was written" {
            checkAll(400, runs) { (robots, blocks, strokes) ->
                val drawing = drawingOf(robots, blocks, strokes)
                drawing.text.length shouldBeLessThanOrEqual RunDrawing.MAX_CHARACTERS
                drawing.robots.size shouldBe robots.size
                readRunDrawing(drawing.text) shouldBe drawing
            }
        }

        "a drawing of few lines is kept whole, each corner within a millimetre" {
            checkAll(400, Arb.list(strokes(2..2), 0..20), poses) { strokes, pose ->
                val drawing = drawingOf(listOf(pose), emptyList(), strokes)
                drawing.lines.size shouldBe strokes.size
                for ((line, stroke) in drawing.lines.zip(strokes)) {
                    for (end in stroke.points) line.points.any { isNear(it, end) } shouldBe true
                }
            }
        }

        "what is no drawing is none, and harms nobody" {
            var read = 0
            checkAll(2_000, texts) { text ->
                val drawing = readRunDrawing(text)
                if (drawing != null) {
                    read++
                    readRunDrawing(drawing.text) shouldBe drawing
                }
            }
            read shouldBeGreaterThan 0
        }

        "what is too long, too far away or half a line is no drawing" {
            val tooLong = "robot 0 0 0" + "\nink 0 1 1".repeat(RunDrawing.MAX_CHARACTERS)
            for (text in listOf(
                "",
                tooLong,
                "robot 0 0 999",
                "robot 999999 0 0",
                "robot 0 0 0\nink 0 5",
                "ink 0 5 5",
            )) {
                readRunDrawing(text) shouldBe null
            }
        }
    })

private fun isNear(point: Point, other: Point) = maxOf(point.x - other.x, other.x - point.x) <= NEAR &&
    maxOf(point.y - other.y, other.y - point.y) <= NEAR

private fun places(range: IntRange) = Arb.bind(Arb.int(range), Arb.int(range)) { x, y -> Point(x / PARTS, y / PARTS) }

private fun strokes(corners: IntRange) =
    Arb.bind(Arb.list(places(0..7_400), corners), Arb.int(0..7)) { points, robot -> InkStroke(points, robot) }

private val poses = Arb.bind(places(-200_000..200_000), Arb.int(-6_600..6_660)) { at, heading ->
    Pose(at.x, at.y, heading / PARTS)
}

private val runs = Arb.bind(
    Arb.list(poses, 1..8),
    Arb.list(poses, 0..100),
    Arb.choice(Arb.list(strokes(1..3), 0..300), Arb.list(strokes(1..400), 0..6)),
    ::Triple,
)

private val words = Arb.choice(
    Arb.element("robot", "block", "ink", "", "-", "1e9", "99999999999", "\n"),
    Arb.int(-30_000..30_000).map { "$it" },
    Arb.string(0..3),
)

private val texts = Arb.choice(
    Arb.string(0..200),
    Arb.list(words, 0..12).map { it.joinToString(" ") },
    Arb.bind(Arb.constant("robot 10 20 30\nink 0 40 50 "), Arb.list(words, 0..4)) { start, more ->
        start + more.joinToString(" ")
    },
)

/** In centimetres: half a millimetre of rounding on top of that of simplifying, which leaves ends as they are. */
private const val NEAR = 0.051

/** Of a centimetre or a degree, so that numbers need rounding. */
private const val PARTS = 37.0
