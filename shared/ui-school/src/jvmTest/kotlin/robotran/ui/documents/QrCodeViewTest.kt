package robotran.ui.documents

import androidx.compose.ui.graphics.toAwtImage
import androidx.compose.ui.graphics.toComposeImageBitmap
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.onNodeWithTag
import com.google.zxing.BinaryBitmap
import com.google.zxing.DecodeHintType
import com.google.zxing.RGBLuminanceSource
import com.google.zxing.common.HybridBinarizer
import com.google.zxing.qrcode.QRCodeReader
import org.jetbrains.skia.Image
import robotran.ui.RobotranApp
import robotran.ui.school.tags.DocumentTags
import robotran.ui.screen.onEventThread
import robotran.ui.screen.onPhone
import robotran.ui.screen.pass
import robotran.ui.screen.sceneOf
import robotran.workshop.Workshop
import robotran.workshop.documents.Machine
import robotran.workshop.event.DocumentEvent
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.SettingsEvent
import robotran.workshop.state.DocumentDialog
import kotlin.random.Random
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertNotNull

@OptIn(ExperimentalTestApi::class)
class QrCodeViewTest {
    @Test
    fun `a camera reads the link in the code that is drawn, by day and by night`() {
        for (dark in listOf(false, true)) {
            val workshop = Machine().window()
            workshop.handle(
                ProgramEvent.ProgramEdited("pen down\nrepeat 3 times\n  forward 20\n  turn left 120 degrees\nend\n"),
            )
            workshop.handle(DocumentEvent.LinkRequested)
            val link = assertNotNull((workshop.state.document.dialog as DocumentDialog.SharingLink).link)
            assertEquals(link, readCode(photograph(workshop, dark)))
            workshop.close()
        }
    }

    @Test
    fun `a link that is too long for a camera says so`() = onPhone { workshop ->
        val random = Random(7)
        val noise = (1..300).joinToString("\n") { "// ${random.nextLong().toString(36)}" }
        workshop.handle(SettingsEvent.SettingsChanged(workshop.state.settings.copy(site = "https://school.example/")))
        workshop.handle(ProgramEvent.ProgramEdited(noise))
        workshop.handle(DocumentEvent.LinkRequested)
        pass(200)
        onNodeWithTag(DocumentTags.QR_TOO_LONG).assertExists()
        onNodeWithTag(DocumentTags.QR_CODE).assertDoesNotExist()
        onNodeWithTag(DocumentTags.LINK_COPY).assertExists()
    }

    private fun photograph(workshop: Workshop, dark: Boolean): Image {
        var picture: Image? = null
        onEventThread {
            val scene = sceneOf(800, 1400) { RobotranApp(workshop, dark) }
            try {
                scene.render()
                picture = scene.render(nanoTime = 1_000_000_000)
            } finally {
                scene.close()
            }
        }
        return checkNotNull(picture)
    }

    private fun readCode(picture: Image): String {
        val image = picture.toComposeImageBitmap().toAwtImage()
        val pixels = image.getRGB(0, 0, image.width, image.height, null, 0, image.width)
        val bitmap = BinaryBitmap(HybridBinarizer(RGBLuminanceSource(image.width, image.height, pixels)))
        return QRCodeReader().decode(bitmap, mapOf(DecodeHintType.TRY_HARDER to true)).text
    }
}
