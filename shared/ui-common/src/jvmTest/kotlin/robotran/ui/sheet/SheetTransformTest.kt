package robotran.ui.sheet

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Size
import kotlin.test.Test
import kotlin.test.assertEquals

class SheetTransformTest {
    @Test
    fun `the lower left corner is the origin and y goes up`() {
        val transform = SheetTransform.fitting(100.0, 50.0, 0.0, Size(1000f, 500f))
        assertEquals(Offset(0f, 500f), transform.toPixels(0.0, 0.0))
        assertEquals(Offset(1000f, 0f), transform.toPixels(100.0, 50.0))
        assertEquals(Offset(200f, 400f), transform.toPixels(20.0, 10.0))
    }

    @Test
    fun `the paper is as large as it fits with its margin, in the middle`() {
        val transform = SheetTransform.fitting(100.0, 50.0, 10.0, Size(1200f, 2000f))
        assertEquals(10f, transform.pixelsPerCentimetre)
        assertEquals(Offset(100f, 750f), transform.paper.topLeft)
        assertEquals(Size(1000f, 500f), transform.paper.size)
    }

    @Test
    fun `an area without any size does no harm`() {
        assertEquals(0f, SheetTransform.fitting(100.0, 50.0, 2.0, Size.Zero).pixelsPerCentimetre)
    }
}
