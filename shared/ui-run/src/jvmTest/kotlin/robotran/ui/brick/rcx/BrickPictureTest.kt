package robotran.ui.brick.rcx

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.graphics.toPixelMap
import robotran.language.Language
import robotran.rcxrom.RcxBrick
import robotran.rcxrom.messages.BrickMessages
import robotran.ui.brick.front.FrontPlan
import robotran.ui.brick.front.Signal
import robotran.ui.brick.front.drawFront
import robotran.ui.common.BrickColours
import robotran.world.RobotPlacement
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

class BrickPictureTest {
    @Test
    fun `only the infrared window changes while the brick sends, and two lamps shine in it`() {
        val (width, height) = FrontPlan.WIDTH.toInt() to FrontPlan.HEIGHT.toInt()
        val dark = photograph(width, height) { drawFront(RcxPlan.front, emptySet()) }.toPixelMap()
        val sending = photograph(width, height) { drawFront(RcxPlan.front, setOf(Signal.SENDING)) }.toPixelMap()
        val window = RcxPlan.INFRARED_WINDOW.inflate(1f)
        for (x in 0..<width) {
            for (y in 0..<height) {
                if (!window.contains(
                        Offset(x.toFloat(), y.toFloat()),
                    )
                ) {
                    assertEquals(dark[x, y], sending[x, y])
                }
            }
        }
        for (x in RcxPlan.INFRARED_LAMPS) assertEquals(BrickColours.INFRARED_LAMP, sending[x.toInt(), 38])
    }

    @Test
    fun `a bumper that is pushed in lights its port, a light sensor in the dark does not`() {
        val brick = RcxBrick(emptyList(), messages = BrickMessages.of(Language.ENGLISH))
        assertEquals(
            listOf(false, false, false),
            brick.state.sensors.map {
                PluggedSensor.of(RobotPlacement.PENBOT_PORTS[it.port - 1]).isPressed(it)
            },
        )
        repeat(3) { brick.setRawSensorValue(it, raw = 0) }
        repeat(4) { brick.tick() }
        assertEquals(
            listOf(true, false, true),
            brick.state.sensors.map {
                PluggedSensor.of(RobotPlacement.PENBOT_PORTS[it.port - 1]).isPressed(it)
            },
        )
    }

    @Test
    fun `the display can be drawn at any size`() {
        for (width in listOf(40, 120, 1_000)) {
            val picture =
                photograph(width, (width * LcdPlan.HEIGHT / LcdPlan.WIDTH).toInt()) { drawLcd(glassOf("8888")) }
            val pixels = picture.toPixelMap()
            val dark = (0..<picture.width).sumOf { x -> (0..<picture.height).count { y -> pixels[x, y].green < 0.4f } }
            assertTrue(dark > width * picture.height / 25, "$dark dark pixels at a width of $width")
        }
    }
}
