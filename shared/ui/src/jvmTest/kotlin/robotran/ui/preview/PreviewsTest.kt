package robotran.ui.preview

import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.wrapContentSize
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.test.ExperimentalTestApi
import robotran.ui.screen.pixelsOf
import robotran.ui.screen.undrawnTest
import kotlin.test.Test
import kotlin.test.assertTrue

class PreviewsTest {
    private val previews: Map<String, @Composable () -> Unit> = mapOf(
        "brick" to { BrickFrontPreview() },
        "brick strip" to { BrickStripPreview() },
        "brick hint" to { BrickHintPreview() },
        "run bar" to { RunBarReadyPreview() },
        "run bar while running" to { RunBarRunningPreview() },
        "run bar with an error" to { RunBarErrorPreview() },
        "narrow run bar" to { RunBarNarrowPreview() },
        "variables" to { VariablesPreview() },
        "task and goals" to { TaskAndGoalsPreview() },
        "program" to { RobolangProgramPreview() },
        "program with an error" to { ProgramWithErrorPreview() },
        "translation" to { TranslationPreview() },
        "world" to { WorldPanePreview() },
        "world editor" to { WorldEditPanePreview() },
        "top strip" to { TopStripPreview() },
        "notice" to { NoticePreview() },
        "error notice" to { ErrorNoticePreview() },
        "tutorial" to { TutorialPreview() },
        "worlds" to { WorldGalleryPreview() },
        "examples" to { ExamplesPreview() },
        "help" to { HelpPreview() },
        "welcome page" to { WelcomePreview() },
        "settings" to { SettingsPreview() },
        "sending" to { SendingPreview() },
        "sending that failed" to { SendingFailedPreview() },
        "pictures of sending" to { SendPicturesPreview() },
    )

    @Test
    fun `every preview draws its component in both themes`() {
        for ((name, preview) in previews) assertTrue(coloursOf(preview) > MIN_COLOURS, "The preview \"$name\" is empty")
    }

    /** The number of different colours in the picture of [preview]. */
    @OptIn(ExperimentalTestApi::class)
    private fun coloursOf(preview: @Composable () -> Unit): Int {
        var colours = 0
        undrawnTest(WIDTH, HEIGHT) {
            mainClock.autoAdvance = false
            setContent { Box(Modifier.testTag("preview").wrapContentSize(Alignment.TopStart)) { preview() } }
            repeat(FRAMES) { mainClock.advanceTimeByFrame() }
            waitForIdle()
            val pixels = pixelsOf("preview")
            colours = (0 until pixels.width step 2).flatMapTo(HashSet()) { x ->
                (0 until pixels.height step 2).map { y -> pixels[x, y] }
            }.size
        }
        return colours
    }

    private companion object {
        const val WIDTH = 1_100
        const val HEIGHT = 1_300
        const val FRAMES = 10

        /** The backgrounds of two themes and of an empty window. */
        const val MIN_COLOURS = 4
    }
}
