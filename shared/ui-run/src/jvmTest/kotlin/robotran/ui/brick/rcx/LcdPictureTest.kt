package robotran.ui.brick.rcx

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.ImageBitmap
import androidx.compose.ui.graphics.Path
import androidx.compose.ui.graphics.drawscope.translate
import androidx.compose.ui.graphics.drawscope.withTransform
import androidx.compose.ui.graphics.toPixelMap
import robotran.rcxrom.display.LcdGlass
import robotran.rcxrom.display.LcdIcon
import robotran.ui.common.BrickColours
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

class LcdPictureTest {
    private val blank = photographLcd(LcdGlass.BLANK)

    private fun darkPixels(icon: LcdIcon) = darkPixels(photographLcd(glassOf(iconBits.getValue(icon))))

    /** The bounding box in units of the plan. */
    private fun Set<Offset>.bounds() = Rect(minOf { it.x }, minOf { it.y }, maxOf { it.x }, maxOf { it.y }).let {
        Rect(it.left / PIXELS, it.top / PIXELS, it.right / PIXELS, it.bottom / PIXELS)
    }

    @Test
    fun `a blank display shows nothing dark, only the faint ghosts of its segments`() {
        assertEquals(emptySet(), darkPixels(blank))
        val pixels = blank.toPixelMap()
        val ghost = pixels[((LcdPlan.MINUS.center.x) * PIXELS).toInt(), (LcdPlan.MINUS.center.y * PIXELS).toInt()]
        assertTrue(ghost != BrickColours.GLASS && ghost.green > BrickColours.GLASS.green * 0.85f)
    }

    @Test
    fun `every segment of the digits and every icon has its own place on the glass`() {
        val alone = LCD_BITS.toSet() - MEN_BITS
        assertEquals(35 + LcdIcon.entries.size - 2, highlighted.keys.count { it in alone })
        val men = listOf(darkPixels(LcdMen.body), darkPixels(LcdMen.standing), darkPixels(LcdMen.walking))
        val all = highlighted.filterKeys { it in alone }.values + men
        assertEquals(all.sumOf { it.size }, all.flatten().toSet().size, "some segments lie over others")
        assertTrue(all.all { it.size > 20 * PIXELS }, "some segment is hardly to be seen")
    }

    private fun darkPixels(shape: Path) = darkPixels(
        photograph((LcdPlan.WIDTH * PIXELS).toInt(), (LcdPlan.HEIGHT * PIXELS).toInt()) {
            withTransform({
                scale(PIXELS.toFloat(), PIXELS.toFloat(), Offset.Zero)
            }) { drawPath(shape, BrickColours.SEGMENT) }
        },
    )

    @Test
    fun `with everything lit every segment is dark`() {
        val everything = darkPixels(photographLcd(glassOf(LCD_BITS)))
        assertTrue(highlighted.values.all { everything.containsAll(it) })
        assertTrue(
            everything.containsAll(darkPixels(LcdMen.standing) + darkPixels(LcdMen.walking) + darkPixels(LcdMen.body)),
        )
        savePicture(photographLcd(glassOf(LCD_BITS)), "lcd-everything")
    }

    @Test
    fun `a segment is dark exactly when its bit is set`() {
        for (pair in highlighted.keys.chunked(2)) {
            val expected = pair.flatMap { highlighted.getValue(it) }.toSet()
            assertEquals(expected, darkPixels(photographLcd(glassOf(pair))))
        }
    }

    @Test
    fun `the two men share the body and differ in their legs`() {
        val standing = darkPixels(LcdIcon.STANDING_MAN)
        val walking = darkPixels(LcdIcon.WALKING_MAN)
        assertEquals(darkPixels(LcdMen.body), standing intersect walking)
        assertTrue(walking.bounds().width > standing.bounds().width)
    }

    @Test
    fun `everything is where an RCX has it`() {
        val place = (LcdIcon.entries - LcdIcon.STANDING_MAN - LcdIcon.WALKING_MAN).associateWith {
            darkPixels(it).bounds().center
        }
        val digits = LcdPlan.DIGITS

        fun row(vararg icons: LcdIcon) = icons.map(place::getValue).zipWithNext { left, right ->
            assertTrue(left.x < right.x, "${icons.toList()}")
        }
        row(
            LcdIcon.SENSOR_1_VIEW,
            LcdIcon.DOT_1,
            LcdIcon.DOT_2,
            LcdIcon.DOT_3,
            LcdIcon.DOT_4,
            LcdIcon.DOT_5,
            LcdIcon.SENSOR_2_VIEW,
        )
        row(LcdIcon.SENSOR_2_VIEW, LcdIcon.LOW_BATTERY, LcdIcon.SENSOR_3_VIEW)
        row(
            LcdIcon.MOTOR_A_BACKWARD,
            LcdIcon.MOTOR_A_VIEW,
            LcdIcon.MOTOR_A_FORWARD,
            LcdIcon.MOTOR_B_BACKWARD,
            LcdIcon.MOTOR_B_VIEW,
            LcdIcon.MOTOR_B_FORWARD,
            LcdIcon.MOTOR_C_BACKWARD,
            LcdIcon.MOTOR_C_VIEW,
            LcdIcon.MOTOR_C_FORWARD,
        )
        row(
            LcdIcon.INFRARED_SHORT,
            LcdIcon.MINUS,
            LcdIcon.POINT_3,
            LcdIcon.POINT_2,
            LcdIcon.POINT_1,
            LcdIcon.DATALOG_TOP_RIGHT,
        )
        row(LcdIcon.DATALOG_TOP_LEFT, LcdIcon.DATALOG_TOP_RIGHT)
        row(LcdIcon.DATALOG_BOTTOM_LEFT, LcdIcon.DATALOG_BOTTOM_RIGHT)
        assertTrue(place.getValue(LcdIcon.DATALOG_TOP_LEFT).y < place.getValue(LcdIcon.DATALOG_BOTTOM_LEFT).y)
        assertTrue(place.getValue(LcdIcon.INFRARED_LONG).y < place.getValue(LcdIcon.INFRARED_SHORT).y)
        for ((icon, middle) in place) {
            if ("SENSOR" in icon.name || "DOT_" in icon.name || icon == LcdIcon.LOW_BATTERY) {
                assertTrue(middle.y < digits[0].top, "$icon")
            }
            if ("MOTOR" in icon.name) assertTrue(middle.y > digits[0].bottom, "$icon")
        }
        val man = darkPixels(LcdIcon.WALKING_MAN).bounds()
        assertTrue(man.left > digits[1].right && man.right < digits[0].left)
    }

    @Test
    fun `every printable character is drawn as its glyph, and photographed`() {
        val characters = (' '..'~').toList()
        val rows = characters.chunked(CHARACTERS).map { it.joinToString("") }
        for (text in rows) {
            val glass = glassOf(text)
            val dark = darkPixels(photographLcd(glass))
            LcdPlan.DIGITS.forEachIndexed { position, digit ->
                val segments = (0..6).filter { glass.digit(position) shr it and 1 == 1 }
                val inDigit = dark.filter { digit.contains(Offset(it.x / PIXELS, it.y / PIXELS)) }
                assertEquals(segments.isEmpty(), inDigit.isEmpty(), "$text at $position")
            }
        }
        val (width, height) = LcdPlan.WIDTH.toInt() + GAP to LcdPlan.HEIGHT.toInt() + GAP
        val sheet = photograph(width * COLUMNS, height * ((rows.size + COLUMNS - 1) / COLUMNS)) {
            drawRect(Color.White)
            rows.forEachIndexed { number, text ->
                translate(number % COLUMNS * width + GAP / 2f, number / COLUMNS * height + GAP / 2f) {
                    withTransform({
                        scale(LcdPlan.WIDTH / size.width, LcdPlan.WIDTH / size.width, Offset.Zero)
                    }) { drawLcd(glassOf(text)) }
                }
            }
        }
        savePicture(sheet, "lcd-glyphs")
        assertTrue(darkPixels(sheet).size > 10_000)
    }

    private companion object {
        val MEN_BITS = setOf(0, 1, 2, 3)
        const val CHARACTERS = 5
        const val COLUMNS = 4
        const val GAP = 16

        /** The bits of the display's memory that light a segment on their own, with their pictures. */
        val highlighted: Map<Int, Set<Offset>> =
            LCD_BITS.associateWith { darkPixels(photographLcd(glassOf(listOf(it)))) }.filterValues { it.isNotEmpty() }

        /** The bits of each icon's segments. */
        val iconBits: Map<LcdIcon, List<Int>> = LcdIcon.entries.associateWith { icon ->
            when (icon) {
                LcdIcon.STANDING_MAN -> listOf(1, 2)
                LcdIcon.WALKING_MAN -> listOf(0, 1, 3)
                else -> LCD_BITS.filter { icon in glassOf(listOf(it)).litIcons }
            }
        }

        /** The positions where [picture] is as dark as a lit segment. */
        fun darkPixels(picture: ImageBitmap): Set<Offset> = picture.toPixelMap().let { pixels ->
            buildSet {
                for (x in 0..<picture.width) {
                    for (y in 0..<picture.height) {
                        if (pixels[x, y] == BrickColours.SEGMENT) {
                            add(Offset(x.toFloat(), y.toFloat()))
                        }
                    }
                }
            }
        }
    }
}
