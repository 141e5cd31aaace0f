package robotran.ui.brick.rcx

import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.Canvas
import androidx.compose.ui.graphics.ImageBitmap
import androidx.compose.ui.graphics.asSkiaBitmap
import androidx.compose.ui.graphics.drawscope.CanvasDrawScope
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.unit.Density
import androidx.compose.ui.unit.LayoutDirection
import org.jetbrains.skia.EncodedImageFormat
import org.jetbrains.skia.Image
import robotran.rcxrom.display.LcdGlass
import robotran.rcxrom.display.TextLcd
import robotran.rcxrom.memory.RcxMemory
import java.io.File

/** [PIXELS] per unit of the [LcdPlan]. */
internal fun photographLcd(glass: LcdGlass): ImageBitmap =
    photograph((LcdPlan.WIDTH * PIXELS).toInt(), (LcdPlan.HEIGHT * PIXELS).toInt()) { drawLcd(glass) }

internal const val PIXELS = 2

internal fun photograph(width: Int, height: Int, draw: DrawScope.() -> Unit): ImageBitmap {
    val bitmap = ImageBitmap(width, height)
    CanvasDrawScope().draw(
        Density(1f),
        LayoutDirection.Ltr,
        Canvas(bitmap),
        Size(width.toFloat(), height.toFloat()),
        draw,
    )
    return bitmap
}

/** Writes [picture] to build/pictures for review. */
internal fun savePicture(picture: ImageBitmap, name: String) {
    val folder = File(System.getProperty("robotran.pictures")).apply { mkdirs() }
    val bytes = Image.makeFromBitmap(picture.asSkiaBitmap()).use {
        checkNotNull(it.encodeToData(EncodedImageFormat.PNG)).bytes
    }
    File(folder, "$name.png").writeBytes(bytes)
}

/** The glass with only these bits of the LCD's memory set, counted from bit 0 of its first byte. */
internal fun glassOf(bits: Iterable<Int>): LcdGlass {
    val memory = RcxMemory()
    bits.forEach { memory.setBits(FIRST_ADDRESS + it / Byte.SIZE_BITS, 1 shl it % Byte.SIZE_BITS, on = true) }
    return LcdGlass.of(memory)
}

/** The glass with [text] as josx writes it. */
internal fun glassOf(text: String): LcdGlass = LcdGlass.of(RcxMemory().also { TextLcd.print(text, it) })

/** The bits of the nine bytes of the display. */
internal val LCD_BITS = 0..<9 * Byte.SIZE_BITS

private const val FIRST_ADDRESS = 0xEF43
