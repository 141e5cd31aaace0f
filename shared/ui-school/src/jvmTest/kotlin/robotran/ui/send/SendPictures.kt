package robotran.ui.send

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.padding
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.unit.dp
import org.jetbrains.skia.Image
import robotran.language.Language
import robotran.ui.golden.GoldenPicture
import robotran.ui.language.InLanguage
import robotran.ui.screen.keepAs
import robotran.ui.screen.onEventThread
import robotran.ui.screen.sceneOf
import robotran.ui.theme.RobotranTheme
import robotran.uikit.*
import robotran.workshop.state.AppTheme
import robotran.workshop.state.SendState
import robotran.workshop.state.SendStep
import robotran.workshop.state.Settings
import kotlin.test.Test

/** Pictures of the sheet that sends, for review. */
class SendPictures {
    @Test
    fun `every step can be photographed on a phone`() {
        for ((name, step) in SEND_STEPS) photograph(step, Screen.PHONE, Settings()).keepAs("send/phone-$name")
    }

    @Test
    fun `every step can be photographed on all screens, in all languages, dark, and with text twice as large`() {
        for (screen in Screen.entries) {
            for ((name, step) in SEND_STEPS.filterKeys { it in IMPORTANT || it in REVIEWED }) {
                for (language in Language.entries) {
                    val look = Settings(language = language, theme = AppTheme.DARK)
                    photograph(step, screen, look).keepAs("send/${screen.name.lowercase()}-${language.tag}-$name")
                    photograph(step, screen, look.copy(theme = AppTheme.LIGHT, textScale = 2f))
                        .keepAs("send/${screen.name.lowercase()}-${language.tag}-200-$name")
                }
            }
        }
    }
}

/** The most important steps of the sheet that sends, compared with references. */
class SendPicturesTest {
    @Test
    fun `the sheet looks as it did`() {
        for (screen in listOf(Screen.PHONE, Screen.TABLET)) {
            for (theme in listOf(AppTheme.LIGHT, AppTheme.DARK)) {
                for ((name, step) in SEND_STEPS.filterKeys { it in IMPORTANT }) {
                    val picture = photograph(step, screen, Settings(theme = theme))
                    GoldenPicture.check("send-$name-${screen.name.lowercase()}-${theme.name.lowercase()}", picture)
                }
            }
        }
    }
}

private fun photograph(step: SendStep, screen: Screen, settings: Settings): Image = onEventThread {
    val scene = sceneOf(screen.width, screen.height) {
        InLanguage(settings.language) {
            RobotranTheme(dark = false, settings) {
                Box(
                    Modifier.fillMaxSize().background(LocalRobotranColours.current.desk).padding(16.dp),
                    Alignment.Center,
                ) { SendCard(SendState("square.robo", step), onEvent = {}) }
            }
        }
    }
    try {
        scene.render()
        scene.render(nanoTime = SECOND)
    } finally {
        scene.close()
    }
}

private enum class Screen(val width: Int, val height: Int) {
    PHONE(411, 891),
    PHONE_ACROSS(891, 411),
    TABLET(1280, 800),
}

private val REVIEWED = setOf("slot-again", "needs-lego", "datalog", "error-full", "error-left", "lego-3-28")
private val IMPORTANT = setOf("choose", "sending", "needs-firmware", "firmware-lejos_3_0", "error-bricksilent", "done")
private const val SECOND = 1_000_000_000L
