package robotran.ui.screen

import kotlinx.coroutines.runBlocking
import org.jetbrains.skia.EncodedImageFormat
import robotran.language.Language
import robotran.ui.RobotranApp
import robotran.workshop.event.SettingsEvent
import robotran.workshop.openWorkshop
import java.io.File
import kotlin.test.Test

/** Pictures of the page as a part of another one. */
class EmbedPictures {
    @Test
    fun `a page's part on every screen, in the dark, and in German with large text`() {
        val folder = File(System.getProperty("robotran.pictures")).apply { mkdirs() }
        for ((width, height) in listOf(800 to 500, 320 to 420, 1280 to 800, 411 to 891)) {
            photograph(File(folder, "embed-$width-light.png"), width, height, dark = false, textScale = 1f)
            photograph(File(folder, "embed-$width-dark.png"), width, height, dark = true, textScale = 1f)
            photograph(File(folder, "embed-$width-german-200.png"), width, height, dark = false, textScale = 2f)
        }
    }

    private fun photograph(file: File, width: Int, height: Int, dark: Boolean, textScale: Float) = onEventThread {
        val workshop = runBlocking { openWorkshop() }
        val settings = workshop.state.settings
        if (textScale > 1f) {
            workshop.handle(
                SettingsEvent.SettingsChanged(settings.copy(language = Language.GERMAN, textScale = textScale)),
            )
        }
        val scene = sceneOf(width, height) { RobotranApp(workshop, dark, embedded = true) }
        try {
            scene.render()
            val bytes = checkNotNull(scene.render(nanoTime = 1_000_000_000).encodeToData(EncodedImageFormat.PNG)).bytes
            file.writeBytes(bytes)
        } finally {
            scene.close()
            workshop.handle(SettingsEvent.SettingsChanged(settings))
            workshop.close()
        }
    }
}
