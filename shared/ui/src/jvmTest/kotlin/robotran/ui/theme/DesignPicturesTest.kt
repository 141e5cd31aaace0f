package robotran.ui.theme

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.height
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.size
import androidx.compose.foundation.layout.width
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.clip
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.toArgb
import androidx.compose.ui.text.TextStyle
import androidx.compose.ui.unit.TextUnit
import androidx.compose.ui.unit.dp
import org.jetbrains.skia.Bitmap
import org.jetbrains.skia.EncodedImageFormat
import org.jetbrains.skia.Image
import robotran.ui.empty.EmptyPicture
import robotran.ui.empty.EmptyPictureView
import robotran.ui.screen.sceneOf
import robotran.uikit.*
import robotran.uikit.preview.ControlsPreview
import java.io.File
import kotlin.test.Test
import kotlin.test.assertEquals

/**
 * The pictures of docs/design.md, drawn from the tokens. `-PrecordPictures` writes them; otherwise the recorded ones
 * must still show the colours of the tokens.
 */
class DesignPicturesTest {
    @Test
    fun `the page shows the colours of each theme`() {
        val themes = listOf(
            "light" to RobotranColours.LIGHT,
            "dark" to RobotranColours.DARK,
            "high contrast" to RobotranColours.HIGH_CONTRAST,
            "high contrast, dark" to RobotranColours.HIGH_CONTRAST_DARK,
        )
        val picture = draw("design-colours", WIDTH, HEADER + ROW * rolesOf(RobotranColours.LIGHT).size) {
            Row(Modifier.fillMaxSize().background(RobotranColours.LIGHT.pane)) {
                Column(Modifier.width(NAMES.dp)) {
                    Cell(HEADER) { }
                    for ((name, _) in rolesOf(RobotranColours.LIGHT)) Cell(ROW) { Words(name, RobotranColours.LIGHT) }
                }
                for ((name, colours) in themes) {
                    Column(Modifier.width(COLUMN.dp).background(colours.pane)) {
                        Cell(HEADER) { Words(name, colours) }
                        for ((_, colour) in rolesOf(colours)) {
                            Cell(ROW) {
                                Box(Modifier.size(SWATCH.dp, (ROW - 8).dp).clip(Shapes.SMALL).background(colour))
                            }
                        }
                    }
                }
            }
        }
        themes.forEachIndexed { column, (name, colours) ->
            rolesOf(colours).forEachIndexed { row, (role, colour) ->
                val x = NAMES + column * COLUMN + SWATCH / 2
                val seen = picture.getColor(x, HEADER + row * ROW + ROW / 2)
                assertEquals(colour.toArgb(), seen, "$role in $name: record docs/pictures/design-colours.png again")
            }
        }
    }

    @Test
    fun `the page shows the type`() {
        val sizes = listOf(
            "DISPLAY" to TextSizes.DISPLAY,
            "TITLE" to TextSizes.TITLE,
            "HEADING" to TextSizes.HEADING,
            "LEAD" to TextSizes.LEAD,
            "BODY" to TextSizes.BODY,
            "COMPACT" to TextSizes.COMPACT,
            "SMALL" to TextSizes.SMALL,
            "SIGN" to TextSizes.SIGN,
        )
        draw("design-type", WIDTH, sizes.size * LINE) {
            Column(Modifier.fillMaxSize().background(RobotranColours.LIGHT.pane)) {
                for ((name, size) in sizes) {
                    Cell(LINE) {
                        Words(
                            "$name ${size.value.toInt()}   You write a program, and a robot draws.",
                            RobotranColours.LIGHT,
                            size,
                        )
                    }
                }
            }
        }
    }

    @Test
    fun `the page shows the pictures of empty places`() {
        draw("design-empty", WIDTH, 2 * EMPTY) {
            Column(Modifier.fillMaxSize().background(RobotranColours.LIGHT.pane)) {
                for (row in EmptyPicture.entries.chunked(4)) {
                    Row(Modifier.height(EMPTY.dp), Arrangement.spacedBy(40.dp), Alignment.CenterVertically) {
                        for (each in row) EmptyPictureView(each, Modifier.padding(start = 16.dp))
                    }
                }
            }
        }
    }

    @Test
    fun `the page shows every control in two themes`() {
        draw("design-components", WIDTH, COMPONENTS) { ControlsPreview() }
    }

    /** Every role with an opaque colour. */
    private fun rolesOf(colours: RobotranColours): List<Pair<String, Color>> = with(colours) {
        listOf(
            "desk" to desk,
            "paper" to paper,
            "pane" to pane,
            "onPane" to onPane,
            "quiet" to quiet,
            "line" to line,
            "runningLine" to runningLine,
            "invite" to invite,
            "good" to good,
            "goodPane" to goodPane,
            "error" to error,
            "errorPane" to errorPane,
            "focus" to focus,
            "YELLOW" to RobotranColours.YELLOW,
            "RUN_GREEN" to RobotranColours.RUN_GREEN,
            "ON_OFF_RED" to RobotranColours.ON_OFF_RED,
        )
    }

    @Composable
    private fun Cell(height: Int, content: @Composable () -> Unit) =
        Box(Modifier.height(height.dp).padding(start = 8.dp), Alignment.CenterStart) { content() }

    @Composable
    private fun Words(text: String, colours: RobotranColours, size: TextUnit = TextSizes.SMALL) =
        Text(text, style = TextStyle(fontSize = size), color = colours.onPane, maxLines = 1)

    /** Draws [content] of this size as docs/pictures/[name].png, and returns what is recorded there. */
    private fun draw(name: String, width: Int, height: Int, content: @Composable () -> Unit): Bitmap {
        val scene = sceneOf(width, height) { RobotranTheme(dark = false, content = content) }
        val bytes = try {
            checkNotNull(scene.render().encodeToData(EncodedImageFormat.PNG)).bytes
        } finally {
            scene.close()
        }
        val file = File("../../docs/pictures/$name.png")
        if (System.getProperty("robotran.recordPictures") != null) file.writeBytes(bytes)
        val recorded = Image.makeFromEncoded(file.readBytes())
        assertEquals(width to height, recorded.width to recorded.height, "Record $file again.")
        return Bitmap.makeFromImage(recorded)
    }

    /** In pixels. */
    private companion object {
        const val NAMES = 120
        const val COLUMN = 160
        const val WIDTH = NAMES + 4 * COLUMN
        const val HEADER = 36
        const val ROW = 32
        const val SWATCH = 136
        const val LINE = 44
        const val EMPTY = 100
        const val COMPONENTS = 1_120
    }
}
